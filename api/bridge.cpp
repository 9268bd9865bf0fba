#include "api/bridge.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "algorithms/messages/catalogue.h"
#include "algorithms/messages/render.h"
#include "messages/programs.h"
#include "model/formats/poses/motion_pairs_file.h"
#include "remount/version.h"

namespace remount::api {
namespace {

constexpr remount::Language inner_language(Language language) {
  return language == Language::Chinese ? remount::Language::Chinese : remount::Language::English;
}

struct CodeEntry {
  ErrorCode outer;
  remount::ErrorCode inner;  ///< of what code of others throws
  std::string_view name;
};
/// In the order of ErrorCode. Of several with one inside the first is what comes from there.
constexpr CodeEntry kCodes[] = {
    {ErrorCode::Io, remount::ErrorCode::Io, "io"},
    {ErrorCode::Format, remount::ErrorCode::Format, "format"},
    {ErrorCode::Unsupported, remount::ErrorCode::Unsupported, "unsupported"},
    {ErrorCode::Contract, remount::ErrorCode::Contract, "contract"},
    {ErrorCode::Cancelled, remount::ErrorCode::Io, "cancelled"},
};
constexpr const CodeEntry& entry_of(ErrorCode code) { return kCodes[static_cast<std::size_t>(code)]; }
static_assert(std::ranges::all_of(kCodes, [](const CodeEntry& entry) { return &entry_of(entry.outer) == &entry; }));

ErrorCode outer_code(remount::ErrorCode code) { return std::ranges::find(kCodes, code, &CodeEntry::inner)->outer; }

}  // namespace

remount::ErrorCode inner_code(ErrorCode code) { return entry_of(code).inner; }

std::string_view version() { return REMOUNT_VERSION; }

Text::Text(std::string words)
    : message_(words.empty() ? nullptr : std::make_shared<const Message>(Message::verbatim(std::move(words)))) {}
Text::Text(const char* words) : Text(std::string(words)) {}
Text::Text(const Message& message) : message_(message.empty() ? nullptr : std::make_shared<const Message>(message)) {}

bool Text::empty() const { return !message_; }
std::string Text::in(Language language) const {
  return message_ ? render(*message_, inner_language(language)) : std::string();
}
std::string Text::code() const { return !message_ || message_->code() == kVerbatim ? std::string() : message_->code(); }
const Message& Text::message() const {
  static const Message kNothing;
  return message_ ? *message_ : kNothing;
}

std::string_view to_string(ErrorCode code) { return entry_of(code).name; }

Error::Error(ErrorCode code, std::string place, Text expectation)
    : std::runtime_error((place.empty() ? place : place + ": ") + expectation.english()),
      code_(code),
      place_(std::move(place)),
      expectation_(std::move(expectation)) {}

Error told(const remount::Error& error) {
  return {outer_code(error.code()), error.where(), Text(error.what_happened())};
}

Error cancelled_at(const std::string& where) { return {ErrorCode::Cancelled, where, Text(say::api_cancelled())}; }

Progress::Progress() : state_(std::make_shared<State>()) {}
Progress::Progress(Callback callback) : Progress() { state_->callback = std::move(callback); }
void Progress::cancel() const { state_->stop.request_stop(); }
bool Progress::cancelled() const { return state_->stop.stop_requested(); }

void Progress::State::tell(const ProgressUpdate& update) {
  const std::scoped_lock lock(mutex);
  if (failure) return;
  telling = std::this_thread::get_id();
  try {
    callback({update.stage == nullptr ? Text() : Text(update.stage()), update.done, update.total});
  } catch (...) {
    failure = std::current_exception();
    stop.request_stop();
  }
  telling = std::thread::id();
}

// Threads of such a call would wait for the callback, and the callback for them.
void Progress::refuse_within_callback() const {
  if (state_->telling.load() == std::this_thread::get_id())
    throw Error(ErrorCode::Contract, "progress", Text(say::api_progress_in_callback()));
}

void Progress::State::rethrow_failure() {
  std::exception_ptr thrown;
  {
    const std::scoped_lock lock(mutex);
    thrown = std::exchange(failure, nullptr);
  }
  if (thrown) std::rethrow_exception(thrown);
}

RigidTransform rigid_of_matrix(const Matrix4& a_from_b, const std::string& where) {
  if (a_from_b.row(3) != Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0))
    throw remount::Error(remount::ErrorCode::Format, where, say::api_last_row());
  return formats::motion_of_matrix(a_from_b.topRows<3>(), "[R t]", where);
}

std::vector<Text> texts_of(const std::vector<Message>& messages) {
  std::vector<Text> texts;
  for (const Message& message : messages) texts.emplace_back(message);
  return texts;
}

std::vector<Finding> findings_of(const std::vector<drive::Finding>& findings) {
  std::vector<Finding> out;
  for (const drive::Finding& finding : findings)
    out.push_back({static_cast<Severity>(finding.severity), finding.code, Text(finding.where.words()),
                   Text(finding.explanation)});
  return out;
}

}  // namespace remount::api
