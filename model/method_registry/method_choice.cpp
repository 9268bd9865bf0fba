#include "model/method_registry/method_choice.h"

#include <algorithm>
#include <stdexcept>

namespace remount::method_registry {

MethodChoice::MethodChoice(std::string_view id) {
  const auto methods = calibration_methods();
  place_ = static_cast<int>(std::find(methods.begin(), methods.end(), &calibration_method(id)) - methods.begin());
}

const CalibrationMethod& MethodChoice::operator*() const {
  const auto methods = calibration_methods();
  const auto place = static_cast<std::size_t>(place_);
  if (place >= methods.size()) throw std::out_of_range("MethodChoice");
  return *methods[place];
}

std::vector<std::string_view> method_ids() {
  std::vector<std::string_view> ids;
  for (const CalibrationMethod* method : calibration_methods()) ids.push_back(method->id);
  return ids;
}

}  // namespace remount::method_registry
