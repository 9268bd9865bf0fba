#include "model/simulator/bag_drive.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/error.h"
#include "algorithms/core/parallel.h"
#include "algorithms/geodesy/geodesy.h"
#include "messages/simulation.h"
#include "messages/stages.h"
#include "model/drive/session_frames.h"
#include "model/formats/bags/apollo_writer.h"
#include "model/formats/bags/bag_writer.h"
#include "model/formats/bags/packet_messages.h"
#include "model/simulator/novatel_drive.h"

namespace remount::simulator {
namespace {

constexpr std::size_t kScansAtOnce = 16;

/// Messages that wait for their turn; small beside the scans.
struct Waiting {
  std::int64_t stamp_ns = 0;
  std::uint32_t topic = 0;
  std::string bytes;
};

Eigen::Matrix3d position_covariance(const drive::Session& session, const motion::InsSample& sample) {
  Eigen::Vector3d sigma = sample.sigma.position_enu_m;
  if (!sigma.allFinite()) sigma.setConstant(session.ins_position_white_sigma_m);
  return sigma.allFinite() && sigma.minCoeff() > 0.0
             ? Eigen::Matrix3d(sigma.cwiseAbs2().asDiagonal())
             : Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
}

void add_novatel_messages(const drive::Session& session, bags::BagWriter& bag, std::vector<Waiting>& messages) {
  const bags::MessageEncoding encoding = bag.encoding();
  const std::uint32_t solution =
      bag.add_topic("/novatel/oem7/inspva", bags::message_definition("novatel_oem7_msgs/INSPVA", encoding));
  const std::uint32_t errors =
      bag.add_topic("/novatel/oem7/insstdev", bags::message_definition("novatel_oem7_msgs/INSSTDEV", encoding));
  const std::vector<NovatelMoment> moments = novatel_moments(session);
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const motion::InsSample& sample = session.ins[i];
    const NovatelMoment& moment = moments[i];
    bags::InspvaContent content{sample.stamp_ns,         sample.latitude_rad, sample.longitude_rad, sample.height_m,
                                moment.velocity_enu_mps, moment.roll_deg,     moment.pitch_deg,     moment.azimuth_deg};
    content.ins_status = sample.quality == motion::InsQuality::Degraded ? 2 : 3;
    messages.push_back({sample.stamp_ns, solution, bags::inspva_message(content, "gps", encoding)});
    if (!begins_second(session, i)) continue;
    messages.push_back({sample.stamp_ns, errors,
                        bags::insstdev_message(sample.stamp_ns, moment.position_sigma_enu_m, moment.attitude_sigma_deg,
                                               "gps", encoding)});
  }
}

void add_ins_messages(const drive::Session& session, bags::BagWriter& bag, std::vector<Waiting>& messages) {
  const bags::MessageEncoding encoding = bag.encoding();
  const std::uint32_t attitude = bag.add_topic("/ins/imu", bags::message_definition("sensor_msgs/Imu", encoding)),
                      position = bag.add_topic("/ins/fix", bags::message_definition("sensor_msgs/NavSatFix", encoding));
  for (const motion::InsSample& sample : session.ins) {
    messages.push_back({sample.stamp_ns, attitude,
                        bags::attitude_message(sample, session.ins_attitude_white_sigma_rad, "ins", encoding)});
    const motion::GnssFix fix{sample.stamp_ns, sample.latitude_rad, sample.longitude_rad, sample.height_m,
                              position_covariance(session, sample)};
    const int status = sample.quality == motion::InsQuality::Degraded ? 0 : 2;
    messages.push_back({sample.stamp_ns, position, bags::fix_message(fix, status, "ins", encoding)});
  }
}

void add_ros_messages(const drive::Session& session, bags::BagWriter& bag, bool novatel,
                      std::vector<Waiting>& messages) {
  novatel ? add_novatel_messages(session, bag, messages) : add_ins_messages(session, bag, messages);
  const bags::MessageEncoding encoding = bag.encoding();
  const auto topic = [&](const char* name, const char* type) {
    return bag.add_topic(name, bags::message_definition(type, encoding));
  };
  if (!session.imu.empty()) {
    const std::uint32_t imu = topic("/imu/data", "sensor_msgs/Imu");
    for (const motion::ImuSample& sample : session.imu)
      messages.push_back({sample.stamp_ns, imu, bags::imu_message(sample, "imu", encoding)});
  }
  if (!session.gnss.empty()) {
    const std::uint32_t gnss = topic("/gnss/fix", "sensor_msgs/NavSatFix");
    for (const motion::GnssFix& fix : session.gnss)
      messages.push_back({fix.stamp_ns, gnss, bags::fix_message(fix, 2, "antenna", encoding)});
  }
}

/// As its GNSS driver projects and turns what the INS gives.
void add_apollo_messages(const drive::Session& session, bags::BagWriter& bag, std::vector<Waiting>& messages) {
  if (session.ins.empty()) throw Error(ErrorCode::Contract, "apollo-record", say::simulation_no_ins_to_write());
  const auto topic = [&](const char* name, const char* type) {
    return bag.add_topic(name, bags::apollo_definition(type));
  };
  const std::uint32_t poses = topic("/apollo/sensor/gnss/odometry", "apollo.localization.Gps"),
                      states = topic("/apollo/sensor/gnss/ins_stat", "apollo.drivers.gnss.InsStat");
  // NovAtel's types of a position: with whole ambiguities, and without; of the receiver alone.
  constexpr unsigned kFixed = 56, kFloating = 55, kReceiver = 50;
  const geodesy::UtmGrid grid(session.ins.front().latitude_rad, session.ins.front().longitude_rad);
  const Eigen::Quaterniond flu_from_rfu(drive::forward_left_up_from(drive::InsAxes::RightForwardUp).linear());
  for (std::size_t i = 0; i < session.ins.size(); ++i) {
    const motion::InsSample& sample = session.ins[i];
    const geodesy::GridFix place = grid.project(sample.latitude_rad, sample.longitude_rad);
    messages.push_back({sample.stamp_ns, poses,
                        bags::apollo_gps_message({sample.stamp_ns,
                                                  {place.easting_m, place.northing_m, sample.height_m},
                                                  sample.enu_from_ins * flu_from_rfu})});
    if (!begins_second(session, i)) continue;
    const unsigned type = sample.quality == motion::InsQuality::Degraded ? kFloating : kFixed;
    messages.push_back({sample.stamp_ns, states, bags::apollo_status_message(sample.stamp_ns, type)});
  }
  if (session.gnss.empty()) return;
  const std::uint32_t fixes = topic("/apollo/sensor/gnss/best_pose", "apollo.drivers.gnss.GnssBestPose");
  for (const motion::GnssFix& fix : session.gnss)
    messages.push_back({fix.stamp_ns, fixes, bags::apollo_fix_message(fix, kReceiver)});
}

bool is_of_apollo(const bags::BagWriter& bag) { return bag.encoding() == bags::MessageEncoding::Protobuf; }

std::vector<Waiting> other_messages(const drive::Session& session, bags::BagWriter& bag, bool novatel) {
  std::vector<Waiting> messages;
  is_of_apollo(bag) ? add_apollo_messages(session, bag, messages) : add_ros_messages(session, bag, novatel, messages);
  std::stable_sort(messages.begin(), messages.end(),
                   [](const Waiting& a, const Waiting& b) { return a.stamp_ns < b.stamp_ns; });
  return messages;
}

std::unique_ptr<bags::BagWriter> make_writer(const std::filesystem::path& folder, const std::string& format) {
  if (format.starts_with("mcap"))
    return bags::make_mcap_writer(folder / "drive.mcap", bags::MessageEncoding::Cdr, bags::ChunkCompression::Zstd);
  if (format == "apollo-record") return bags::make_record_writer(folder / "drive.record.00000");
  if (format == "rosbag2") return bags::make_sqlite_writer(folder / "drive.db3");
  return bags::make_rosbag1_writer(folder / "drive.bag", bags::ChunkCompression::Lz4);
}

/// How the driver of a sensor publishes its packets.
struct PacketTopicOfDriver {
  const CapturedSensor* sensor;
  const char *topic, *type;
  bool a_turn;              ///< one message holds the packets of a turn
  bool stamped_packets;     ///< each with its time; else the message has that of its first point, and no packet one
  const char* description;  ///< the topic of what lies beside a capture; null: there is none
  bool described_in_bytes;
};
const PacketTopicOfDriver kPacketTopics[] = {
    {&kPuck, "/velodyne_packets", "velodyne_msgs/VelodyneScan", true, true, nullptr, false},
    {&kOusterHead, "/ouster/lidar_packets", "ouster_sensor_msgs/PacketMsg", false, true, "/ouster/metadata", false},
    {&kHesaiSpinner, "/lidar_packets", "hesai_ros_driver/UdpFrame", true, false, "/lidar_corrections", true},
    {&kHelios, "/rslidar_packets", "rslidar_msg/RslidarPacket", false, true, nullptr, false}};

/// @param sent in the order of their times
std::vector<Waiting> packet_messages(const CapturedSensor& sensor, const SimulationOptions& options,
                                     const std::vector<SentDatagram>& sent, bags::BagWriter& bag) {
  const auto driver = std::ranges::find(kPacketTopics, &sensor, &PacketTopicOfDriver::sensor);
  const bags::MessageEncoding encoding = bag.encoding();
  const std::uint32_t topic = bag.add_topic(driver->topic, bags::message_definition(driver->type, encoding));
  const bags::PacketLayout layout = bags::packet_layout(std::string_view(driver->type));
  std::vector<Waiting> messages;
  if (driver->description != nullptr && !sent.empty()) {
    const char* type = driver->described_in_bytes ? "std_msgs/UInt8MultiArray" : "std_msgs/String";
    const std::string text = sensor.description(options);
    messages.push_back(
        {sent.front().time_ns, bag.add_topic(driver->description, bags::message_definition(type, encoding)),
         driver->described_in_bytes ? bags::bytes_message(text, encoding) : bags::text_message(text, encoding)});
  }
  // Drivers of lists read the port of the points alone.
  const std::uint16_t only_port = driver->a_turn ? port_of_points(sent) : std::uint16_t{0};
  const auto in_message = driver->a_turn
                              ? static_cast<std::size_t>(std::ceil(static_cast<double>(sensor.packets(options)) /
                                                                   (options.duration_s * options.scan_rate_hz)))
                              : std::size_t{1};
  std::vector<bags::PacketLayout::Packet> packets;
  std::int64_t first_ns = 0, last_ns = 0;
  const auto publish = [&](std::int64_t time_ns) {
    if (!packets.empty()) messages.push_back({time_ns, topic, layout.write(packets, "lidar", encoding, first_ns)});
    packets.clear();
  };
  for (const SentDatagram& one : sent) {
    if (driver->a_turn && one.port != only_port) continue;
    if (packets.empty()) first_ns = one.time_ns;
    packets.push_back({driver->stamped_packets ? one.time_ns : 0, one.payload});
    last_ns = one.time_ns;
    if (packets.size() == in_message) publish(one.time_ns);
  }
  publish(last_ns);
  return messages;
}

/// A LiDAR's scans on their way into a bag.
struct ScanTopic {
  const drive::ScanSource* scans = nullptr;
  std::string topic, frame;
  std::optional<RigidTransform> nominal_ins_from_lidar = {};
  std::uint32_t id = 0;  ///< of the topic in the bag
};

std::string scan_message(const ScanTopic& lidar, std::size_t scan, bags::MessageEncoding encoding) {
  const cloud::PointCloud cloud = lidar.scans->load(scan);
  const std::int64_t stamp_ns = lidar.scans->stamp_ns(scan);
  return encoding == bags::MessageEncoding::Protobuf ? bags::apollo_cloud_message(cloud, stamp_ns, lidar.frame)
                                                     : bags::cloud_message(cloud, stamp_ns, lidar.frame, encoding);
}

bags::MessageDefinition scan_definition(bags::MessageEncoding encoding) {
  return encoding == bags::MessageEncoding::Protobuf ? bags::apollo_definition("apollo.drivers.PointCloud")
                                                     : bags::message_definition("sensor_msgs/PointCloud2", encoding);
}

/// The nominal mountings as Apollo's vehicle has them: children of the frame of its INS.
void add_apollo_transforms(const std::vector<ScanTopic>& lidars, std::int64_t begin_ns, bags::BagWriter& bag,
                           std::vector<Waiting>& messages) {
  const RigidTransform rfu_from_flu = drive::forward_left_up_from(drive::InsAxes::RightForwardUp).inverse();
  std::vector<bags::PoseMessage> transforms;
  for (const ScanTopic& lidar : lidars)
    if (lidar.nominal_ins_from_lidar)
      transforms.push_back({{0, "novatel"}, lidar.frame, rfu_from_flu * *lidar.nominal_ins_from_lidar});
  if (transforms.empty()) return;
  const std::uint32_t topic =
      bag.add_topic("/tf_static", bags::apollo_definition("apollo.transform.TransformStampeds"));
  messages.insert(messages.begin(), {begin_ns, topic, bags::apollo_transforms_message(transforms)});
}

struct ScanOfTopic {
  std::size_t lidar = 0, scan = 0;
  std::int64_t stamp_ns = 0;
};

/// Of all LiDARs, in the order of their times.
std::vector<ScanOfTopic> scans_in_order(const std::vector<ScanTopic>& lidars) {
  std::vector<ScanOfTopic> order;
  for (std::size_t lidar = 0; lidar < lidars.size(); ++lidar)
    for (std::size_t scan = 0; scan < lidars[lidar].scans->size(); ++scan)
      order.push_back({lidar, scan, lidars[lidar].scans->stamp_ns(scan)});
  std::stable_sort(order.begin(), order.end(),
                   [](const ScanOfTopic& a, const ScanOfTopic& b) { return a.stamp_ns < b.stamp_ns; });
  return order;
}

/// @param session of the INS and the other sensors
void write_bag(const drive::Session& session, std::vector<ScanTopic> lidars, const std::filesystem::path& folder,
               const std::string& format, int threads, Progress& progress) {
  const std::unique_ptr<bags::BagWriter> bag = make_writer(folder, format);
  for (ScanTopic& lidar : lidars) lidar.id = bag->add_topic(lidar.topic, scan_definition(bag->encoding()));
  std::vector<Waiting> others = other_messages(session, *bag, format.ends_with("novatel"));
  if (is_of_apollo(*bag)) add_apollo_transforms(lidars, others.front().stamp_ns, *bag, others);
  std::size_t next = 0;
  const auto write_until = [&](std::int64_t stamp_ns) {
    for (; next < others.size() && others[next].stamp_ns <= stamp_ns; ++next)
      bag->write(others[next].topic, others[next].stamp_ns, others[next].bytes);
  };
  const std::vector<ScanOfTopic> order = scans_in_order(lidars);
  for (std::size_t from = 0; from < order.size(); from += kScansAtOnce) {
    std::vector<std::string> messages(std::min(kScansAtOnce, order.size() - from));
    parallel_for(messages.size(), threads, [&](std::size_t i) {
      if (progress.cancelled()) return;
      messages[i] = scan_message(lidars[order[from + i].lidar], order[from + i].scan, bag->encoding());
    });
    if (progress.cancelled()) return;
    progress.report(say::stage_writing_scans, from, order.size());
    for (std::size_t i = 0; i < messages.size(); ++i) {
      write_until(order[from + i].stamp_ns);
      bag->write(lidars[order[from + i].lidar].id, order[from + i].stamp_ns, messages[i]);
    }
  }
  write_until(std::numeric_limits<std::int64_t>::max());
  bag->finish();
}

}  // namespace

void write_packet_bag(const CapturedSensor& sensor, const SimulatedDrive& drive, const std::filesystem::path& folder,
                      const std::string& format, int threads, Progress& progress) {
  const SimulationOptions& options = scene_without_lidar(drive, sensor).options();
  const std::vector<SentDatagram> sent = sent_datagrams(sensor, drive, threads, progress);
  if (progress.cancelled()) return;
  const std::unique_ptr<bags::BagWriter> bag = make_writer(folder, format);
  std::vector<Waiting> messages = other_messages(drive.session, *bag, false);
  for (Waiting& message : packet_messages(sensor, options, sent, *bag)) messages.push_back(std::move(message));
  std::ranges::stable_sort(messages, {}, &Waiting::stamp_ns);
  for (const Waiting& message : messages) bag->write(message.topic, message.stamp_ns, message.bytes);
  bag->finish();
}

void write_bag_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, const std::string& format,
                     int threads, Progress& progress) {
  const std::string topic = format == "apollo-record" ? "/apollo/sensor/lidar/PointCloud2" : "/lidar/points";
  write_bag(drive.session, {{drive.session.scans.get(), topic, "lidar", drive.session.nominal_ins_from_lidar}}, folder,
            format, threads, progress);
}

void write_bag_vehicle(const SimulatedVehicle& vehicle, const std::filesystem::path& folder, const std::string& format,
                       int threads, Progress& progress) {
  std::vector<ScanTopic> lidars;
  for (const SimulatedDrive& drive : vehicle.lidars) {
    const std::string& name = drive.session.lidar_name;
    const std::string topic =
        format == "apollo-record" ? "/apollo/sensor/" + name + "/PointCloud2" : "/lidar_" + name + "/points";
    lidars.push_back({drive.session.scans.get(), topic, name, drive.session.nominal_ins_from_lidar});
  }
  write_bag(vehicle.lidars.front().session, std::move(lidars), folder, format, threads, progress);
}

}  // namespace remount::simulator
