#include "model/guesses/motion_parts.h"

#include <algorithm>

namespace remount::guesses {

MotionPart motion_part_of(const SampledTable& table) {
  const ColumnNames names = names_of(table);
  const auto has = [&](Quantity quantity) { return number_column(table, names, quantity).has_value(); };
  const bool angles = has(Quantity::Roll) && has(Quantity::Pitch) && (has(Quantity::Heading) || has(Quantity::Yaw));
  const bool attitude = angles || (has(Quantity::Qx) && has(Quantity::Qy) && has(Quantity::Qz) && has(Quantity::Qw));
  const bool height = has(Quantity::Height) || has(Quantity::SeaHeight) || has(Quantity::Up) || has(Quantity::Z);
  const bool position = has(Quantity::Latitude) && has(Quantity::Longitude) && height;
  if (position == attitude) return MotionPart::None;
  return position ? MotionPart::Positions : MotionPart::Attitudes;
}

}  // namespace remount::guesses
