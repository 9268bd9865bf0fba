// How errors of a LiDAR's beams stand in result files.
#pragma once

#include <cmath>
#include <vector>

#include "algorithms/cloud/beam_errors.h"
#include "algorithms/geometry/rotation.h"
#include "model/formats/documents/document.h"

namespace remount::results {

/// What is to be added to what the LiDAR measured, with its sigma: to its elevations and ranges, at some elevations
/// over its x-y plane, and to all ranges in proportion. Correlations are not kept.
struct BeamNotation {
  /// The error and its sigma; null where the drive tells none.
  static formats::DocumentNode mean_document(const cloud::BeamMean& mean, double unit) {
    return mean.told ? formats::DocumentNode::numbers({unit * mean.error, unit * mean.sigma})
                     : formats::DocumentNode::null();
  }
  static cloud::BeamMean mean_from_document(const formats::DocumentView& view, double unit) {
    if (view.is_null()) return {};
    const std::vector<double> numbers = view.numbers(2);
    return {unit * numbers[0], unit * numbers[1], true};
  }
  formats::DocumentNode write(const cloud::BeamEstimate& beams) const {
    std::vector<double> at_deg;
    for (Eigen::Index node = 0; node < cloud::kBeamNodes; ++node)
      at_deg.push_back(std::round(10.0 * radians_to_degrees(cloud::beam_node_rad(node))) / 10.0);
    const auto numbers = [](const cloud::BeamErrors& of, Eigen::Index first, double unit) {
      const auto part = unit * of.segment<cloud::kBeamNodes>(first);
      return formats::DocumentNode::numbers({part.begin(), part.end()});
    };
    formats::DocumentNode map = formats::DocumentNode::map();
    map.add("at_elevation_deg", formats::DocumentNode::numbers(at_deg));
    map.add("elevation_deg", numbers(beams.errors, cloud::elevation_at(0), radians_to_degrees(1.0)));
    map.add("elevation_sigma_deg", numbers(beams.sigmas, cloud::elevation_at(0), radians_to_degrees(1.0)));
    map.add("range_m", numbers(beams.errors, cloud::range_at(0), 1.0));
    map.add("range_sigma_m", numbers(beams.sigmas, cloud::range_at(0), 1.0));
    map.add("mean_elevation_deg", mean_document(beams.elevation, radians_to_degrees(1.0)));
    map.add("mean_range_m", mean_document(beams.range, 1.0));
    map.add("range_scale", formats::DocumentNode::number(beams.errors[cloud::kRangeScale]));
    map.add("range_scale_sigma", formats::DocumentNode::number(beams.sigmas[cloud::kRangeScale]));
    return map;
  }
  void read(const formats::DocumentView& view, cloud::BeamEstimate& beams) const {
    const auto read_numbers = [&](const char* key, double unit, Eigen::Index first, cloud::BeamErrors& to) {
      const std::vector<double> read = view.at(key).numbers(cloud::kBeamNodes);
      for (Eigen::Index i = 0; i < cloud::kBeamNodes; ++i) to[first + i] = read[static_cast<std::size_t>(i)] * unit;
    };
    read_numbers("elevation_deg", degrees_to_radians(1.0), cloud::elevation_at(0), beams.errors);
    read_numbers("elevation_sigma_deg", degrees_to_radians(1.0), cloud::elevation_at(0), beams.sigmas);
    read_numbers("range_m", 1.0, cloud::range_at(0), beams.errors);
    read_numbers("range_sigma_m", 1.0, cloud::range_at(0), beams.sigmas);
    beams.elevation = mean_from_document(view.at("mean_elevation_deg"), degrees_to_radians(1.0));
    beams.range = mean_from_document(view.at("mean_range_m"), 1.0);
    beams.errors[cloud::kRangeScale] = view.at("range_scale").number();
    beams.sigmas[cloud::kRangeScale] = view.at("range_scale_sigma").number();
  }
};

}  // namespace remount::results
