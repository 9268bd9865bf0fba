// What methods tell beside the mounting.
#pragma once

#include <string_view>
#include <vector>

#include "algorithms/calibration/method_details.h"

namespace remount::testing {

/// Null where there is none of that id.
inline const calibration::NamedQuantity* quantity_of(const std::vector<calibration::NamedQuantity>& quantities,
                                                     std::string_view id) {
  for (const calibration::NamedQuantity& quantity : quantities)
    if (quantity.id == id) return &quantity;
  return nullptr;
}

}  // namespace remount::testing
