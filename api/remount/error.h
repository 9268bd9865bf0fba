// What every function throws for broken input and broken contracts. What the numbers do not allow is no error: the
// status of a result says it.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "remount/text.h"

namespace remount::api {

enum class ErrorCode {
  Io,           ///< the operating system refused: missing file, no permission, disk full
  Format,       ///< the bytes are not what the format promises
  Unsupported,  ///< valid, but not something that Remount reads or does
  Contract,     ///< a documented condition was broken, or a setting is out of range
  Cancelled,    ///< the caller's Progress was cancelled, and there is no result that could say so
};
std::string_view to_string(ErrorCode code);  ///< "io", "format", "unsupported", "contract", "cancelled"

/// Seen by whoever catches it, also where a program hides what it has.
class [[gnu::visibility("default")]] Error : public std::runtime_error {
 public:
  /// @param place file with line or byte ("scan.pcd:7"), or the name of what was given
  /// @param expectation what was found, what was expected, and what to do where that is known
  Error(ErrorCode code, std::string place, Text expectation);

  ErrorCode code() const { return code_; }
  const std::string& place() const { return place_; }
  const Text& expectation() const { return expectation_; }

 private:
  ErrorCode code_;
  std::string place_;
  Text expectation_;
};

}  // namespace remount::api
