// Finds a text among the reasons of many pairs, in the words of the window.
#pragma once

#include <QString>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace remount {

/// Reasons are few sentences with many numbers: a sentence is translated once, whatever its numbers, and where it may
/// hold the text only the numbers of each reason are compared. Upper and lower case are the same.
class ReasonMatch {
 public:
  explicit ReasonMatch(const QString& text);
  bool operator()(const std::string& reason);

 private:
  /// A place where a sentence holds the text but for its numbers: which of the reason's numbers stand there.
  using Place = std::vector<std::size_t>;
  struct Sentence {
    std::vector<Place> places;
    bool each_anew = false;  // its translation has numbers that are not the reason's
  };

  Sentence sentence_of(const std::string& reason) const;
  bool add_places(std::string_view marked, std::size_t count, std::vector<Place>& places) const;
  bool holds(const Place& place) const;

  QString text_, shape_;              // what is looked for; with one 0 for each number
  std::vector<std::string> numbers_;  // its numbers
  bool digit_first_, digit_last_;     // of the text: a longer number may go on there
  std::unordered_map<std::string, Sentence> sentences_;
  std::string reason_shape_;  // of the reason that is being looked at
  std::vector<std::string_view> reason_numbers_;
};

}  // namespace remount
