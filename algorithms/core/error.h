// The exception for broken input and broken contracts.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "algorithms/messages/render.h"
#include "messages/general.h"

namespace remount {

enum class ErrorCode {
  Io,           ///< the operating system refused: missing file, no permission, disk full
  Format,       ///< the bytes are not what the format promises
  Unsupported,  ///< valid, but not something this product reads or does
  Contract,     ///< a caller broke a documented condition, or options are out of range
};

/// Broken input or a broken contract. Numerical outcomes (degenerate, not converged, cancelled)
/// are not errors: they are part of a result. Caught only at the edge of a job or of `main`.
class Error : public std::runtime_error {
 public:
  /// @param where file with line or byte ("scan.pcd:7", "oxts/data/0000000003.txt")
  /// @param what_happened what was found, what was expected, and what to do where that is known
  Error(ErrorCode code, std::string where, Message what_happened)
      : std::runtime_error((where.empty() ? where : where + ": ") + english(what_happened)),
        code_(code),
        where_(std::move(where)),
        what_happened_(std::move(what_happened)) {}

  ErrorCode code() const { return code_; }
  const std::string& where() const { return where_; }
  const Message& what_happened() const { return what_happened_; }
  /// What happened, and where.
  Message message() const { return where_.empty() ? what_happened_ : say::of_file(where_, what_happened_); }

 private:
  ErrorCode code_;
  std::string where_;
  Message what_happened_;
};

}  // namespace remount
