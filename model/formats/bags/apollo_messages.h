// Messages of Apollo in records of Cyber, as the values that those of ROS are as well.
//
// Positions are UTM, in a zone that no message names; attitudes take the vehicle's axes (x right, y forward, z up) to
// east, north and up, true north: Apollo projects what the INS gives as latitude and longitude and leaves its attitude
// as it is, in Gps (its GNSS driver) and in LocalizationEstimate (of RTK and of its fusion) alike.
#pragma once

#include "model/formats/bags/cloud_message.h"
#include "model/formats/bags/correction_status.h"

namespace remount::bags {

/// apollo.localization.Gps or LocalizationEstimate.
bool is_apollo_pose(MessageKind kind);

/// Either of them; the world is "utm", the child what the frame of such poses is called in Apollo's transforms. Stamped
/// with its measurement_time, or, where it has none, that of its header.
PoseMessage read_apollo_pose(MessageReader& reader, MessageKind kind);
bool apollo_pose_has_orientation(MessageReader& reader, MessageKind kind);

/// apollo.drivers.gnss.GnssBestPose; its status as NavSatFix has it: 2 with whole ambiguities, 1 with corrections of
/// any other kind, 0 without, -1 none.
FixMessage read_apollo_fix(MessageReader& reader);

/// apollo.drivers.gnss.InsStat: NovAtel's type of the position.
CorrectionStatus read_apollo_status(MessageReader& reader);

/// apollo.transform.TransformStampeds.
std::vector<PoseMessage> read_apollo_transforms(MessageReader& reader);

/// How much stands behind the points of a cloud.
inline constexpr std::size_t kApolloCloudEnd = 64;

/// Stamp and frame of apollo.drivers.PointCloud. The stamp is the time of measurement, which is that of the last point;
/// it stands behind the points.
/// @param end the last bytes of the message, kApolloCloudEnd of them where it has as many. Nothing where it is not
/// among these.
std::optional<MessageHeader> read_apollo_scan_header(MessageReader& begin, std::string_view end);
/// Of a message that is there as a whole.
MessageHeader read_apollo_scan_header(MessageReader& whole);

/// By width and height, and by the first points. Throws Error as the above does.
CloudOutline read_apollo_outline(MessageReader& begin, std::string_view end);

/// Whether the name of a channel says that its clouds were compensated for the motion of the vehicle, or that they are
/// of several LiDARs that were made one.
bool is_of_compensator(std::string_view channel);
bool is_of_fusion(std::string_view channel);

formats::ReadCloud read_apollo_cloud(MessageReader& reader, std::int64_t stamp_ns, formats::PointTimes times);

}  // namespace remount::bags
