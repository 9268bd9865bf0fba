// How much memory a piece of work takes.
#pragma once

#include <cstddef>

namespace remount::formats {

/// Counts what the process holds on the heap, whoever asks for it: a binary that links allocation_meter.cpp has its
/// malloc replaced by one that counts. One at a time.
class AllocationMeter {
 public:
  AllocationMeter();
  /// The most that was held since the construction, beyond what was held then.
  std::size_t peak_bytes() const;
  /// False under sanitizers, which replace malloc themselves.
  static bool works();

 private:
  std::size_t before_;
};

}  // namespace remount::formats
