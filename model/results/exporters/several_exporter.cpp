#include "model/results/exporters/several_exporter.h"

#include <algorithm>
#include <map>

#include "algorithms/core/error.h"
#include "messages/rig.h"
#include "model/results/lidar_names.h"

namespace remount::results {
namespace {

using calibration::ParameterSet;

std::string named_frame(const std::string& lidar, const ExportNames& names, const std::string& ending) {
  const auto given = names.lidar_frames.find(lidar);
  return given == names.lidar_frames.end() ? usual_frame(lidar) + ending : given->second;
}

// Of X_a^-1 X_b, or of the inverse of a transform, where only sigmas of parameters are known: a turn that is not known
// about one axis may be one about each in the other frame, and moves the place as well.
ParameterSet carried_over(ParameterSet known) {
  const bool turns = (known & calibration::kAttitudeParameters) == calibration::kAttitudeParameters;
  if (known.is_all()) return known;
  return turns ? calibration::kAttitudeParameters : ParameterSet();
}

ParameterSet observed_in(const RelativeRecord& two) {
  ParameterSet observed;
  for (const calibration::Parameter parameter : calibration::kParameters)
    if (two.sigma[parameter]) observed.insert(parameter);
  return observed;
}

struct Relative {
  RigidTransform lidar_a_from_lidar_b = RigidTransform::Identity();
  ParameterSet observed;
};

Relative relative_of(const VehicleFile& vehicle, const LidarResult& a, const LidarResult& b) {
  for (const RelativeRecord& two : vehicle.relatives) {
    if (two.lidar_a == a.name && two.lidar_b == b.name) return {two.lidar_a_from_lidar_b, observed_in(two)};
    if (two.lidar_a == b.name && two.lidar_b == a.name)
      return {two.lidar_a_from_lidar_b.inverse(), carried_over(observed_in(two))};
  }
  const calibration::CalibrationResult &of_a = a.file.result, &of_b = b.file.result;
  return {of_a.mounting.reference_from_sensor.inverse() * of_b.mounting.reference_from_sensor,
          carried_over(of_a.observed() & of_b.observed())};
}

}  // namespace

FrameNames frame_names(const VehicleFile& vehicle, const ExportNames& names, const std::string& usual_ins,
                       const std::string& usual_lidar, const std::string& ending) {
  FrameNames frames;
  frames.parent = !names.relative_to.empty() ? named_frame(names.relative_to, names, ending)
                  : names.ins_frame.empty()  ? usual_ins
                                             : names.ins_frame;
  for (const LidarResult& lidar : vehicle.lidars) {
    frames.lidars.push_back(!lidar.name.empty()         ? named_frame(lidar.name, names, ending)
                            : names.lidar_frame.empty() ? usual_lidar
                                                        : names.lidar_frame);
    if (frames.lidars.back() == frames.parent && !lidar.name.empty())
      throw Error(ErrorCode::Contract, lidar.name, say::export_frame_twice(frames.parent));
  }
  require_different(vehicle, frames.lidars);
  return frames;
}

std::string called_after(const LidarResult& lidar, const ExportNames& names) {
  return lidar.name.empty() ? "lidar" : usual_frame(named_frame(lidar.name, names, {}));
}

std::vector<std::string> transform_names(const VehicleFile& vehicle, const ExportNames& names) {
  const std::string parent = names.relative_to.empty() ? "ins" : usual_frame(names.relative_to);
  std::vector<std::string> transforms;
  for (const LidarResult& lidar : vehicle.lidars) transforms.push_back(parent + "_from_" + called_after(lidar, names));
  require_different(vehicle, transforms);
  return transforms;
}

void require_different(const VehicleFile& vehicle, const std::vector<std::string>& names) {
  std::map<std::string, std::string> lidar_by_name;
  for (std::size_t l = 0; l < names.size(); ++l) {
    const std::string& lidar = vehicle.lidars[l].name;
    const auto [other, is_new] = lidar_by_name.emplace(names[l], lidar);
    if (!is_new) throw Error(ErrorCode::Contract, lidar, say::export_called_alike(other->second, names[l]));
  }
}

VehicleFile relative_to(const VehicleFile& vehicle, std::string_view lidar, const std::string& where) {
  const LidarResult& reference = lidar_of(vehicle, lidar, where);
  VehicleFile others = vehicle;
  std::erase_if(others.lidars, [&](const LidarResult& one) { return one.name == reference.name; });
  for (LidarResult& other : others.lidars) {
    const Relative relative = relative_of(vehicle, reference, other);
    calibration::CalibrationResult& result = other.file.result;
    result.mounting.reference_from_sensor = relative.lidar_a_from_lidar_b;
    result.set_observed(relative.observed, {});
  }
  return others;
}

}  // namespace remount::results
