// Messages of the drivers of single makers: fixes, attitudes and whole solutions of an INS, as the common ones have
// them.
#pragma once

#include <optional>

#include "model/formats/bags/ros_messages.h"
#include "model/formats/ins/ncom_file.h"

namespace remount::bags {

/// NavSatFix, gps_common's and gps_msgs' GPSFix, or sbg_driver's SbgEkfNav, whose height is above the ellipsoid with
/// its undulation. A position that the maker calls invalid is no fix (status -1).
FixMessage read_any_fix(MessageReader& reader, MessageKind kind);

/// Imu, autoware_sensing_msgs' GnssInsOrientationStamped, or sbg_driver's SbgEkfQuat and SbgEkfEuler; these have no
/// orientation while the INS calls attitude or heading invalid, and are read as forward-right-down of north-east-down
/// (has_open_axes).
ImuMessage read_attitude(MessageReader& reader, MessageKind kind);

/// Whether a driver writes its attitudes either as forward-right-down of north-east-down or as forward-left-up of
/// east-north-up, as it is configured, and no message says which: of sbg_driver and septentrio_gnss_driver. They are
/// read as the former; to be the latter they are turned by enu_from_ins(NedFromBody), which is its own inverse.
bool has_open_axes(MessageKind kind);
/// Early versions of the drivers write SbgEkfQuat of north-west-up, and take pi / 2 for degrees in the heading of
/// INSNavGeod, where they mean east-north-up: what their world is to be turned by about up. 0 for other messages.
double early_enu_turn_rad(MessageKind kind);
/// What such a driver writes unless it is told otherwise.
bool writes_enu_by_itself(MessageKind kind);

/// A whole solution of an INS other than NovAtel's, stamped with GPS time as UTC; nothing where the INS has none yet.
/// INSNavGeod of septentrio_gnss_driver; NavigationSolutionGsof49 of applanix_msgs, whose errors are in
/// NavigationPerformanceGsof50; Ncom of oxts_msgs, whose errors come in other packets of the same topic, which `errors`
/// keeps.
std::optional<InspvaxMessage> read_solution(MessageReader& reader, MessageKind kind, formats::NcomErrors& errors);

/// NavigationPerformanceGsof50.
formats::StampedSigma read_gsof50(MessageReader& reader);

}  // namespace remount::bags
