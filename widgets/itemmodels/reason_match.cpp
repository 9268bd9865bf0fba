#include "widgets/itemmodels/reason_match.h"

#include <algorithm>
#include <charconv>

#include "widgets/pair_reasons.h"

namespace remount {
namespace {

// Stand for the numbers of a reason while it is translated, so that they are found again in the translation.
constexpr std::size_t kFirstMark = 70000;

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

/// Every number becomes one 0 of the shape.
void take_apart(std::string_view text, std::string& shape, std::vector<std::string_view>& numbers) {
  shape.clear();
  numbers.clear();
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); at != end;) {
    const char* const number = std::find_if(at, end, is_digit);
    shape.append(at, number);
    if (number == end) return;
    at = std::find_if_not(number, end, is_digit);
    numbers.emplace_back(number, static_cast<std::size_t>(at - number));
    shape += '0';
  }
}

std::string marked(const std::string& shape) {
  std::string text;
  std::size_t mark = kFirstMark;
  for (const char letter : shape) {
    if (letter == '0')
      text += std::to_string(mark++);
    else
      text += letter;
  }
  return text;
}

}  // namespace

ReasonMatch::ReasonMatch(const QString& text) : text_(text) {
  const std::string wanted = text.toStdString();
  std::string shape;
  std::vector<std::string_view> numbers;
  take_apart(wanted, shape, numbers);
  shape_ = QString::fromStdString(shape);
  numbers_.assign(numbers.begin(), numbers.end());
  digit_first_ = !wanted.empty() && is_digit(wanted.front());
  digit_last_ = !wanted.empty() && is_digit(wanted.back());
}

/// Of a reason or its translation with marks for its `count` numbers; false where other numbers are among them.
bool ReasonMatch::add_places(std::string_view marked, std::size_t count, std::vector<Place>& places) const {
  std::string shape;
  std::vector<std::string_view> numbers;
  take_apart(marked, shape, numbers);
  Place all;
  for (const std::string_view number : numbers) {
    std::size_t mark = 0;
    std::from_chars(number.data(), number.data() + number.size(), mark);
    if (mark < kFirstMark || mark >= kFirstMark + count) return false;
    all.push_back(mark - kFirstMark);
  }
  const QString words = QString::fromStdString(shape);
  for (qsizetype at = words.indexOf(shape_, 0, Qt::CaseInsensitive); at >= 0;
       at = words.indexOf(shape_, at + 1, Qt::CaseInsensitive)) {
    const auto first = all.begin() + std::count(words.cbegin(), words.cbegin() + at, u'0');
    places.emplace_back(first, first + std::ssize(numbers_));
  }
  return true;
}

ReasonMatch::Sentence ReasonMatch::sentence_of(const std::string& reason) const {
  Sentence sentence;
  const std::string marks = marked(reason_shape_), words = reason_words(reason).toStdString(),
                    marked_words = reason_words(marks).toStdString();
  add_places(marks, reason_numbers_.size(), sentence.places);
  if (words == reason) return sentence;
  std::string shape, marked_shape;
  std::vector<std::string_view> numbers;
  take_apart(words, shape, numbers);
  take_apart(marked_words, marked_shape, numbers);
  const bool same = shape == marked_shape;
  sentence.each_anew = !same || !add_places(marked_words, reason_numbers_.size(), sentence.places);
  return sentence;
}

bool ReasonMatch::holds(const Place& place) const {
  for (std::size_t i = 0; i < place.size(); ++i) {
    const std::string& wanted = numbers_[i];
    const std::string_view number = reason_numbers_[place[i]];
    const bool goes_on_before = i == 0 && digit_first_, goes_on_after = i + 1 == place.size() && digit_last_;
    const bool same = goes_on_before && goes_on_after ? number.find(wanted) != std::string_view::npos
                      : goes_on_before                ? number.ends_with(wanted)
                      : goes_on_after                 ? number.starts_with(wanted)
                                                      : number == wanted;
    if (!same) return false;
  }
  return true;
}

bool ReasonMatch::operator()(const std::string& reason) {
  if (reason.empty()) return false;
  take_apart(reason, reason_shape_, reason_numbers_);
  auto found = sentences_.find(reason_shape_);
  if (found == sentences_.end()) found = sentences_.emplace(reason_shape_, sentence_of(reason)).first;
  const Sentence& sentence = found->second;
  if (std::any_of(sentence.places.begin(), sentence.places.end(), [&](const Place& place) { return holds(place); }))
    return true;
  return sentence.each_anew && reason_words(reason).contains(text_, Qt::CaseInsensitive);
}

}  // namespace remount
