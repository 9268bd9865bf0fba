// How errors of a LiDAR's beams stand in result files.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/cloud/beam_errors.h"
#include "algorithms/geometry/rotation.h"
#include "messages/files.h"
#include "messages/results.h"
#include "model/formats/documents/document.h"

namespace remount::results {

/// Where errors of beams are unknowns: elevations and, of a LiDAR that does not look all around, azimuths.
struct BeamNodesNotation {
  static constexpr std::string_view kElevations = "at_elevation_deg", kAzimuths = "at_azimuth_deg";

  static void add_to(const cloud::BeamNodes& nodes, formats::DocumentNode& map) {
    const auto add = [&map](std::string_view key, std::vector<double> angles) {
      // As they were written, whatever became of their last digits as radians.
      for (double& angle : angles) angle = std::round(1e9 * radians_to_degrees(angle)) / 1e9;
      map.add(std::string(key), formats::DocumentNode::numbers(angles));
    };
    add(kElevations, nodes.elevations_rad());
    if (nodes.by_azimuth()) add(kAzimuths, nodes.azimuths_rad());
  }
  formats::DocumentNode write(const cloud::BeamNodes& nodes) const {
    formats::DocumentNode map = formats::DocumentNode::map();
    add_to(nodes, map);
    return map;
  }
  static std::vector<double> angles_from(const formats::DocumentView& view, double most_deg) {
    constexpr std::size_t kMost = 400;
    const std::size_t count = view.items().size();
    std::vector<double> angles = view.numbers(std::min(count, kMost));
    const bool inside = count >= 2 && count <= kMost && angles.front() > -most_deg && angles.back() < most_deg;
    if (!inside || std::ranges::adjacent_find(angles, std::greater_equal()) != angles.end())
      view.fail(say::document_expected_ascending(2, -most_deg, most_deg));
    for (double& angle : angles) angle = degrees_to_radians(angle);
    return angles;
  }
  static cloud::BeamNodes nodes_from(const formats::DocumentView& view) {
    const std::optional<formats::DocumentView> azimuths = view.find(kAzimuths);
    std::vector<double> azimuths_rad = azimuths ? angles_from(*azimuths, 720.0) : std::vector<double>();
    if (azimuths && azimuths_rad.back() - azimuths_rad.front() >= 2.0 * kPi)
      azimuths->fail(say::document_expected_ascending(2, -180.0, 180.0));
    cloud::BeamNodes nodes(angles_from(view.at(kElevations), 90.0), std::move(azimuths_rad));
    if (nodes.errors() > cloud::kMostBeamErrors)
      view.at(kElevations)
          .fail(say::beams_too_many_nodes(static_cast<std::size_t>(nodes.errors()),
                                          static_cast<std::size_t>(cloud::kMostBeamErrors)));
    return nodes;
  }
  void read(const formats::DocumentView& view, cloud::BeamNodes& nodes) const { nodes = nodes_from(view); }
};

/// What is to be added to what the LiDAR measured, with its sigma: at these nodes, and to all ranges in proportion.
/// Correlations are not kept.
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
  /// Of one kind of error at every node.
  struct Part {
    std::string_view values, sigmas;
    Eigen::Index first;
    double unit;
  };
  static std::vector<Part> parts_of(const cloud::BeamNodes& nodes) {
    std::vector<Part> parts{{"elevation_deg", "elevation_sigma_deg", nodes.elevation_at(0), degrees_to_radians(1.0)},
                            {"range_m", "range_sigma_m", nodes.range_at(0), 1.0}};
    if (nodes.by_azimuth())
      parts.push_back({"azimuth_deg", "azimuth_sigma_deg", nodes.azimuth_at(0), degrees_to_radians(1.0)});
    return parts;
  }
  formats::DocumentNode write(const cloud::BeamEstimate& beams) const {
    const Eigen::Index count = beams.nodes.count();
    const auto numbers = [&](const Eigen::VectorXd& of, const Part& part) {
      const Eigen::VectorXd at_nodes = of.segment(part.first, count) / part.unit;
      return formats::DocumentNode::numbers({at_nodes.begin(), at_nodes.end()});
    };
    formats::DocumentNode map = formats::DocumentNode::map();
    BeamNodesNotation::add_to(beams.nodes, map);
    for (const Part& part : parts_of(beams.nodes)) {
      map.add(std::string(part.values), numbers(beams.errors, part));
      map.add(std::string(part.sigmas), numbers(beams.sigmas, part));
    }
    map.add("mean_elevation_deg", mean_document(beams.elevation, radians_to_degrees(1.0)));
    map.add("mean_range_m", mean_document(beams.range, 1.0));
    map.add("range_scale", formats::DocumentNode::number(beams.range_scale()));
    map.add("range_scale_sigma", formats::DocumentNode::number(beams.range_scale_sigma()));
    return map;
  }
  void read(const formats::DocumentView& view, cloud::BeamEstimate& beams) const {
    beams.nodes = BeamNodesNotation::nodes_from(view);
    beams.errors = beams.sigmas = Eigen::VectorXd::Zero(beams.nodes.errors());
    const auto count = static_cast<std::size_t>(beams.nodes.count());
    const auto read_part = [&](std::string_view key, const Part& part, Eigen::VectorXd& to) {
      const std::vector<double> read = view.at(key).numbers(count);
      to.segment(part.first, beams.nodes.count()) =
          part.unit * Eigen::Map<const Eigen::VectorXd>(read.data(), beams.nodes.count());
    };
    for (const Part& part : parts_of(beams.nodes)) {
      read_part(part.values, part, beams.errors);
      read_part(part.sigmas, part, beams.sigmas);
    }
    beams.elevation = mean_from_document(view.at("mean_elevation_deg"), degrees_to_radians(1.0));
    beams.range = mean_from_document(view.at("mean_range_m"), 1.0);
    beams.errors[beams.nodes.range_scale()] = view.at("range_scale").number();
    beams.sigmas[beams.nodes.range_scale()] = view.at("range_scale_sigma").number();
    if ((beams.sigmas.array() < 0.0).any() || beams.elevation.sigma < 0.0 || beams.range.sigma < 0.0)
      view.fail(say::result_negative_sigma());
  }
};

}  // namespace remount::results
