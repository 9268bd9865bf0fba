#include "model/drive/bad_items.h"

#include "messages/files.h"
#include "messages/general.h"

namespace remount::drive {

Message message_of(const Error& error) {
  return error.where().empty() ? error.what_happened() : say::of_file(error.where(), error.what_happened());
}

Message BadItems::after(Message sentence) const {
  if (count_ == 0) return sentence;
  return Message::sequence({std::move(sentence), say::file_first_problem(first_)});
}

void BadItems::report(std::vector<Finding>& findings, const std::string& code, const std::string& where,
                      Message (*left_out)(Count count, Message first)) const {
  if (count_ > 0) findings.push_back(make_finding(Severity::Warning, code, where, left_out(count_, first_)));
}

}  // namespace remount::drive
