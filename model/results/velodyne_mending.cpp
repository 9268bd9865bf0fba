#include "model/results/velodyne_mending.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/cloud/point_cloud.h"
#include "model/formats/files/number_text.h"

namespace remount::results {
namespace {

// A point of the beam without the errors of one kind, as they move it.
Eigen::Vector3d mended_point(const Eigen::Vector3f& at, const cloud::BeamErrors& errors, Eigen::Index first) {
  cloud::BeamErrors of_kind(errors.nodes);
  const Eigen::Index count = errors.nodes.count();
  of_kind.values.segment(first, count) = errors.values.segment(first, count);
  cloud::PointCloud beam;
  beam.points = {at};
  cloud::mend_beams(of_kind, beam);
  return beam.points.front().cast<double>();
}

// What is to be added to an elevation (rad) and to a range (m).
struct BeamCorrection {
  double elevation_rad, range_m;
};
BeamCorrection correction_at(double elevation_rad, const cloud::BeamErrors& errors) {
  if (errors.none()) return {0.0, 0.0};
  constexpr double kRange_m = 10.0;
  const Eigen::Vector3f at(static_cast<float>(kRange_m * std::cos(elevation_rad)), 0.0F,
                           static_cast<float>(kRange_m * std::sin(elevation_rad)));
  const Eigen::Vector3d turned = mended_point(at, errors, errors.nodes.elevation_at(0));
  const Eigen::Vector3d longer = mended_point(at, errors, errors.nodes.range_at(0));
  const auto up_rad = [](const auto& point) { return std::atan2(double{point.z()}, double{point.x()}); };
  return {up_rad(turned) - up_rad(at), longer.norm() - at.cast<double>().norm()};
}

}  // namespace

std::string with_beams_mended(const formats::VelodyneCalibration& calibration, const cloud::BeamErrors& errors) {
  std::vector<std::pair<formats::NumberInText, double>> edits;
  for (const formats::CalibratedLaser& laser : calibration.lasers) {
    const BeamCorrection add = correction_at(laser.elevation.value * calibration.elevation_unit_rad, errors);
    edits.emplace_back(laser.elevation, laser.elevation.value + add.elevation_rad / calibration.elevation_unit_rad);
    for (const formats::NumberInText& distance : laser.distances)
      edits.emplace_back(distance, distance.value + add.range_m / calibration.distance_unit_m);
  }
  std::ranges::sort(edits, {}, [](const auto& edit) { return edit.first.begin; });
  std::string text;
  std::size_t at = 0;
  for (const auto& [number, value] : edits) {
    text.append(calibration.text, at, number.begin - at).append(formats::format_numbers("%.7g", value));
    at = number.begin + number.length;
  }
  return text.append(calibration.text, at);
}

}  // namespace remount::results
