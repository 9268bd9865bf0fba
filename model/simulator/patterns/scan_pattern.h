// In which directions a LiDAR fires, and when. Patterns know nothing of the world and of errors.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace remount::simulator {

/// One shot of one laser, as the sensor itself takes it to be. LiDAR frame: x ahead, y left, z up.
struct Firing {
  double share = 0.0;          ///< of the frame that has passed, [0, 1)
  double azimuth_rad = 0.0;    ///< from x towards y
  double elevation_rad = 0.0;  ///< above the plane of x and y
  std::uint16_t channel = 0;   ///< of the laser; where lasers are rings, 0 is the lowest
};

/// What users may choose; patterns take from it what they have.
struct PatternSettings {
  double frame_rate_hz = 10.0;
  int points_per_frame = 0;  ///< 0: as the data sheet; other numbers are met as nearly as the pattern allows
  int beams = 64;
  int azimuth_steps = 1000;
  bool clockwise = true;
  double field_deg = 70.0;
  bool backwards = false;
};

class ScanPattern {
 public:
  virtual ~ScanPattern() = default;
  virtual int channels() const = 0;
  /// Of one frame, in the order of their times. A frame is the same whenever it is asked for, however many were before.
  virtual std::vector<Firing> firings(std::size_t frame) const = 0;
};

/// Something that goes round for ever, seen at each shot. It counts in 2^-64 of a turn and lets whole turns go, so that
/// the last shot of a day is as exact as the first.
class Turning {
 public:
  /// Negative: the other way round, through the same places.
  explicit Turning(double turns_per_shot) {
    const double forwards = std::abs(turns_per_shot);
    const auto step = static_cast<std::uint64_t>(std::ldexp(forwards - std::floor(forwards), 64));
    step_ = turns_per_shot < 0.0 ? 0 - step : step;
  }

  /// In turns, [0, 1).
  double phase(std::uint64_t shot) const { return std::ldexp(static_cast<double>((step_ * shot) >> 11), -53); }

 private:
  std::uint64_t step_;
};

/// Points in a frame: as they are asked for, or of the data sheet's rate.
inline int points_in_frame(const PatternSettings& settings, int points_per_s) {
  if (settings.points_per_frame > 0) return settings.points_per_frame;
  return std::max(1, static_cast<int>(std::lround(points_per_s / settings.frame_rate_hz)));
}

}  // namespace remount::simulator
