// When the points of a scan were measured.
#pragma once

namespace remount::motion {

/// From its stamp on, s. Both zero: at once.
struct Sweep {
  double from_s = 0.0, until_s = 0.0;

  double length_s() const { return until_s - from_s; }
  double middle_s() const { return 0.5 * (from_s + until_s); }
};

}  // namespace remount::motion
