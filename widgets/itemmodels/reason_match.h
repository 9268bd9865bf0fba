// Finds a text among the reasons of many pairs, in the words of the window.
#pragma once

#include <QString>
#include <string>
#include <unordered_map>

namespace remount {

/// Reasons are few sentences with many numbers: a sentence is translated once, whatever its numbers, and only those
/// that may hold the text are looked at as a whole. Upper and lower case are the same.
class ReasonMatch {
 public:
  explicit ReasonMatch(const QString& text);
  bool operator()(const std::string& reason);

 private:
  QString text_, shape_;                          // what is looked for; without its numbers
  bool number_ = false;                           // it has a number
  std::string digits_;                            // it is nothing else
  std::unordered_map<std::string, bool> shapes_;  // of reasons without their numbers: whether one may hold the text
  std::string buffer_;
};

}  // namespace remount
