// Colours for distances between scans, the same for every pair.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace remount::scene {

using SceneColor = std::array<unsigned char, 3>;

/// From 0 to a limit along a scale that also the colour-blind can order (blue, green, yellow); more than the limit is
/// red, which is not on the scale, and nothing to compare with a pale purple.
class DistanceScale {
 public:
  static constexpr double kLeast_m = 0.01, kMost_m = 1.0, kDefault_m = 0.30;

  /// @param limit_m held within kLeast_m and kMost_m
  explicit DistanceScale(double limit_m = kDefault_m);
  double limit_m() const { return limit_m_; }

  SceneColor color(float distance_m) const;  ///< of whichever side; NaN: nothing to compare with
  std::vector<SceneColor> colors(const std::vector<float>& distances_m) const;

  static constexpr SceneColor kOverRange{204, 51, 17};
  static constexpr SceneColor kNothingNear{200, 165, 205};
  /// Of the scale at a share between 0 and 1.
  static SceneColor at(double share);

 private:
  double limit_m_;
};

}  // namespace remount::scene
