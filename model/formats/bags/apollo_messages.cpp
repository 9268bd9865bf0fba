#include "model/formats/bags/apollo_messages.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/core/error.h"
#include "messages/bags.h"
#include "messages/records.h"
#include "model/conventions/impossible_motion.h"
#include "model/drive/plausible_values.h"
#include "model/formats/bags/proto_reader.h"
#include "model/formats/bags/topic_names.h"
#include "model/formats/clouds/cloud_fields.h"
#include "model/formats/files/time_stamp.h"

namespace remount::bags {
namespace {

constexpr double kNotThere = std::numeric_limits<double>::quiet_NaN();
constexpr std::int64_t kSecond = 1'000'000'000;

[[noreturn]] void fail_apollo(const MessageReader& reader, Message what) {
  throw Error(ErrorCode::Format, reader.where(), std::move(what));
}

/// All of a message.
std::string_view proto_bytes(MessageReader& reader) {
  if (reader.encoding() != MessageEncoding::Protobuf)
    throw Error(ErrorCode::Unsupported, reader.where(), say::bag_message_encoding());
  return reader.bytes(reader.left());
}

void take_real(const ProtoReader& fields, double& to) { to = fields.real().value_or(to); }

/// Numbers 1 to 3 of Point3D and PointENU, 1 to 4 of Quaternion: qx, qy, qz, qw.
template <int N>
Eigen::Matrix<double, N, 1> read_numbers(std::string_view bytes, std::string_view where) {
  Eigen::Matrix<double, N, 1> numbers = Eigen::Matrix<double, N, 1>::Constant(kNotThere);
  for (ProtoReader fields(bytes, where); fields.next();)
    if (fields.field() <= N) take_real(fields, numbers[static_cast<Eigen::Index>(fields.field()) - 1]);
  return numbers;
}

/// apollo.common.Header.
struct ApolloHeader {
  double published_s = 0.0;    ///< or, of the GNSS driver's Gps, measured
  std::uint64_t lidar_ns = 0;  ///< when a LiDAR measured it, to the nanosecond
  std::string frame;
};
ApolloHeader read_apollo_header(std::string_view bytes, std::string_view where,
                                ProtoReader::End end = ProtoReader::End::Whole) {
  constexpr std::uint32_t kTimestamp = 1, kLidarTimestamp = 4, kFrame = 9;
  ApolloHeader header;
  for (ProtoReader fields(bytes, where, end); fields.next();) {
    if (fields.field() == kTimestamp) take_real(fields, header.published_s);
    if (fields.field() == kLidarTimestamp) header.lidar_ns = fields.whole().value_or(0);
    if (fields.field() == kFrame) header.frame = fields.bytes().value_or(std::string_view());
  }
  return header;
}

/// Whole seconds and the rest apart, which one product would round.
std::int64_t ns_from_s(double time_s, const std::string& where) {
  constexpr double kMost_s = 4.1e9;  // year 2099: differences of times do not overflow
  if (!(time_s >= 0.0 && time_s <= kMost_s)) throw Error(ErrorCode::Format, where, say::apollo_time_impossible());
  const double whole_s = std::floor(time_s);
  return static_cast<std::int64_t>(whole_s) * kSecond + std::llround((time_s - whole_s) * 1e9);
}

/// When something was measured. Some of Apollo's messages count from the beginning of GPS time, as their receiver does:
/// the header, which does not, tells.
std::int64_t measured_ns(double measured_s, double published_s, const std::string& where) {
  constexpr std::int64_t kNear = 30 * 86'400 * kSecond;
  if (!(measured_s > 0.0)) return ns_from_s(published_s, where);
  const std::int64_t measured = ns_from_s(measured_s, where);
  if (!(published_s > 0.0)) return measured;
  const std::int64_t published = ns_from_s(published_s, where);
  const std::int64_t by_gps = formats::unix_ns_from_gps_ns(measured);
  return std::abs(measured - published) > kNear && std::abs(by_gps - published) < kNear ? by_gps : measured;
}

// ---- Poses

struct ApolloPose {
  double measured_s = 0.0;
  ApolloHeader header;
  Eigen::Vector3d position_m = Eigen::Vector3d::Constant(kNotThere);
  Eigen::Vector4d orientation = Eigen::Vector4d::Constant(kNotThere);  ///< x, y, z, w
};

ApolloPose read_pose_fields(MessageReader& reader, MessageKind kind) {
  constexpr std::uint32_t kHeader = 1, kPose = 2, kMeasured = 4, kPlace = 1, kOrientation = 2;
  ApolloPose pose;
  std::string_view inner;
  for (ProtoReader fields(proto_bytes(reader), reader.where()); fields.next();) {
    if (fields.field() == kHeader)
      pose.header = read_apollo_header(fields.bytes().value_or(std::string_view()), reader.where());
    if (fields.field() == kPose) inner = fields.bytes().value_or(std::string_view());
    if (fields.field() == kMeasured && kind == MessageKind::ApolloLocalization) take_real(fields, pose.measured_s);
  }
  for (ProtoReader fields(inner, reader.where()); fields.next();) {
    const std::string_view bytes = fields.bytes().value_or(std::string_view());
    if (fields.field() == kPlace) pose.position_m = read_numbers<3>(bytes, reader.where());
    if (fields.field() == kOrientation) pose.orientation = read_numbers<4>(bytes, reader.where());
  }
  // A height that is not there is zero, and w may be left to the others.
  if (std::isnan(pose.position_m.z())) pose.position_m.z() = 0.0;
  const double others = pose.orientation.head<3>().squaredNorm();
  if (std::isnan(pose.orientation.w()) && others > 0.0 && others <= 1.0) pose.orientation.w() = std::sqrt(1.0 - others);
  return pose;
}

RigidTransform checked_rigid(const Eigen::Vector3d& position_m, const Eigen::Vector4d& orientation,
                             const MessageReader& reader) {
  if (!(std::abs(orientation.norm() - 1.0) < 0.1)) fail_apollo(reader, say::bag_orientation_not_unit());
  if (!position_m.allFinite()) fail_apollo(reader, say::apollo_no_position());
  if (!conventions::is_possible_position(position_m)) fail_apollo(reader, say::bag_position_too_far());
  return make_rigid(Eigen::Quaterniond(orientation.normalized()).toRotationMatrix(), position_m);
}

// ---- Fixes

/// As NavSatFix has it. NovAtel's numbers: 48 to 51 and 56 have whole ambiguities; what is set by hand (1, 2), found by
/// Doppler shifts (8), alone (16, 53) or carried on (19) has no corrections.
int status_of_fix(std::uint64_t solution, std::uint64_t type) {
  constexpr std::uint64_t kWithoutCorrections[] = {1, 2, 8, 16, 19, 53};
  if (solution != 0 || type == 0) return -1;
  if ((type >= 48 && type <= 51) || type == 56) return 2;
  return std::ranges::count(kWithoutCorrections, type) ? 0 : 1;
}

// ---- Clouds

constexpr std::uint32_t kCloudHeader = 1, kCloudFrame = 2, kCloudPoint = 4, kCloudMeasured = 5, kCloudWidth = 6,
                        kCloudHeight = 7;

/// What stands around the points.
struct CloudFrame {
  ApolloHeader header;
  std::string frame;
  double measured_s = 0.0;
  std::uint64_t width = 0, height = 0;
  std::size_t points_seen = 0;
  bool timed = false;  ///< those of them that were looked at
};

void take_cloud_end(const ProtoReader& fields, CloudFrame& frame) {
  if (fields.field() == kCloudMeasured) take_real(fields, frame.measured_s);
  if (fields.field() == kCloudWidth) frame.width = fields.whole().value_or(0);
  if (fields.field() == kCloudHeight) frame.height = fields.whole().value_or(0);
}

constexpr std::uint32_t kPointTimestamp = 5;

bool has_timestamp(std::string_view point, std::string_view where) {
  for (ProtoReader fields(point, where, ProtoReader::End::Cut); fields.next();)
    if (fields.field() == kPointTimestamp && fields.whole().value_or(0) > 0) return true;
  return false;
}

/// @param end of the bytes, whether the message goes on
CloudFrame read_cloud_frame(std::string_view bytes, const std::string& where, ProtoReader::End end) {
  constexpr std::size_t kLookedAt = 100;
  CloudFrame frame;
  for (ProtoReader fields(bytes, where, end); fields.next();) {
    const std::string_view inner = fields.bytes().value_or(std::string_view());
    if (fields.field() == kCloudHeader) frame.header = read_apollo_header(inner, where, end);
    if (fields.field() == kCloudFrame) frame.frame = inner;
    if (fields.field() == kCloudPoint && frame.points_seen++ < kLookedAt)
      frame.timed = frame.timed || has_timestamp(inner, where);
    take_cloud_end(fields, frame);
  }
  return frame;
}

/// What stands behind the last point: the time of measurement and, with it, width and height, and nothing else. Where
/// that begins is where the rest can be read so.
bool find_cloud_end(std::string_view end, CloudFrame& frame) {
  constexpr char kMeasuredTag = static_cast<char>(kCloudMeasured << 3U | 1U);
  constexpr double kFarApart_s = 86'400.0;
  for (std::size_t at = end.find(kMeasuredTag); at != std::string_view::npos; at = end.find(kMeasuredTag, at + 1)) try {
      CloudFrame found;
      bool fits = true;
      std::uint32_t before = 0;
      for (ProtoReader fields(end.substr(at), {}); fits && fields.next(); before = fields.field()) {
        fits = fields.field() > before && fields.field() >= kCloudMeasured && fields.field() <= kCloudHeight;
        take_cloud_end(fields, found);
      }
      const double published_s = frame.header.published_s;
      if (!fits || !(found.measured_s > 0.0)) continue;
      const auto far = [&](double epoch_s) {
        return !(std::abs(found.measured_s + epoch_s - published_s) < kFarApart_s);
      };
      if (published_s > 0.0 && far(0.0) && far(1e-9 * static_cast<double>(formats::kGpsEpoch_ns))) continue;
      frame.measured_s = found.measured_s, frame.width = found.width, frame.height = found.height;
      return true;
    } catch (const Error&) {
      continue;  // it was a byte of something else
    }
  return false;
}

/// The time of measurement is a number of seconds that has not a quarter of a microsecond; that of the header has it
/// all, where it is of the same moment.
MessageHeader header_of(const CloudFrame& frame, const std::string& where) {
  constexpr std::int64_t kSame = 1'000'000;
  // Transforms are looked up by that of the header; who fuses clouds leaves the other as it was.
  std::string_view name = frame.header.frame.empty() ? frame.frame : frame.header.frame;
  while (name.starts_with('/')) name.remove_prefix(1);
  MessageHeader header{0, std::string(name)};
  const auto lidar_ns = static_cast<std::int64_t>(
      std::min<std::uint64_t>(frame.header.lidar_ns, std::numeric_limits<std::int64_t>::max()));
  const bool lidar_there = lidar_ns > 0 && formats::is_stamp(lidar_ns);
  if (!(frame.measured_s > 0.0))
    header.stamp_ns = lidar_there ? lidar_ns : ns_from_s(frame.header.published_s, where);
  else
    header.stamp_ns = measured_ns(frame.measured_s, frame.header.published_s, where);
  if (lidar_there && std::abs(lidar_ns - header.stamp_ns) < kSame) header.stamp_ns = lidar_ns;
  return header;
}

/// x, y and z as floats behind their numbers.
constexpr std::size_t kLeastPoint = 15;

std::size_t possible_points(std::string_view bytes, const std::string& where) {
  std::size_t points = 0;
  for (ProtoReader fields(bytes, where); fields.next();)
    points += fields.field() == kCloudPoint && fields.bytes() && fields.length() >= kLeastPoint;
  return points;
}

/// The stamp as the points count: where the time of measurement counts from the beginning of GPS time, they do as well.
std::int64_t stamp_of_points_ns(const CloudFrame& frame, std::int64_t stamp_ns, const std::string& where) {
  if (!(frame.measured_s > 0.0)) return stamp_ns;
  const std::int64_t counted = ns_from_s(frame.measured_s, where);
  return stamp_ns + counted - measured_ns(frame.measured_s, frame.header.published_s, where);
}

formats::RawPoint read_point(std::string_view bytes, const std::string& where, std::int64_t stamp_ns) {
  constexpr std::uint32_t kX = 1, kY = 2, kZ = 3, kIntensity = 4;
  formats::RawPoint point{kNotThere, kNotThere, kNotThere};
  std::uint64_t time_ns = 0;
  for (ProtoReader fields(bytes, where); fields.next();) {
    if (fields.field() == kX) take_real(fields, point.x);
    if (fields.field() == kY) take_real(fields, point.y);
    if (fields.field() == kZ) take_real(fields, point.z);
    if (fields.field() == kIntensity) point.intensity = static_cast<double>(fields.whole().value_or(0));
    if (fields.field() == kPointTimestamp) time_ns = fields.whole().value_or(0);
  }
  // As whole numbers: of nanoseconds since 1970 a double has but every 256th.
  point.time = 1e-9 * static_cast<double>(static_cast<std::int64_t>(time_ns - static_cast<std::uint64_t>(stamp_ns)));
  return point;
}

}  // namespace

bool is_apollo_pose(MessageKind kind) {
  return kind == MessageKind::ApolloGps || kind == MessageKind::ApolloLocalization;
}

PoseMessage read_apollo_pose(MessageReader& reader, MessageKind kind) {
  const ApolloPose pose = read_pose_fields(reader, kind);
  PoseMessage message;
  message.header = {measured_ns(pose.measured_s, pose.header.published_s, reader.where()), "utm"};
  message.child_frame = kind == MessageKind::ApolloGps ? "novatel" : "localization";
  message.world_from_child = checked_rigid(pose.position_m, pose.orientation, reader);
  return message;
}

bool apollo_pose_has_orientation(MessageReader& reader, MessageKind kind) {
  const ApolloPose pose = read_pose_fields(reader, kind);
  return pose.orientation.allFinite() && pose.orientation.norm() > 0.0;
}

FixMessage read_apollo_fix(MessageReader& reader) {
  enum : std::uint32_t { kHeader = 1, kMeasured, kStatus, kType, kLatitude, kLongitude, kHeight, kUndulation };
  constexpr std::uint32_t kLatitudeError = 10, kLongitudeError = 11, kHeightError = 12;
  double measured_s = 0.0, latitude_deg = kNotThere, longitude_deg = kNotThere, height_m = kNotThere,
         undulation_m = 0.0;
  Eigen::Vector3d sigma_enu_m = Eigen::Vector3d::Zero();
  std::uint64_t solution = 0, type = 0;
  ApolloHeader header;
  for (ProtoReader fields(proto_bytes(reader), reader.where()); fields.next();) {
    const std::uint32_t field = fields.field();
    if (field == kHeader) header = read_apollo_header(fields.bytes().value_or(std::string_view()), reader.where());
    if (field == kMeasured) take_real(fields, measured_s);
    if (field == kStatus) solution = fields.whole().value_or(0);
    if (field == kType) type = fields.whole().value_or(0);
    if (field == kLatitude) take_real(fields, latitude_deg);
    if (field == kLongitude) take_real(fields, longitude_deg);
    if (field == kHeight) take_real(fields, height_m);
    if (field == kUndulation) take_real(fields, undulation_m);
    if (field == kLongitudeError) take_real(fields, sigma_enu_m.x());
    if (field == kLatitudeError) take_real(fields, sigma_enu_m.y());
    if (field == kHeightError) take_real(fields, sigma_enu_m.z());
  }
  FixMessage message;
  message.header = {measured_ns(measured_s, header.published_s, reader.where()), header.frame};
  message.latitude_rad = degrees_to_radians(latitude_deg), message.longitude_rad = degrees_to_radians(longitude_deg);
  message.height_m = height_m + undulation_m;
  message.status = status_of_fix(solution, type);
  message.position_type = std::to_string(type);
  if (sigma_enu_m.allFinite() && sigma_enu_m.minCoeff() > 0.0 && !drive::means_not_known(sigma_enu_m.maxCoeff()))
    message.covariance_enu_m2 = Eigen::Matrix3d(sigma_enu_m.cwiseAbs2().asDiagonal());
  if (message.status >= 0 && !drive::plausible_geodetic(message.latitude_rad, message.longitude_rad, message.height_m))
    fail_apollo(reader, say::bag_place_impossible());
  return message;
}

CorrectionStatus read_apollo_status(MessageReader& reader) {
  constexpr std::uint32_t kPositionType = 3;
  InspvaxMessage message;
  for (ProtoReader fields(proto_bytes(reader), reader.where()); fields.next();)
    if (fields.field() == kPositionType) message.position_type = std::to_string(fields.whole().value_or(0));
  return correction_status(message);
}

std::vector<PoseMessage> read_apollo_transforms(MessageReader& reader) {
  constexpr std::uint32_t kTransforms = 2, kHeader = 1, kChild = 2, kTransform = 3, kTranslation = 1, kRotation = 2;
  std::vector<PoseMessage> transforms;
  for (ProtoReader all(proto_bytes(reader), reader.where()); all.next();) {
    if (all.field() != kTransforms || !all.bytes()) continue;
    PoseMessage message;
    Eigen::Vector3d translation_m = Eigen::Vector3d::Constant(kNotThere);
    Eigen::Vector4d rotation = Eigen::Vector4d::Constant(kNotThere);
    for (ProtoReader fields(*all.bytes(), reader.where()); fields.next();) {
      const std::string_view bytes = fields.bytes().value_or(std::string_view());
      if (fields.field() == kHeader) message.header.frame = read_apollo_header(bytes, reader.where()).frame;
      if (fields.field() == kChild) message.child_frame = bytes;
      if (fields.field() != kTransform) continue;
      for (ProtoReader parts(bytes, reader.where()); parts.next();) {
        const std::string_view part = parts.bytes().value_or(std::string_view());
        if (parts.field() == kTranslation) translation_m = read_numbers<3>(part, reader.where());
        if (parts.field() == kRotation) rotation = read_numbers<4>(part, reader.where());
      }
    }
    message.world_from_child = checked_rigid(translation_m, rotation, reader);
    transforms.push_back(std::move(message));
  }
  return transforms;
}

std::optional<MessageHeader> read_apollo_scan_header(MessageReader& begin, std::string_view end) {
  CloudFrame frame = read_cloud_frame(proto_bytes(begin), begin.where(), ProtoReader::End::Cut);
  if (!find_cloud_end(end, frame)) return std::nullopt;
  return header_of(frame, begin.where());
}

MessageHeader read_apollo_scan_header(MessageReader& whole) {
  return header_of(read_cloud_frame(proto_bytes(whole), whole.where(), ProtoReader::End::Whole), whole.where());
}

CloudOutline read_apollo_outline(MessageReader& begin, std::string_view end) {
  CloudFrame frame = read_cloud_frame(proto_bytes(begin), begin.where(), ProtoReader::End::Cut);
  find_cloud_end(end, frame);
  CloudOutline outline;
  outline.header = header_of(frame, begin.where());
  constexpr std::uint64_t kMost = 1'000'000'000;
  outline.points = frame.width <= kMost && frame.height <= kMost ? frame.width * frame.height : 0;
  outline.points = std::max<std::uint64_t>(outline.points, frame.points_seen);
  outline.timed = frame.timed;
  return outline;
}

bool is_of_compensator(std::string_view channel) { return channel.find("compensator") != std::string_view::npos; }

bool is_of_fusion(std::string_view channel) {
  const std::vector<std::string_view> words = words_of(channel);
  return std::ranges::find(words, "fusion") != words.end();
}

formats::ReadCloud read_apollo_cloud(MessageReader& reader, std::int64_t stamp_ns, formats::PointTimes times) {
  const std::string_view bytes = proto_bytes(reader);
  const CloudFrame frame = read_cloud_frame(bytes, reader.where(), ProtoReader::End::Whole);
  const bool timed = frame.timed;
  const std::int64_t of_points_ns = stamp_of_points_ns(frame, stamp_ns, reader.where());
  formats::CloudColumns columns;
  columns.x = columns.y = columns.z = columns.intensity = 0;
  columns.time = timed ? 0 : -1;
  formats::CloudBuilder builder(columns, {formats::ScalarType::F64, 1.0}, possible_points(bytes, reader.where()));
  for (ProtoReader fields(bytes, reader.where()); fields.next();)
    if (fields.field() == kCloudPoint && fields.bytes())
      builder.add(read_point(*fields.bytes(), reader.where(), of_points_ns));
  formats::ReadCloud read = builder.finish(stamp_ns, reader.where(), times);
  read.columns = timed ? "x y z intensity timestamp" : "x y z intensity";
  return read;
}

}  // namespace remount::bags
