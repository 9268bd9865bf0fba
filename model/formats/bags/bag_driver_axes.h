// Axes of drivers that write either of two conventions and do not say which: settled by the drive as a whole.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/drive/session.h"
#include "model/formats/bags/bag_streams.h"
#include "model/formats/ins/samples_between_fixes.h"

namespace remount::bags {

/// Turns the attitudes of a driver of has_open_axes as the direction of travel tells, or else as the driver writes by
/// itself; which of them becomes a finding, a warning where another fits as well. @return whether the driver writes
/// east-north-up, nothing where the travel does not tell
std::optional<bool> settle_driver_axes(MessageKind kind, const std::string& where,
                                       std::vector<formats::StampedAttitude>& attitudes, drive::Session& session);

/// Errors of positions of SbgEkfNav, which are read as north, east: they are east, north where sbg_driver writes
/// east-north-up. Where nobody knows, the larger counts for both.
void settle_sbg_errors(std::optional<bool> enu, std::vector<motion::InsSample>& ins);
void settle_sbg_errors(std::optional<bool> enu, FixStream& fixes);

}  // namespace remount::bags
