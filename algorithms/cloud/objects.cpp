#include "algorithms/cloud/objects.h"

#include "messages/drives.h"

namespace remount::cloud {

Message shape_word(ObjectShape shape) {
  switch (shape) {
    case ObjectShape::Pole:
      return say::shape_pole();
    case ObjectShape::Facade:
      return say::shape_facade();
    case ObjectShape::VehicleSized:
      return say::shape_vehicle_sized();
    case ObjectShape::Small:
      return say::shape_small();
    case ObjectShape::Large:
      return say::shape_large();
  }
  return {};
}

}  // namespace remount::cloud
