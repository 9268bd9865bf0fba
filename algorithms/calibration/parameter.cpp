#include "algorithms/calibration/parameter.h"

#include "algorithms/core/index.h"
#include "messages/parameters.h"

namespace remount::calibration {
namespace {
constexpr std::array<std::string_view, 6> kParameterNames{"x", "y", "z", "yaw", "pitch", "roll"};
}

std::string_view to_string(Parameter parameter) { return kParameterNames.at(index_of(parameter)); }

std::optional<Parameter> parameter_from_string(std::string_view text) {
  for (const Parameter parameter : kParameters)
    if (to_string(parameter) == text) return parameter;
  return std::nullopt;
}

Message parameter_word(Parameter parameter) {
  constexpr std::array<Message (*)(), 6> kWords{say::parameter_x,   say::parameter_y,     say::parameter_z,
                                                say::parameter_yaw, say::parameter_pitch, say::parameter_roll};
  return kWords.at(index_of(parameter))();
}

std::vector<Message> parameter_words(ParameterSet set) {
  std::vector<Message> words;
  for (const Parameter parameter : kParameters)
    if (set.contains(parameter)) words.push_back(parameter_word(parameter));
  return words;
}

std::string parameter_names(ParameterSet set) {
  std::string names;
  for (const Parameter parameter : kParameters)
    if (set.contains(parameter)) names += (names.empty() ? "" : ", ") + std::string(to_string(parameter));
  return names;
}

PerParameter<double> parameters_of(const RigidTransform& a_from_b) {
  const SixParameters six = six_from_rigid(a_from_b);
  PerParameter<double> values;
  values[Parameter::X] = six.x_m;
  values[Parameter::Y] = six.y_m;
  values[Parameter::Z] = six.z_m;
  values[Parameter::Yaw] = six.yaw_rad;
  values[Parameter::Pitch] = six.pitch_rad;
  values[Parameter::Roll] = six.roll_rad;
  return values;
}

RigidTransform rigid_of(const PerParameter<double>& parameters) {
  return rigid_from_six({parameters[Parameter::X], parameters[Parameter::Y], parameters[Parameter::Z],
                         parameters[Parameter::Yaw], parameters[Parameter::Pitch], parameters[Parameter::Roll]});
}

RigidTransform with_kept(const RigidTransform& found, const RigidTransform& other, ParameterSet kept) {
  if (kept.empty()) return found;
  PerParameter<double> values = parameters_of(found);
  const PerParameter<double> others = parameters_of(other);
  for (const Parameter parameter : kParameters)
    if (kept.contains(parameter)) values[parameter] = others[parameter];
  return rigid_of(values);
}

}  // namespace remount::calibration
