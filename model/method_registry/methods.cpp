// The list of the calibration methods. Each is defined in a folder of its own below model/methods.
#include "messages/methods.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "algorithms/core/error.h"
#include "model/method_registry/calibration_method.h"

namespace remount::methods {
extern const method_registry::CalibrationMethod kPairwiseMethod, kTrajectoryMethod, kVehicleFrameMethod,
    kFusionOdometryMethod, kSlewMethod;
}  // namespace remount::methods

namespace remount::method_registry {

namespace {

constexpr const CalibrationMethod* kMethods[] = {
    &methods::kPairwiseMethod,  // the default
    &methods::kTrajectoryMethod, &methods::kVehicleFrameMethod, &methods::kFusionOdometryMethod, &methods::kSlewMethod,
};

}  // namespace

std::span<const CalibrationMethod* const> calibration_methods() { return kMethods; }

const CalibrationMethod& default_method() { return *kMethods[0]; }

const CalibrationMethod* find_method(std::string_view id) {
  const auto* const found = std::find_if(std::begin(kMethods), std::end(kMethods),
                                         [&](const CalibrationMethod* method) { return method->id == id; });
  return found == std::end(kMethods) ? nullptr : *found;
}

const CalibrationMethod& calibration_method(std::string_view id) {
  if (const CalibrationMethod* method = find_method(id)) return *method;
  std::vector<std::string> known;
  for (const CalibrationMethod* method : kMethods) known.emplace_back(method->id);
  throw Error(ErrorCode::Contract, "method " + std::string(id), say::method_unknown(known));
}

bool is_from_pairs(std::string_view id) {
  const CalibrationMethod* method = find_method(id);
  return method != nullptr && method->from_pairs;
}

}  // namespace remount::method_registry
