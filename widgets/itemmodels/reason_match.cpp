#include "widgets/itemmodels/reason_match.h"

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
  for (const QChar letter : text) number_ |= letter >= u'0' && letter <= u'9';
}

bool ReasonMatch::operator()(const std::string& reason) {
  if (reason.empty()) return false;
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
