#include "model/simulator/patterns/woven_patterns.h"

#include <complex>

#include "algorithms/geometry/rotation.h"

namespace remount::simulator {

namespace {

/// Of the prisms of a Livox Mid-40: 7294 and 4664 turns a minute (Brazeal, Wilkinson, Hochmair 2021, "A rigorous
/// observation model for the Risley prism-based Livox Mid-40 lidar sensor"). The last digits keep the rosettes of any
/// hour apart: motors are not that even.
constexpr double kFirstPrism_hz = 121.5663, kSecondPrism_hz = 77.7301;
/// So that a frame of a tenth of a second sees all around three times.
constexpr double kHead_hz = 33.7013, kSwing_hz = 610.3019;
/// Steps that fill a square evenly, however many are made: 1/p and 1/p^2 of the root p of p^3 = p + 1 (Roberts 2018).
constexpr double kFirstEvenStep = 0.75487766624669276, kSecondEvenStep = 0.56984029099805327;

/// Turns between two shots of something that turns at a rate.
double turns_per_shot(const PatternSettings& settings, int points, double rate_hz) {
  return rate_hz / (points * settings.frame_rate_hz);
}

std::uint64_t first_shot(std::size_t frame, int points) {
  return static_cast<std::uint64_t>(frame) * static_cast<std::uint64_t>(points);
}

}  // namespace

RosettePattern::RosettePattern(const PatternSettings& settings, int points_per_s, double field_deg, int lasers,
                               double between_lasers_deg)
    : points_(points_in_frame(settings, points_per_s)),
      lasers_(lasers),
      bend_rad_(degrees_to_radians(field_deg) / 4.0),
      between_lasers_rad_(degrees_to_radians(between_lasers_deg)),
      first_(turns_per_shot(settings, points_, settings.backwards ? -kFirstPrism_hz : kFirstPrism_hz)),
      second_(turns_per_shot(settings, points_, settings.backwards ? kSecondPrism_hz : -kSecondPrism_hz)) {}

std::vector<Firing> RosettePattern::firings(std::size_t frame) const {
  std::vector<Firing> firings(static_cast<std::size_t>(points_));
  for (int i = 0; i < points_; ++i) {
    const std::uint64_t shot = first_shot(frame, points_) + static_cast<std::uint64_t>(i);
    const auto bent =
        std::polar(bend_rad_, 2.0 * kPi * first_.phase(shot)) + std::polar(bend_rad_, 2.0 * kPi * second_.phase(shot));
    const double off_axis_rad = std::abs(bent), around_rad = std::arg(bent);
    const auto laser = static_cast<int>(shot % static_cast<std::uint64_t>(lasers_));
    const double sideways = std::sin(off_axis_rad) * std::cos(around_rad);
    const double up = std::sin(off_axis_rad) * std::sin(around_rad);
    firings[static_cast<std::size_t>(i)] = {
        static_cast<double>(i) / points_, std::atan2(sideways, std::cos(off_axis_rad)),
        std::asin(up) + (laser - 0.5 * (lasers_ - 1)) * between_lasers_rad_, static_cast<std::uint16_t>(laser)};
  }
  return firings;
}

PanoramaPattern::PanoramaPattern(const PatternSettings& settings, int points_per_s, double low_deg, double high_deg,
                                 int lasers, double between_lasers_deg)
    : points_(points_in_frame(settings, points_per_s)),
      lasers_(lasers),
      low_rad_(degrees_to_radians(low_deg)),
      swing_rad_(degrees_to_radians(high_deg - low_deg - (lasers - 1) * between_lasers_deg)),
      between_lasers_rad_(degrees_to_radians(between_lasers_deg)),
      head_(turns_per_shot(settings, points_, kHead_hz)),
      swing_(turns_per_shot(settings, points_, kSwing_hz)) {}

std::vector<Firing> PanoramaPattern::firings(std::size_t frame) const {
  std::vector<Firing> firings(static_cast<std::size_t>(points_));
  for (int i = 0; i < points_; ++i) {
    const std::uint64_t shot = first_shot(frame, points_) + static_cast<std::uint64_t>(i);
    const auto laser = static_cast<int>(shot % static_cast<std::uint64_t>(lasers_));
    const double up_and_down = std::abs(2.0 * swing_.phase(shot) - 1.0);
    firings[static_cast<std::size_t>(i)] = {static_cast<double>(i) / points_, 2.0 * kPi * (head_.phase(shot) - 0.5),
                                            low_rad_ + swing_rad_ * up_and_down + laser * between_lasers_rad_,
                                            static_cast<std::uint16_t>(laser)};
  }
  return firings;
}

WovenLinesPattern::WovenLinesPattern(const PatternSettings& settings, int points_per_s, double width_deg,
                                     double height_deg, int lasers, int sweeps_per_frame)
    : points_(points_in_frame(settings, points_per_s)),
      lasers_(lasers),
      columns_(std::max(2, static_cast<int>(std::lround(1.0 * points_ / (lasers * sweeps_per_frame))))),
      width_rad_(degrees_to_radians(width_deg)),
      height_rad_(degrees_to_radians(height_deg)),
      up_(kFirstEvenStep),
      across_(kSecondEvenStep) {}

std::vector<Firing> WovenLinesPattern::firings(std::size_t frame) const {
  std::vector<Firing> firings(static_cast<std::size_t>(points_));
  const auto lasers = static_cast<std::uint64_t>(lasers_), columns = static_cast<std::uint64_t>(columns_);
  for (int i = 0; i < points_; ++i) {
    const std::uint64_t shot = first_shot(frame, points_) + static_cast<std::uint64_t>(i);
    const auto laser = static_cast<int>(shot % lasers);
    const std::uint64_t round = shot / lasers, sweep = round / columns;
    const double across = (static_cast<double>(round % columns) + across_.phase(sweep)) / columns_;
    const double up = (laser + up_.phase(sweep)) / lasers_;
    firings[static_cast<std::size_t>(i)] = {static_cast<double>(i) / points_, (0.5 - across) * width_rad_,
                                            (up - 0.5) * height_rad_, static_cast<std::uint16_t>(laser)};
  }
  return firings;
}

}  // namespace remount::simulator
