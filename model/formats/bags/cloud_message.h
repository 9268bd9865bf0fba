// Scans in messages: sensor_msgs/PointCloud2 of any layout, Livox's own message, and Apollo's.
#pragma once

#include "model/formats/bags/ros_messages.h"
#include "model/formats/clouds/cloud_file.h"

namespace remount::bags {

/// Fields by name in any order, of any type and offset, in either byte order; names and the units of times as
/// find_cloud_columns and find_time_scale have them: `time` in seconds from the stamp (Velodyne), `t` in
/// nanoseconds from it (Ouster), `timestamp` in seconds (Hesai, RoboSense) or nanoseconds (Livox) since 1970 or the
/// sensor's start, `offset_time` in nanoseconds; of apollo.drivers.PointCloud in nanoseconds since 1970. Columns that
/// are used share no byte with another. @param stamp_ns the stamp that the scan has in the session
formats::ReadCloud read_cloud(MessageReader& reader, MessageKind kind, std::int64_t stamp_ns,
                              formats::PointTimes times = formats::PointTimes::Used);

/// How many points a message promises and whether it has times of points or rings, from its beginning.
struct CloudOutline {
  MessageHeader header;
  std::uint64_t points = 0;
  bool timed = false, ringed = false;
};
/// Of a cloud of ROS.
CloudOutline read_cloud_outline(MessageReader& reader, MessageKind kind);

}  // namespace remount::bags
