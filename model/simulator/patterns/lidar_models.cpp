#include "model/simulator/patterns/lidar_models.h"

#include <string>

#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "messages/simulation.h"
#include "model/simulator/patterns/raster_pattern.h"
#include "model/simulator/patterns/spinning_pattern.h"
#include "model/simulator/patterns/woven_patterns.h"

namespace remount::simulator {

namespace {

using Settings = const PatternSettings&;
using Pattern = std::unique_ptr<ScanPattern>;

Pattern spinning(Settings settings) {
  const int steps =
      settings.points_per_frame > 0 ? std::max(1, settings.points_per_frame / settings.beams) : settings.azimuth_steps;
  return std::make_unique<SpinningPattern>(beam_elevations_rad(settings.beams), steps, settings.clockwise);
}

Pattern rosette(Settings settings) { return std::make_unique<RosettePattern>(settings, 100'000, settings.field_deg); }

Pattern mid_40(Settings settings) { return std::make_unique<RosettePattern>(settings, 100'000, 38.4); }
Pattern mid_70(Settings settings) { return std::make_unique<RosettePattern>(settings, 100'000, 70.4); }
/// Its six lasers make the field higher than it is wide.
Pattern avia(Settings settings) {
  return std::make_unique<RosettePattern>(settings, 240'000, 70.4, 6, (77.2 - 70.4) / 5);
}
Pattern mid_360(Settings settings) { return std::make_unique<PanoramaPattern>(settings, 200'000, -7.0, 52.0, 4, 1.5); }
Pattern hap(Settings settings) { return std::make_unique<WovenLinesPattern>(settings, 452'000, 120.0, 25.0, 6, 24); }

/// Five lasers side by side behind one mirror that tilts both ways; 0.2 degrees on average.
Pattern m1(Settings settings) {
  return std::make_unique<RasterPattern>(settings, RasterShape{.width_deg = 120.0,
                                                               .height_deg = 25.0,
                                                               .mirror_columns = 120,
                                                               .mirror_rows = 125,
                                                               .lasers_across = 5,
                                                               .to_and_fro = true});
}
/// No moving parts: line by line.
Pattern e1(Settings settings) {
  return std::make_unique<RasterPattern>(
      settings, RasterShape{.width_deg = 120.0, .height_deg = 90.0, .mirror_rows = 140, .lasers_across = 186});
}
/// One mirror that turns; 0.1 degrees across.
Pattern at128(Settings settings) {
  return std::make_unique<RasterPattern>(
      settings, RasterShape{.width_deg = 120.0, .height_deg = 25.4, .mirror_columns = 1200, .lasers_up = 128});
}
/// The beams near the horizon fire at every step of 0.4 degrees, the others at every second one.
Pattern qt128(Settings settings) {
  constexpr int kPointsPerStep = 96;
  const int steps = std::max(1, points_in_frame(settings, 864'000) / kPointsPerStep);
  return std::make_unique<SpinningPattern>(even_elevations_rad(128, -52.6, 52.6), steps, settings.clockwise, true);
}
/// A polygon draws four lines at once, a mirror moves them down.
Pattern falcon_k(Settings settings) {
  return std::make_unique<RasterPattern>(
      settings,
      RasterShape{.width_deg = 120.0, .height_deg = 25.0, .mirror_columns = 667, .mirror_rows = 30, .lasers_up = 4});
}

}  // namespace

const std::vector<LidarModel>& lidar_models() {
  constexpr bool kSpins = true, kHasRings = true;
  static const std::vector<LidarModel> models{
      {"spinning", {}, kSpins, kHasRings, spinning},
      {"rosette", {}, false, false, rosette},
      {"mid-40", {38.4, -19.2, 19.2, 100'000, 10.0, 260.0}, false, false, mid_40},
      {"mid-70", {70.4, -35.2, 35.2, 100'000, 10.0, 260.0}, false, false, mid_70},
      {"avia", {70.4, -38.6, 38.6, 240'000, 10.0, 450.0}, false, false, avia},
      {"mid-360", {360.0, -7.0, 52.0, 200'000, 10.0, 70.0}, false, false, mid_360},
      {"hap", {120.0, -12.5, 12.5, 452'000, 10.0}, false, false, hap},
      {"m1", {120.0, -12.5, 12.5, 750'000, 10.0, 200.0}, false, false, m1},
      {"e1", {120.0, -45.0, 45.0, 260'000, 10.0, 75.0}, false, false, e1},
      {"at128", {120.0, -12.7, 12.7, 1'536'000, 10.0, 210.0}, false, kHasRings, at128},
      {"qt128", {360.0, -52.6, 52.6, 864'000, 10.0, 50.0}, kSpins, kHasRings, qt128},
      {"falcon-k", {120.0, -12.5, 12.5, 800'000, 10.0, 500.0}, false, false, falcon_k}};
  return models;
}

const std::vector<std::string_view>& lidar_model_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> ids;
    for (const LidarModel& model : lidar_models()) ids.push_back(model.id);
    return ids;
  }();
  return names;
}

const LidarModel& lidar_model(LidarChoice choice) { return lidar_models().at(index_of(choice)); }

LidarChoice lidar_named(std::string_view id) {
  for (std::size_t i = 0; i < lidar_models().size(); ++i)
    if (lidar_models()[i].id == id) return static_cast<LidarChoice>(i);
  throw Error(ErrorCode::Contract, std::string(id), say::simulation_no_such_lidar());
}

}  // namespace remount::simulator
