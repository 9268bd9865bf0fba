// Sensors that look ahead and go through the same directions in every frame.
#pragma once

#include "model/simulator/patterns/scan_pattern.h"

namespace remount::simulator {

/// A mirror goes through a grid of places, line by line from the top, each line from left to right; at each of them all
/// lasers fire at once. A flash is a mirror that goes through whole lines.
struct RasterShape {
  double width_deg = 120.0, height_deg = 25.0;
  int mirror_columns = 1, mirror_rows = 1;  ///< places of the mirror
  int lasers_across = 1;                    ///< each with a part of the width of its own
  int lasers_up = 1;                        ///< next to each other
  bool to_and_fro = false;                  ///< every second line from right to left
};

class RasterPattern : public ScanPattern {
 public:
  /// The shape is that of ten frames a second. Where there are fewer points the mirror has fewer places, the lasers
  /// stay.
  RasterPattern(const PatternSettings& settings, const RasterShape& shape);

  int channels() const override { return shape_.lasers_across * shape_.lasers_up; }
  std::vector<Firing> firings(std::size_t frame) const override;

 private:
  Firing firing(int line, int place, int laser_across, int laser_up) const;

  RasterShape shape_;
};

}  // namespace remount::simulator
