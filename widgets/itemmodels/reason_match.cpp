#include "widgets/itemmodels/reason_match.h"

#include <algorithm>

#include "widgets/pair_reasons.h"

namespace remount {
namespace {

/// Every number becomes one 0.
template <class Text, class Letter>
void without_numbers(const Text& text, Text& shape, Letter zero) {
  bool digit_before = false;
  for (const auto letter : text) {
    const bool digit = letter >= Letter('0') && letter <= Letter('9');
    if (!digit || !digit_before) shape += digit ? zero : letter;
    digit_before = digit;
  }
}

QString shape_of(const QString& text) {
  QString shape;
  without_numbers(text, shape, QChar(u'0'));
  return shape;
}

bool contains(const QString& words, const QString& text) { return words.contains(text, Qt::CaseInsensitive); }

}  // namespace

ReasonMatch::ReasonMatch(const QString& text) : text_(text), shape_(shape_of(text)) {
  const auto is_digit = [](QChar letter) { return letter >= u'0' && letter <= u'9'; };
  number_ = std::any_of(text.begin(), text.end(), is_digit);
  // The words of the window hold the numbers as the reason does: none need be made to find one.
  if (std::all_of(text.begin(), text.end(), [&](QChar letter) { return is_digit(letter) || letter == u'.'; }))
    digits_ = text.toStdString();
}

bool ReasonMatch::operator()(const std::string& reason) {
  if (reason.empty()) return false;
  if (!digits_.empty()) return reason.find(digits_) != std::string::npos;
  buffer_.clear();
  without_numbers(reason, buffer_, '0');
  auto found = shapes_.find(buffer_);
  if (found == shapes_.end()) {
    const bool may =
        contains(QString::fromStdString(buffer_), shape_) || contains(shape_of(reason_words(reason)), shape_);
    found = shapes_.emplace(buffer_, may).first;
  }
  if (!found->second || !number_) return found->second;
  return contains(QString::fromStdString(reason), text_) || contains(reason_words(reason), text_);
}

}  // namespace remount
