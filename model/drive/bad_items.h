// What is wrong with single lines or files of a stream, as findings.
#pragma once

#include <string>
#include <vector>

#include "algorithms/core/error.h"
#include "model/drive/finding.h"

namespace remount::drive {

inline Finding make_finding(Severity severity, std::string code, Place where, Message explanation) {
  return {severity, std::move(code), std::move(where), std::move(explanation)};
}

/// Where it was and what happened, as one message.
Message message_of(const Error& error);

/// Collects what is wrong with single lines or files of a stream that is usable as a whole: one finding for all.
class BadItems {
 public:
  void add(const Error& error) {
    if (count_++ == 0) first_ = message_of(error);
  }
  void add(Message problem) {
    if (count_++ == 0) first_ = std::move(problem);
  }
  std::size_t count() const { return count_; }
  const Message& first() const { return first_; }
  /// A sentence, followed by the first problem where there is one.
  Message after(Message sentence) const;
  /// Adds nothing where there was nothing wrong. @param left_out says it of so many, and of the first problem
  void report(std::vector<Finding>& findings, const std::string& code, const std::string& where,
              Message (*left_out)(Count count, Message first)) const;

 private:
  std::size_t count_ = 0;
  Message first_;
};

}  // namespace remount::drive
