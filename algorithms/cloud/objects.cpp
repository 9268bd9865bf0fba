#include "algorithms/cloud/objects.h"

namespace remount {

std::string_view to_string(ObjectShape shape) {
  switch (shape) {
    case ObjectShape::Pole:
      return "pole";
    case ObjectShape::Facade:
      return "facade";
    case ObjectShape::VehicleSized:
      return "vehicle-sized";
    case ObjectShape::Small:
      return "small";
    case ObjectShape::Large:
      return "large";
  }
  return "unknown";
}

}  // namespace remount
