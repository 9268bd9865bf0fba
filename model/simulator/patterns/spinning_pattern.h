// Rings of a sensor that turns about its z axis.
#pragma once

#include "model/simulator/patterns/scan_pattern.h"

namespace remount::simulator {

/// Elevations of the beams, lowest first, rad: as usual for sensors of 16, 32, 64 and 128 beams.
std::vector<double> beam_elevations_rad(int beams);

/// Evenly from the lowest to the highest, rad.
std::vector<double> even_elevations_rad(int beams, double low_deg, double high_deg);

/// One turn a frame, with its middle ahead; all beams fire at once.
class SpinningPattern : public ScanPattern {
 public:
  /// @param outer_in_turns the outer half of the beams fires at every second step, every other beam at odd ones
  SpinningPattern(std::vector<double> elevations_rad, int steps, bool clockwise, bool outer_in_turns = false);

  int channels() const override { return static_cast<int>(elevations_rad_.size()); }
  std::vector<Firing> firings(std::size_t frame) const override;

 private:
  bool fires(std::size_t beam, int step) const;

  std::vector<double> elevations_rad_;
  int steps_;
  bool clockwise_, outer_in_turns_;
};

}  // namespace remount::simulator
