#include "model/simulator/patterns/spinning_pattern.h"

#include <utility>

#include "algorithms/geometry/rotation.h"

namespace remount::simulator {

std::vector<double> beam_elevations_rad(int beams) {
  double low_deg = -25.0, high_deg = 15.0;
  if (beams <= 16) {
    low_deg = -15.0;
    high_deg = 15.0;
  } else if (beams <= 32) {
    low_deg = -30.0;
    high_deg = 10.0;
  } else if (beams <= 64) {
    low_deg = -24.8;
    high_deg = 2.0;
  }
  return even_elevations_rad(beams, low_deg, high_deg);
}

std::vector<double> even_elevations_rad(int beams, double low_deg, double high_deg) {
  std::vector<double> elevations_rad;
  for (int i = 0; i < beams; ++i)
    elevations_rad.push_back(degrees_to_radians(beams == 1 ? 0.0 : low_deg + (high_deg - low_deg) * i / (beams - 1)));
  return elevations_rad;
}

SpinningPattern::SpinningPattern(std::vector<double> elevations_rad, int steps, bool clockwise, bool outer_in_turns)
    : elevations_rad_(std::move(elevations_rad)),
      steps_(steps),
      clockwise_(clockwise),
      outer_in_turns_(outer_in_turns) {}

bool SpinningPattern::fires(std::size_t beam, int step) const {
  const std::size_t quarter = elevations_rad_.size() / 4;
  const bool inner = beam >= quarter && beam < elevations_rad_.size() - quarter;
  return !outer_in_turns_ || inner || (beam + static_cast<std::size_t>(step)) % 2 == 0;
}

std::vector<Firing> SpinningPattern::firings(std::size_t) const {
  std::vector<Firing> firings;
  firings.reserve(elevations_rad_.size() * static_cast<std::size_t>(steps_));
  for (int step = 0; step < steps_; ++step) {
    const double share = (step + 0.5) / steps_;
    const double azimuth_rad = (clockwise_ ? -2.0 : 2.0) * kPi * (share - 0.5);
    for (std::size_t beam = 0; beam < elevations_rad_.size(); ++beam)
      if (fires(beam, step))
        firings.push_back({share, azimuth_rad, elevations_rad_[beam], static_cast<std::uint16_t>(beam)});
  }
  return firings;
}

}  // namespace remount::simulator
