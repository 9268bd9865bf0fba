#include "model/formats/bags/topic_candidates.h"

#include <algorithm>
#include <array>

#include "algorithms/core/error.h"
#include "model/formats/bags/apollo_messages.h"
#include "model/formats/bags/bag_packets.h"
#include "model/formats/bags/cloud_message.h"
#include "model/formats/bags/ins_messages.h"
#include "model/formats/ins/nmea_records.h"

namespace remount::bags {
namespace {

/// Of any kind of attitude: one that is no Imu has no rates.
void examine_imu(const BagFile& bag, const std::string& where, TopicCandidate& candidate) {
  const BagTopic& topic = bag.topics()[candidate.topic];
  const std::size_t last = topic.entries.size() - 1;
  std::size_t read = 0;
  TopicCandidate found = candidate;
  found.oriented = found.inertial = false;
  for (const std::size_t index : std::array{std::size_t{0}, last / 2, last}) try {
      const std::string bytes = bag.message(topic.entries[index]);
      MessageReader reader(bytes, topic.encoding, where);
      const ImuMessage imu = read_attitude(reader, candidate.kind);
      found.oriented = found.oriented || (imu.orientation && !imu.orientation_is_default);
      found.orientation_sigma = found.orientation_sigma || imu.orientation_variance_rad2.minCoeff() > 0.0;
      found.inertial = found.inertial || imu.angular_rate_radps.has_value();
      ++read;
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Io) throw;
    }
  if (read > 0) candidate = found;
  candidate.damaged = read == 0;
}

/// Whether sentences with attitudes are among the first: a receiver writes all of its kinds within a second or two.
void examine_sentences(const BagFile& bag, const std::string& where, TopicCandidate& candidate) {
  constexpr std::size_t kLookedAt = 100;
  constexpr std::array<std::string_view, 4> kOthers{"GGA", "GST", "RMC", "ZDA"};
  const BagTopic& topic = bag.topics()[candidate.topic];
  std::size_t read = 0;
  candidate.oriented = false;
  for (std::size_t i = 0; i < std::min(kLookedAt, topic.entries.size()) && !candidate.oriented; ++i) try {
      const std::string bytes = bag.message(topic.entries[i]);
      MessageReader reader(bytes, topic.encoding, where);
      read_header(reader);
      formats::NmeaSentence sentence;
      const bool is_one = formats::parse_nmea(reader.string(), sentence) == formats::NmeaLine::Sentence;
      candidate.oriented = is_one && formats::NmeaRecords::reads(sentence.type) &&
                           std::ranges::find(kOthers, sentence.type) == kOthers.end();
      ++read;
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Io) throw;
    }
  candidate.damaged = read == 0;
}

void examine_poses(const BagFile& bag, const std::string& where, TopicCandidate& candidate) {
  const BagTopic& topic = bag.topics()[candidate.topic];
  const std::size_t last = topic.entries.size() - 1;
  std::size_t read = 0, oriented = 0;
  for (const std::size_t index : std::array{std::size_t{0}, last / 2, last}) try {
      const std::string bytes = bag.message(topic.entries[index]);
      MessageReader reader(bytes, topic.encoding, where);
      oriented += has_orientation(reader, candidate.kind);
      ++read;
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Io) throw;
    }
  candidate.oriented = oriented > 0 || read == 0;
  candidate.damaged = read == 0;
}

void take_lidar_packets(const PacketTopics& packets, TopicCandidate& candidate) {
  const auto found = packets.found.find(candidate.topic);
  if (found == packets.found.end()) return;
  candidate.model = found->second.model;
  candidate.frame = found->second.frame;
  candidate.damaged = found->second.damaged;
  if (found->second.refused) candidate.refusal = found->second.refused->what_happened();
}

void examine(const BagFile& bag, const PacketTopics& packets, TopicCandidate& candidate) {
  constexpr std::size_t kHeadBytes = 16 * 1024;
  const BagTopic& topic = bag.topics()[candidate.topic];
  const std::string where = bag.files().front().string() + ": " + topic.name;
  if (is_attitude(candidate.kind)) return examine_imu(bag, where, candidate);
  if (candidate.kind == MessageKind::NmeaSentence) return examine_sentences(bag, where, candidate);
  if (is_pose(candidate.kind)) return examine_poses(bag, where, candidate);
  if (candidate.kind == MessageKind::LidarPackets) return take_lidar_packets(packets, candidate);
  if (!is_cloud(candidate.kind)) return;
  const std::string bytes = bag.message(topic.entries.front(), kHeadBytes);
  MessageReader reader(bytes, topic.encoding, where);
  const bool apollo = candidate.kind == MessageKind::ApolloCloud;
  const CloudOutline outline =
      apollo ? read_apollo_outline(reader, bag.message_end(topic.entries.front(), kApolloCloudEnd))
             : read_cloud_outline(reader, candidate.kind);
  candidate.compensated = apollo && is_of_compensator(topic.name);
  candidate.point_times = outline.timed && !candidate.compensated;
  candidate.timed = candidate.point_times || outline.ringed;
  candidate.points = outline.points;
  candidate.frame = outline.header.frame;
}

/// The median step would call a topic fast whose messages arrive in bursts.
double mean_rate_hz(const std::vector<BagEntry>& entries) {
  const double span_s =
      static_cast<double>(entries.back().log_time_ns) * 1e-9 - static_cast<double>(entries.front().log_time_ns) * 1e-9;
  return span_s > 0.0 ? static_cast<double>(entries.size() - 1) / span_s : 0.0;
}

}  // namespace

std::vector<TopicCandidate> candidates_of(const BagFile& bag, const PacketTopics& packets) {
  std::vector<TopicCandidate> candidates;
  for (std::size_t i = 0; i < bag.topics().size(); ++i) {
    const BagTopic& topic = bag.topics()[i];
    if (topic.entries.empty() || topic.encoding == MessageEncoding::Other) continue;
    TopicCandidate candidate;
    candidate.topic = i;
    candidate.kind = message_kind(topic.type);
    candidate.messages = topic.entries.size();
    candidate.rate_hz = mean_rate_hz(topic.entries);
    try {
      examine(bag, packets, candidate);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Io) throw;  // a disk that fails for a moment must not choose another topic
      candidate.damaged = true;                  // it can still be what its type says
    }
    candidates.push_back(candidate);
  }
  return candidates;
}

bool can_be(const TopicCandidate& candidate, std::string_view role) {
  switch (candidate.kind) {
    case MessageKind::PointCloud2:
    case MessageKind::LivoxCustom:
    case MessageKind::ApolloCloud:
      return role == "lidar";
    case MessageKind::LidarPackets:
      return role == "lidar" && !candidate.model.empty() && candidate.refusal.empty();
    case MessageKind::Imu:
      return (role == "ins" && candidate.oriented) || (role == "imu" && candidate.inertial);
    case MessageKind::SbgQuat:
    case MessageKind::SbgEuler:
    case MessageKind::GnssInsOrientation:
      return role == "ins" && candidate.oriented;
    case MessageKind::NmeaSentence:
      return role == "gnss" || (role == "ins" && candidate.oriented);
    case MessageKind::NavSatFix:
    case MessageKind::GpsFix:
    case MessageKind::SbgNav:
      return role == "ins-position" || role == "gnss";
    case MessageKind::ApolloBestPose:
      return role == "gnss";
    case MessageKind::ApolloGps:
    case MessageKind::ApolloLocalization:
      return role == "ins" && candidate.oriented;
    case MessageKind::Inspvax:
    case MessageKind::Inspva:
    case MessageKind::InsNavGeod:
    case MessageKind::Gsof49:
    case MessageKind::OxtsNcom:
      return role == "ins";
    default:
      return is_pose(candidate.kind) && candidate.oriented && (role == "ins" || role == "lidar");
  }
}

bool may_be_asked_for(const TopicCandidate& candidate, std::string_view role) {
  return can_be(candidate, role) || (candidate.kind == MessageKind::Imu && (role == "ins" || role == "imu")) ||
         ((is_attitude(candidate.kind) || candidate.kind == MessageKind::NmeaSentence) && role == "ins") ||
         (candidate.kind == MessageKind::LidarPackets && role == "lidar") ||
         (is_pose(candidate.kind) && (role == "ins" || (role == "lidar" && !is_apollo_pose(candidate.kind))));
}

}  // namespace remount::bags
