// Scans in messages: sensor_msgs/PointCloud2 of any layout, and Livox's own message.
#pragma once

#include "algorithms/cloud/point_cloud.h"
#include "model/io/bag/ros_messages.h"

namespace remount {

/// A scan, with what is to be known of its times.
struct CloudMessage {
  PointCloud cloud;
  /// The points' own times are absolute and more than a second off the stamp: the stamp is of another clock. They are
  /// taken from the scan's first point on then, as if that had been taken at the stamp.
  bool points_have_another_clock = false;
};

/// Fields by name in any order, of any type and offset, in either byte order; names and the units of times as
/// find_cloud_columns and CloudBuilder::finish have them: `time` in seconds from the stamp (Velodyne), `t` in
/// nanoseconds from it (Ouster), `timestamp` in seconds (Hesai, RoboSense) or nanoseconds (Livox) since 1970,
/// `offset_time` in nanoseconds. @param stamp_ns the stamp that the scan has in the session
CloudMessage read_cloud(MessageReader& reader, MessageKind kind, std::int64_t stamp_ns);

/// How many points a message promises and whether it has times of points or rings, from its beginning.
struct CloudOutline {
  MessageHeader header;
  std::uint64_t points = 0;
  bool timed = false, ringed = false;
};
CloudOutline read_cloud_outline(MessageReader& reader, MessageKind kind);

}  // namespace remount
