#include "model/simulator/patterns/raster_pattern.h"

#include "algorithms/geometry/rotation.h"

namespace remount::simulator {

namespace {

/// Of the frames that shapes are given for; twice as many a second have half the points.
constexpr double kRasterRate_hz = 10.0;

double at_step(int step, int steps, double from_deg, double to_deg) {
  return degrees_to_radians(steps == 1 ? 0.5 * (from_deg + to_deg)
                                       : from_deg + (to_deg - from_deg) * step / (steps - 1));
}

}  // namespace

RasterPattern::RasterPattern(const PatternSettings& settings, const RasterShape& shape) : shape_(shape) {
  const int places = shape.mirror_columns * shape.mirror_rows;
  const double wanted = settings.points_per_frame > 0 ? static_cast<double>(settings.points_per_frame) / channels()
                                                      : places * kRasterRate_hz / settings.frame_rate_hz;
  const bool along_both = shape.mirror_columns > 1 && shape.mirror_rows > 1;
  const double share = along_both ? std::sqrt(wanted / places) : wanted / places;
  const auto thinned = [&](int steps) {
    return steps > 1 ? std::max(1, static_cast<int>(std::lround(steps * share))) : steps;
  };
  shape_.mirror_columns = thinned(shape.mirror_columns);
  shape_.mirror_rows = thinned(shape.mirror_rows);
}

Firing RasterPattern::firing(int line, int place, int laser_across, int laser_up) const {
  const int columns = shape_.mirror_columns * shape_.lasers_across, rows = shape_.mirror_rows * shape_.lasers_up;
  const bool back = shape_.to_and_fro && line % 2 == 1;
  const int column = laser_across * shape_.mirror_columns + (back ? shape_.mirror_columns - 1 - place : place);
  const int row = (shape_.mirror_rows - 1 - line) * shape_.lasers_up + laser_up;
  return {(line + static_cast<double>(place) / shape_.mirror_columns) / shape_.mirror_rows,
          at_step(column, columns, 0.5 * shape_.width_deg, -0.5 * shape_.width_deg),
          at_step(row, rows, -0.5 * shape_.height_deg, 0.5 * shape_.height_deg),
          static_cast<std::uint16_t>(laser_across * shape_.lasers_up + laser_up)};
}

std::vector<Firing> RasterPattern::firings(std::size_t) const {
  std::vector<Firing> firings;
  for (int line = 0; line < shape_.mirror_rows; ++line)
    for (int place = 0; place < shape_.mirror_columns; ++place)
      for (int across = 0; across < shape_.lasers_across; ++across)
        for (int up = 0; up < shape_.lasers_up; ++up) firings.push_back(firing(line, place, across, up));
  return firings;
}

}  // namespace remount::simulator
