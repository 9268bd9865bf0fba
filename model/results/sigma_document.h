// How the sigmas of six parameters stand in result files.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/calibration/parameter.h"
#include "algorithms/geometry/rotation.h"
#include "messages/results.h"
#include "model/formats/documents/notations.h"

namespace remount::results {

inline formats::DocumentNode order_document(const std::array<calibration::Parameter, 6>& order) {
  formats::DocumentNode list = formats::DocumentNode::sequence();
  for (const calibration::Parameter parameter : order) list.add(formats::DocumentNode::string(to_string(parameter)));
  return list;
}

using Sigmas = calibration::PerParameter<std::optional<double>>;  // m, rad; nothing where not observed

/// Three of the sigmas, in m and degrees; null where not observed.
struct SigmaRow {
  std::array<calibration::Parameter, 3> parameters;
  Message (*expected_three)();

  formats::DocumentNode write(const Sigmas& sigmas) const {
    std::vector<double> row;
    for (const calibration::Parameter parameter : parameters) {
      const double sigma = sigmas[parameter].value_or(std::numeric_limits<double>::quiet_NaN());
      row.push_back(calibration::is_angle(parameter) ? radians_to_degrees(sigma) : sigma);
    }
    return formats::DocumentNode::numbers(row);
  }
  void read(const formats::DocumentView& view, Sigmas& sigmas) const {
    const std::vector<formats::DocumentView> row = view.items();
    if (row.size() != parameters.size()) view.fail(expected_three());
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (row[i].is_null()) continue;
      const double sigma = row[i].number();
      sigmas[parameters[i]] = calibration::is_angle(parameters[i]) ? degrees_to_radians(sigma) : sigma;
    }
  }
};

inline bool none_is_negative(const Sigmas& sigmas) {
  for (const calibration::Parameter parameter : calibration::kParameters)
    if (sigmas[parameter].value_or(0.0) < 0.0) return false;
  return true;
}

inline constexpr formats::MapOf kSigmas{[](auto& sigmas, auto& fields) {
  fields.only_written("order", order_document({calibration::Parameter::X, calibration::Parameter::Y,
                                               calibration::Parameter::Z, calibration::Parameter::Roll,
                                               calibration::Parameter::Pitch, calibration::Parameter::Yaw}));
  fields("translation_m", sigmas,
         SigmaRow{{calibration::Parameter::X, calibration::Parameter::Y, calibration::Parameter::Z},
                  say::result_expected_translation});
  fields("rotation_deg", sigmas,
         SigmaRow{{calibration::Parameter::Roll, calibration::Parameter::Pitch, calibration::Parameter::Yaw},
                  say::result_expected_rotation});
  fields.require(none_is_negative(sigmas), say::result_negative_sigma);
}};

}  // namespace remount::results
