// Sensors whose frames never repeat: prisms and mirrors turn at rates that have nothing to do with the frames. How far
// they look and how much they measure are those of data sheets; the rates at which their parts turn are near those that
// are known, or made up where none are.
#pragma once

#include "model/simulator/patterns/scan_pattern.h"

namespace remount::simulator {

/// Two prisms that turn against each other draw a rosette in a circular field about x. Each bends the beam by a quarter
/// of the field; several lasers lie above each other and fire in turn.
class RosettePattern : public ScanPattern {
 public:
  /// @param field_deg full angle of the circle of one laser
  /// @param between_lasers_deg from one laser to the next
  RosettePattern(const PatternSettings& settings, int points_per_s, double field_deg, int lasers = 1,
                 double between_lasers_deg = 0.0);

  int channels() const override { return lasers_; }
  std::vector<Firing> firings(std::size_t frame) const override;

 private:
  int points_, lasers_;
  double bend_rad_, between_lasers_rad_;
  Turning first_, second_;
};

/// A head that turns several times a frame while its lasers swing up and down.
class PanoramaPattern : public ScanPattern {
 public:
  PanoramaPattern(const PatternSettings& settings, int points_per_s, double low_deg, double high_deg, int lasers,
                  double between_lasers_deg);

  int channels() const override { return lasers_; }
  std::vector<Firing> firings(std::size_t frame) const override;

 private:
  int points_, lasers_;
  double low_rad_, swing_rad_, between_lasers_rad_;
  Turning head_, swing_;
};

/// Lines from left to right, one of each laser in its part of the height; each sweep has its lines and their points
/// elsewhere, far from those of all former ones.
class WovenLinesPattern : public ScanPattern {
 public:
  WovenLinesPattern(const PatternSettings& settings, int points_per_s, double width_deg, double height_deg, int lasers,
                    int sweeps_per_frame);

  int channels() const override { return lasers_; }
  std::vector<Firing> firings(std::size_t frame) const override;

 private:
  int points_, lasers_, columns_;
  double width_rad_, height_rad_;
  Turning up_, across_;  ///< from sweep to sweep, of what lies between two lasers and two points
};

}  // namespace remount::simulator
