// How many points may be drawn while the camera moves.
#pragma once

#include <array>
#include <cstddef>

namespace remount::scene {

/// Follows the machine: from the time that frames took, the number of points that keeps a frame within the target. What
/// a frame costs without any point is told apart from it, or slow displays would be left with hardly any point for
/// nothing.
class FrameBudget {
 public:
  static constexpr double kTarget_s = 0.05;
  static constexpr std::size_t kFewest = 16384;  ///< fewer say nothing of the cloud
  static constexpr std::size_t kAtFirst = 100000;

  /// A frame with so many points took so long.
  void took(std::size_t points, double seconds);
  std::size_t points() const { return points_; }    ///< for a frame of kTarget_s
  double seconds_for(std::size_t points) const;     ///< as far as is known
  std::size_t points_within(double seconds) const;  ///< the same the other way round; at least kFewest

 private:
  struct Frame {
    double points = 0.0, seconds = 0.0;
  };
  void learn();

  std::array<Frame, 16> frames_{};  // the last ones
  std::size_t count_ = 0;
  std::size_t points_ = kAtFirst;
  double fixed_s_ = 0.0, seconds_per_point_ = kTarget_s / static_cast<double>(kAtFirst);
};

}  // namespace remount::scene
