// Tables that hold one part of a motion: positions of an INS in one, its attitudes in another.
#pragma once

#include <cstddef>

#include "model/guesses/named_columns.h"

namespace remount::guesses {

enum class MotionPart { None, Positions, Attitudes };

/// A time and three of a position, or three angles, at least.
inline constexpr std::size_t kFewestColumnsOfPart = 4;

/// By the names of the columns alone: numbers without names tell too little where each stands for itself.
MotionPart motion_part_of(const SampledTable& table);

}  // namespace remount::guesses
