// The streams of a bag, as far as they are read when it is opened.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "model/drive/stamped_streams.h"
#include "model/formats/bags/bag_packets.h"
#include "model/formats/bags/correction_status.h"
#include "model/formats/bags/ros_messages.h"
#include "model/formats/bags/topic_roles.h"

namespace remount::bags {

/// A message's own stamp beside the time at which the recorder took it down.
struct ClockReading {
  std::int64_t stamp_ns = 0, log_time_ns = 0;
};

/// Stamps of the messages of one topic. Where the messages have none, they are the recorder's.
struct StreamClock {
  std::vector<ClockReading> readings;
  /// Median of log time minus stamp: delay of the recorder, and what the clocks are apart.
  double behind_s() const;
};

struct PoseStream {
  StreamClock clock;
  std::vector<motion::StampedPose> world_from_child;
  std::string frame, child_frame;
};
template <class Message>
struct MessageStream {
  StreamClock clock;
  std::vector<Message> messages;
};
using ImuStream = MessageStream<ImuMessage>;
using FixStream = MessageStream<FixMessage>;
using InspvaxStream = MessageStream<InspvaxMessage>;
using InsstdevStream = MessageStream<formats::StampedSigma>;
/// The scans' stamps; `index` counts the entries of the topic.
struct ScanStream {
  StreamClock clock;
  std::vector<drive::IndexedScan> scans;
  std::string frame;
  /// How long after its stamp a scan ends, by the times of its points, or else by its period. No recorder takes it down
  /// before.
  double ends_after_s = 0.0;
};

/// What the chosen topics hold, scans by their stamps only.
struct BagStreams {
  ScanStream scans;
  std::unique_ptr<PacketStream> packets;  ///< of which scans are to be made, where the LiDAR has these
  formats::SensorReceiver receiver;       ///< that such a LiDAR hangs on
  std::int64_t ins_moved_ns = 0;          ///< onto the LiDAR's clock: so is what has the INS's clock and no topic
  PoseStream lidar_poses;
  PoseStream ins_poses;
  InspvaxStream inspvax;         ///< or INSPVA, or the whole solution of another make
  InspvaxStream inspvax_beside;  ///< of the same INS, where INSPVA serves, which states no errors
  InsstdevStream insstdev;       ///< likewise; or beside GSOF 49
  ImuStream attitude;            ///< the IMU that serves as `ins`
  FixStream position;
  FixStream gnss;
  std::string ins_sentences, gnss_sentences;  ///< of NMEA, a line each, where topics of sentences serve
  ImuStream imu;
  std::vector<CorrectionStatus> position_types;  ///< of an INS whose poses do not say them
  std::vector<PoseMessage> static_transforms;
};

/// Reads all of it in one way through the bag, so that each chunk is unpacked once. `chosen` outlives it. Messages that
/// cannot be read become findings. Returns early where `progress` is cancelled.
BagStreams read_streams(const BagFile& bag, const ChosenTopics& chosen, std::vector<drive::Finding>& findings,
                        Progress& progress);

}  // namespace remount::bags
