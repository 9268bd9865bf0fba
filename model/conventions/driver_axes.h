// Attitudes of drivers that write them in either of two conventions and do not say in which.
#pragma once

#include <optional>
#include <vector>

#include "model/drive/session.h"

namespace remount::conventions {

/// Whether attitudes that were read as forward-right-down of north-east-down are in truth forward-left-up of
/// east-north-up: under the right convention a vehicle keeps to one direction of its INS, under the other it does so on
/// a straight road alone. There the one counts under which it goes ahead. Nothing where the vehicle hardly moves.
std::optional<bool> are_east_north_up(const std::vector<motion::InsSample>& read_as_ned);

}  // namespace remount::conventions
