#include "model/formats/bags/bag_reader.h"

#include <algorithm>
#include <unordered_map>

#include "algorithms/core/median.h"
#include "algorithms/core/stamps.h"
#include "messages/bags.h"
#include "messages/records.h"
#include "model/drive/bad_items.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/bags/apollo_messages.h"
#include "model/formats/bags/bag_ins.h"
#include "model/formats/bags/bag_week_rollover.h"
#include "model/formats/bags/cloud_message.h"
#include "model/formats/bags/record_file.h"
#include "model/formats/bags/static_frames.h"
#include "model/formats/clouds/timed_scans.h"
#include "model/formats/packets/capture_scans.h"
#include "model/formats/packets/receiver_fixes.h"
#include "model/formats/poses/pose_pairing.h"

namespace remount::bags {

namespace fs = std::filesystem;

namespace {

/// Scans that are messages; each is read from the file when it is asked for.
class BagScanSource final : public formats::TimedScanSource {
 public:
  BagScanSource(std::shared_ptr<const BagFile> bag, std::size_t topic, std::vector<drive::IndexedScan> scans)
      : bag_(std::move(bag)), topic_(bag_->topics()[topic]), scans_(std::move(scans)) {}
  std::size_t size() const override { return scans_.size(); }
  std::int64_t stamp_ns(std::size_t scan) const override { return at(scan).stamp_ns; }
  std::string name(std::size_t scan) const override {
    return topic_.name + ", message " + std::to_string(at(scan).index + 1);
  }
  formats::ReadCloud read(std::size_t scan) const override {
    const BagEntry& entry = topic_.entries[at(scan).index];
    const std::string bytes = bag_->message(entry);
    MessageReader reader(bytes, topic_.encoding, bag_->files().front().string() + ": " + name(scan));
    formats::ReadCloud read = read_cloud(reader, message_kind(topic_.type), at(scan).stamp_ns, times_for_reading());
    if (compensated()) read.cloud.time_from_stamp_s = {};  // all points are where they were at the stamp
    return read;
  }
  bool compensated() const {
    return message_kind(topic_.type) == MessageKind::ApolloCloud && is_of_compensator(topic_.name);
  }

 private:
  const drive::IndexedScan& at(std::size_t scan) const {
    if (scan >= scans_.size())
      throw Error(ErrorCode::Contract, "",
                  Message::verbatim("scan " + std::to_string(scan) + " of " + std::to_string(scans_.size()) +
                                    " does not exist"));
    return scans_[scan];
  }

  std::shared_ptr<const BagFile> bag_;
  const BagTopic& topic_;
  std::vector<drive::IndexedScan> scans_;
};

/// Whether points have times, from the first scans that can be read.
void judge_point_times(BagScanSource& scans, drive::Session& session) {
  const formats::FoundPointTimes found = formats::find_point_times(scans);
  if (!found.usable) {
    formats::report_no_point_times(scans, session);
    return;
  }
  session.scan_timing = drive::ScanTiming::PerPoint;
  session.times_count = found.count;
  scans.use_times(formats::TimesOfPoints::Required);
  formats::report_point_clock(scans, session.findings);
}

/// When the last packet of each message came, by the time of the packets: a recorder has a message no earlier.
std::unordered_map<std::size_t, std::int64_t> ends_of_messages(const formats::PacketScanSource& scans) {
  std::unordered_map<std::size_t, std::int64_t> ends_ns;
  for (const formats::IndexedPacket& packet : scans.packets()) {
    std::int64_t& end_ns = ends_ns.try_emplace(message_of(packet), packet.time_ns).first->second;
    end_ns = std::max(end_ns, packet.time_ns);
  }
  return ends_ns;
}

/// Before the clocks of other streams are compared with that of the scans.
void add_packet_scans(const std::shared_ptr<const BagFile>& bag, std::size_t topic, BagStreams& streams,
                      drive::Session& session) {
  formats::PacketIndex index = streams.packets->made(bag);
  const auto scans = formats::take_scans(index, 0, session);
  // A bag has no addresses: all that was taken with the packets of this LiDAR is of its receiver.
  if (!index.receivers.empty()) streams.receiver = std::move(index.receivers.begin()->second);
  ScanStream& stream = streams.scans;
  stream.frame = streams.packets->frame();
  std::vector<double> lasting_s;
  const auto ends_ns = ends_of_messages(*scans);
  for (std::size_t scan = 0; scan < scans->size(); ++scan) {
    const formats::IndexedPacket& last = scans->last_packet(scan);
    stream.scans.push_back({scan, scans->stamp_ns(scan)});
    const std::size_t message = message_of(last);
    const std::int64_t waited_ns = ends_ns.at(message) - last.time_ns;
    stream.clock.readings.push_back(
        {scans->stamp_ns(scan), bag->topics()[topic].entries[message].log_time_ns - waited_ns});
    lasting_s.push_back(seconds(last.time_ns - scans->stamp_ns(scan)));
  }
  if (scans->size() == 0)
    throw Error(ErrorCode::Format, bag->files().front().string() + ": " + bag->topics()[topic].name,
                say::bag_no_scan());
  stream.ends_after_s = std::max(0.0, median_of(std::move(lasting_s)));
}

void add_lidar(const std::shared_ptr<const BagFile>& bag, const TopicRoles& roles, BagStreams& streams,
               drive::Session& session) {
  if (!roles.lidar || streams.packets) return;
  const std::string where = bag->files().front().string() + ": " + bag->topics()[*roles.lidar].name;
  if (!streams.lidar_poses.world_from_child.empty()) {
    session.odometry_from_lidar = std::move(streams.lidar_poses.world_from_child);
    drive::keep_ascending(session.odometry_from_lidar, "lidar", where, session.findings);
    formats::align_lidar_clock(session, formats::ClockUse::Shared);
    return;
  }
  std::vector<drive::IndexedScan> scans = std::move(streams.scans.scans);
  if (scans.empty()) throw Error(ErrorCode::Format, where, say::bag_no_scan());
  drive::keep_ascending(scans, "scan", where, session.findings);
  const auto source = std::make_shared<BagScanSource>(bag, *roles.lidar, std::move(scans));
  if (source->compensated()) {
    session.scan_timing = drive::ScanTiming::Instant;
    source->use_times(formats::TimesOfPoints::Unused);
    session.findings.push_back(
        drive::make_finding(drive::Severity::Warning, "scans-compensated", where, say::apollo_compensated()));
  } else {
    judge_point_times(*source, session);
  }
  session.scans = source;
}

/// What Apollo's transforms call the frame of its poses: of those that they know, the one that is usual for these.
std::string apollo_frame(const BagStreams& streams) {
  const std::string& usual = streams.ins_poses.child_frame;
  for (const std::string& frame : {usual, std::string("novatel"), std::string("localization"), std::string("imu")})
    if (std::ranges::any_of(streams.static_transforms, [&](const PoseMessage& transform) {
          return transform.child_frame == frame || transform.header.frame == frame;
        }))
      return frame;
  return usual;
}

std::string ins_frame(const BagFile& bag, const TopicRoles& roles, const BagStreams& streams) {
  if (!roles.ins) return {};
  if (is_apollo_pose(message_kind(bag.topics()[*roles.ins].type))) return apollo_frame(streams);
  if (is_attitude(message_kind(bag.topics()[*roles.ins].type)))
    return streams.attitude.messages.empty() ? std::string() : streams.attitude.messages.front().header.frame;
  return streams.ins_poses.child_frame;
}

/// Why static transforms cannot lead from the LiDAR to the INS; empty where they may.
Message why_no_nominal(const BagFile& bag, const TopicRoles& roles, const std::string& ins, const std::string& lidar) {
  if (is_inspva(message_kind(bag.topics()[*roles.ins].type))) return say::bag_nominal_inspvax();
  if (is_solution(message_kind(bag.topics()[*roles.ins].type))) return say::bag_nominal_maker();
  if (ins.empty()) return say::bag_nominal_ins_frame();
  if (lidar.empty()) return say::bag_nominal_lidar_frame();
  if (ins == lidar) return say::bag_nominal_one_frame(lidar);
  return {};
}

/// The mounting as the static transforms have it. Poses of an odometry are not looked for in them.
void add_nominal(const BagFile& bag, const TopicRoles& roles, const BagStreams& streams, const std::string& ins,
                 drive::Session& session) {
  if (streams.static_transforms.empty() || !roles.ins || streams.scans.scans.empty()) return;
  const std::string& lidar = streams.scans.frame;
  const std::string where = bag.files().front().string();
  if (Message why = why_no_nominal(bag, roles, ins, lidar); !why.empty()) {
    session.findings.push_back(drive::make_finding(drive::Severity::Note, "nominal-not-found", where, std::move(why)));
    return;
  }
  const auto ins_from_lidar = find_transform(streams.static_transforms, ins, lidar);
  if (ins_from_lidar) {
    session.nominal_ins_from_lidar = *ins_from_lidar;
    for (drive::SessionTopic& topic : session.topics)
      if (topic.can_be == std::vector<std::string>{std::string(drive::kNominalRole)}) topic.used_as = topic.can_be;
  }
  session.findings.push_back(ins_from_lidar ? drive::make_finding(drive::Severity::Note, "nominal-found", where,
                                                                  say::bag_nominal_found(lidar, ins))
                                            : drive::make_finding(drive::Severity::Note, "nominal-not-found", where,
                                                                  say::bag_nominal_not_found(lidar, ins)));
}

std::shared_ptr<PacketTopics> looked_through(const BagFile& bag, const Progress& progress) {
  return std::make_shared<PacketTopics>(examine_packets(bag, progress));
}

/// What a session is opened from.
struct OpenedBag {
  std::shared_ptr<const BagFile> bag;
  fs::path path;
  std::string format;  ///< id of the reader
};

drive::Session begun_session(const OpenedBag& opened, const drive::TopicChoice& choice) {
  const BagFile& bag = *opened.bag;
  const fs::path& path = opened.path;
  drive::Session session;
  session.name = (path.has_filename() ? path : path.parent_path()).filename().string();
  session.path = path;
  session.format = opened.format;
  session.files = bag.files();
  session.findings = bag.findings();
  session.topic_choice = choice;
  return session;
}

/// False where packets that nobody asked for turn out not to be scans: they are refused from then on.
/// @param last the error is thrown all the same: the bag is read once for each
bool make_scans(const std::shared_ptr<const BagFile>& bag, std::size_t lidar, PacketTopics& packets,
                BagStreams& streams, drive::Session& session, bool last) {
  try {
    if (streams.packets) add_packet_scans(bag, lidar, streams, session);
    return true;
  } catch (const Error& error) {
    const bool of_packets = error.code() == ErrorCode::Unsupported || error.code() == ErrorCode::Format;
    if (session.topic_choice.contains("lidar") || !of_packets || last) throw;
    packets.found.at(lidar).refused = error;
    return false;
  }
}

void complete(const std::shared_ptr<const BagFile>& bag, const ChosenTopics& chosen, BagStreams& streams,
              drive::Session& session) {
  const TopicRoles& roles = chosen.roles;
  const std::string frame = ins_frame(*bag, roles, streams);
  mend_week_rollovers(*bag, roles, streams, session.findings);
  session.world_frame = streams.ins_poses.frame;
  session.attitudes_to_true_north = roles.ins && (is_of_novatel(bag->topics()[*roles.ins].name) ||
                                                  is_apollo_pose(message_kind(bag->topics()[*roles.ins].type)));
  if (roles.lidar) session.lidar_name = bag->topics()[*roles.lidar].name;
  add_ins(*bag, chosen, streams, session);
  if (!roles.gnss && !session.topic_choice.contains("gnss")) {
    formats::take_receiver(streams.receiver, bag->files().front().string() + ": " + session.lidar_name, session);
    // The sentences have the time of GNSS, as the INS has.
    for (motion::GnssFix& fix : session.gnss) fix.stamp_ns += streams.ins_moved_ns;
  }
  add_nominal(*bag, roles, streams, frame, session);
  add_lidar(bag, roles, streams, session);
}

/// A session of the chosen topics; of the bag itself no more than its index has been read.
drive::Session session_of(const OpenedBag& opened, const drive::TopicChoice& choice, Progress& progress) {
  const std::shared_ptr<const BagFile>& bag = opened.bag;
  const std::shared_ptr<PacketTopics> packets = looked_through(*bag, progress);
  constexpr std::size_t kMostWithoutScans = 8;
  std::vector<drive::Finding> no_scans;
  while (true) {
    drive::Session session = begun_session(opened, choice);
    if (progress.cancelled()) return session;
    const ChosenTopics chosen = choose_topics(*bag, choice, session.findings, packets);
    const std::optional<std::size_t>& lidar = chosen.roles.lidar;
    // Where there is no LiDAR, choosing topics has told it.
    if (lidar) session.findings.insert(session.findings.end(), no_scans.begin(), no_scans.end());
    for (const drive::OfferedTopic& offered : chosen.topics) session.topics.push_back(offered.topic);
    BagStreams streams = read_streams(*bag, chosen, session.findings, progress);
    if (progress.cancelled()) return session;
    if (!lidar || make_scans(bag, *lidar, *packets, streams, session, no_scans.size() == kMostWithoutScans)) {
      complete(bag, chosen, streams, session);
      return session;
    }
    no_scans.push_back(drive::make_finding(drive::Severity::Warning, "raw-packets", bag->topics()[*lidar].name,
                                           packets->found.at(*lidar).refused->what_happened()));
  }
}

}  // namespace

int BagReader::probe(const fs::path& path) const { return probe_bag(path); }
int RecordReader::probe(const fs::path& path) const { return probe_record(path); }

std::shared_ptr<const BagFile> BagReader::open_file(const fs::path& path, Progress& progress) const {
  return open_bag(path, progress);
}
std::shared_ptr<const BagFile> RecordReader::open_file(const fs::path& path, Progress& progress) const {
  return open_record(path, progress);
}

drive::Session BagReader::open(const fs::path& path, Progress& progress) const {
  return open_topics(path, {}, progress);
}

drive::Session BagReader::open_topics(const fs::path& path, const drive::TopicChoice& topics,
                                      Progress& progress) const {
  return session_of({open_file(path, progress), path, std::string(id())}, topics, progress);
}

std::optional<drive::TopicOffer> BagReader::offer_topics(const fs::path& path, Progress& progress) const {
  const OpenedBag opened{open_file(path, progress), path, std::string(id())};
  std::vector<drive::Finding> none;
  return drive::TopicOffer{
      path, choose_topics(*opened.bag, {}, none, looked_through(*opened.bag, progress)).topics,
      [opened](const drive::TopicChoice& topics, Progress& reading) { return session_of(opened, topics, reading); }};
}

std::vector<drive::LidarOffer> BagReader::offer_lidars(const fs::path& path, Progress& progress) const {
  std::vector<drive::Finding> none;
  const std::shared_ptr<const BagFile> bag = open_file(path, progress);
  const ChosenTopics chosen = choose_topics(*bag, {}, none, looked_through(*bag, progress));
  std::vector<drive::LidarOffer> offers;
  std::size_t most_scans = 0;
  for (const drive::OfferedTopic& offered : chosen.topics) {
    const drive::TopicUse* use = offered.use("lidar");
    if (!use || !use->unasked) continue;
    const drive::SessionTopic& topic = offered.topic;
    // How many scans are in packets is known once all of them have been read.
    const bool packets = message_kind(topic.type) == MessageKind::LidarPackets;
    offers.push_back({topic.name, {{"lidar", topic.name}}, packets ? std::nullopt : std::optional(topic.count)});
    if (!packets) most_scans = std::max(most_scans, topic.count);
  }
  constexpr std::size_t kRare = 6;  // LiDARs turn 5 to 25 times a second; maps and markers are seldom published
  for (drive::LidarOffer& offer : offers) offer.rare = offer.scans && *offer.scans * kRare < most_scans;
  if (offers.empty()) offers.emplace_back();
  return offers;
}

}  // namespace remount::bags
