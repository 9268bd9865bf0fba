#include "model/formats/bags/bag_streams.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "algorithms/core/median.h"
#include "algorithms/core/stamps.h"
#include "messages/bags.h"
#include "messages/sessions.h"
#include "messages/stages.h"
#include "model/drive/bad_items.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/bags/apollo_messages.h"
#include "model/formats/bags/cloud_message.h"
#include "model/formats/bags/ins_messages.h"
#include "model/formats/files/input_file.h"

namespace remount::bags {
namespace {

constexpr std::size_t kStampBytes = 512;  // a header with its frame; scans are not read further

/// What is done with the messages of one topic.
struct Taker {
  std::size_t topic = 0;
  std::size_t at_most = std::numeric_limits<std::size_t>::max();
  std::function<void(const BagEntry& entry, std::size_t index, MessageReader& reader)> take;
};

struct Visit {
  const BagEntry* entry = nullptr;
  std::size_t index = 0;
  std::size_t taker = 0;
};

/// Every message of every taker in the order in which they lie in the bag.
std::vector<Visit> in_order(const BagFile& bag, const std::vector<Taker>& takers) {
  std::vector<Visit> visits;
  for (std::size_t taker = 0; taker < takers.size(); ++taker) {
    const std::vector<BagEntry>& entries = bag.topics()[takers[taker].topic].entries;
    for (std::size_t i = 0; i < entries.size(); ++i) visits.push_back({&entries[i], i, taker});
  }
  std::sort(visits.begin(), visits.end(), [](const Visit& a, const Visit& b) {
    const auto place = [](const Visit& v) { return std::tie(v.entry->file, v.entry->chunk, v.entry->offset, v.taker); };
    return place(a) < place(b);
  });
  return visits;
}

std::string place_of(const BagFile& bag, const std::string& topic, std::size_t index) {
  return bag.files().front().string() + ": " + topic + ", message " + std::to_string(index + 1);
}

void visit_all(const BagFile& bag, const std::vector<Taker>& takers, std::vector<drive::Finding>& findings,
               Progress& progress) {
  std::vector<drive::BadItems> bad(takers.size());
  const std::vector<Visit> visits = in_order(bag, takers);
  for (std::size_t i = 0; i < visits.size(); ++i) {
    if (progress.cancelled()) return;
    if (i % 500 == 0) progress.report(say::stage_reading_messages, i, visits.size());
    const Visit& visit = visits[i];
    const Taker& taker = takers[visit.taker];
    const BagTopic& topic = bag.topics()[taker.topic];
    try {
      const std::string bytes = bag.message(*visit.entry, taker.at_most);
      MessageReader reader(bytes, topic.encoding, place_of(bag, topic.name, visit.index));
      taker.take(*visit.entry, visit.index, reader);
    } catch (const Error& error) {
      bad[visit.taker].add(error);
    }
  }
  for (std::size_t i = 0; i < takers.size(); ++i)
    bad[i].report(findings, "bad-messages", bag.files().front().string() + ": " + bag.topics()[takers[i].topic].name,
                  say::left_out_messages);
}

/// Puts items back into the order of their topic, and gives those without stamps the recorder's where none has one.
template <class Item, class Stamp>
void settle(std::vector<Item>& items, StreamClock& clock, Stamp&& stamp_of, const std::string& topic,
            std::vector<drive::Finding>& findings) {
  std::vector<std::size_t> order(items.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return clock.readings[a].log_time_ns < clock.readings[b].log_time_ns;
  });
  std::vector<Item> sorted;
  std::vector<ClockReading> readings;
  for (const std::size_t i : order) {
    sorted.push_back(std::move(items[i]));
    readings.push_back(clock.readings[i]);
  }
  items = std::move(sorted);
  clock.readings = std::move(readings);
  const bool unstamped = !items.empty() && std::all_of(clock.readings.begin(), clock.readings.end(),
                                                       [](const ClockReading& r) { return r.stamp_ns == 0; });
  if (!unstamped) return;
  for (std::size_t i = 0; i < items.size(); ++i)
    clock.readings[i].stamp_ns = stamp_of(items[i]) = clock.readings[i].log_time_ns;
  findings.push_back(drive::make_finding(drive::Severity::Warning, "no-stamps", topic, say::bag_no_stamps()));
}

void note(StreamClock& clock, std::int64_t stamp_ns, const BagEntry& entry) {
  clock.readings.push_back({stamp_ns, entry.log_time_ns});
}

/// Of a cloud of which the beginning is at hand; its stamp stands at its end.
MessageHeader apollo_header(const BagFile& bag, const BagEntry& entry, MessageReader& begin) {
  if (auto header = read_apollo_scan_header(begin, bag.message_end(entry, kApolloCloudEnd))) return std::move(*header);
  const std::string bytes = bag.message(entry);
  MessageReader whole(bytes, begin.encoding(), begin.where());
  return read_apollo_scan_header(whole);
}

class StreamReader {
 public:
  StreamReader(const BagFile& bag, BagStreams& streams) : bag_(bag), streams_(streams) {}

  void add_scans(std::size_t topic) {
    const MessageKind kind = message_kind(bag_.topics()[topic].type);
    add(topic, kStampBytes,
        [&s = streams_.scans, &bag = bag_, kind](const BagEntry& entry, std::size_t index, MessageReader& reader) {
          const MessageHeader header =
              kind == MessageKind::ApolloCloud ? apollo_header(bag, entry, reader) : read_header(reader);
          if (s.scans.empty()) s.frame = header.frame;
          s.scans.push_back({index, header.stamp_ns});
          note(s.clock, header.stamp_ns, entry);
        });
  }
  void add_packets(std::size_t lidar, const PacketTopics& all) {
    streams_.packets = std::make_unique<PacketStream>(bag_, all, lidar);
    for (const std::size_t topic : streams_.packets->topics())
      add(topic, kAll,
          [&packets = *streams_.packets, topic](const BagEntry& entry, std::size_t index, MessageReader& reader) {
            packets.take(topic, entry, index, reader);
          });
  }
  void add_poses(std::size_t topic, PoseStream& stream) {
    const MessageKind kind = message_kind(bag_.topics()[topic].type);
    add(topic, kAll, [&stream, kind](const BagEntry& entry, std::size_t, MessageReader& reader) {
      PoseMessage message = read_pose(reader, kind);
      if (stream.world_from_child.empty()) {
        stream.frame = message.header.frame;
        stream.child_frame = message.child_frame;
      }
      stream.world_from_child.push_back({message.header.stamp_ns, message.world_from_child});
      note(stream.clock, message.header.stamp_ns, entry);
    });
  }
  void add_imu(std::size_t topic, ImuStream& stream) {
    const MessageKind kind = message_kind(bag_.topics()[topic].type);
    add(topic, kAll, [&stream, kind](const BagEntry& entry, std::size_t, MessageReader& reader) {
      stream.messages.push_back(read_attitude(reader, kind));
      note(stream.clock, stream.messages.back().header.stamp_ns, entry);
    });
  }
  void add_fixes(std::size_t topic, FixStream& stream) {
    const MessageKind kind = message_kind(bag_.topics()[topic].type);
    add(topic, kAll, [&stream, kind](const BagEntry& entry, std::size_t, MessageReader& reader) {
      stream.messages.push_back(read_any_fix(reader, kind));
      note(stream.clock, stream.messages.back().header.stamp_ns, entry);
    });
  }
  void add_inspvax(std::size_t topic, InspvaxStream& stream) {
    const std::string& type = bag_.topics()[topic].type;
    if (!is_inspva(message_kind(type))) return add_solutions(topic, stream);
    add(topic, kAll, [&s = stream, &type](const BagEntry& entry, std::size_t, MessageReader& reader) {
      s.messages.push_back(read_inspvax_message(reader, type));
      note(s.clock, s.messages.back().sample.stamp_ns, entry);
    });
  }
  void add_insstdev(std::size_t topic, InsstdevStream& stream) {
    const std::string& type = bag_.topics()[topic].type;
    add(topic, kAll, [&s = stream, &type](const BagEntry& entry, std::size_t, MessageReader& reader) {
      s.messages.push_back(message_kind(type) == MessageKind::Gsof50 ? read_gsof50(reader)
                                                                     : read_insstdev_message(reader, type));
      note(s.clock, s.messages.back().stamp_ns, entry);
    });
  }
  void add_position_types(std::size_t topic) {
    add(topic, kAll, [&all = streams_.position_types](const BagEntry&, std::size_t, MessageReader& reader) {
      all.push_back(read_apollo_status(reader));
    });
  }
  void add_sentences(std::size_t topic, std::string& text) {
    add(topic, kAll, [&text](const BagEntry&, std::size_t, MessageReader& reader) {
      read_header(reader);
      text.append(formats::trim(reader.string())).append("\n");
    });
  }
  void add_static_transforms() {
    for (std::size_t i = 0; i < bag_.topics().size(); ++i)
      if (is_static_transforms(bag_.topics()[i]))
        add(i, kAll, [&all = streams_.static_transforms](const BagEntry&, std::size_t, MessageReader& reader) {
          for (PoseMessage& transform : read_transforms(reader)) all.push_back(std::move(transform));
        });
  }

  const std::vector<Taker>& takers() const { return takers_; }

 private:
  void add_solutions(std::size_t topic, InspvaxStream& stream) {
    const MessageKind kind = message_kind(bag_.topics()[topic].type);
    add(topic, kAll,
        [&s = stream, kind, errors = formats::NcomErrors()](const BagEntry& entry, std::size_t,
                                                            MessageReader& reader) mutable {
          auto message = read_solution(reader, kind, errors);
          if (!message) return;
          s.messages.push_back(std::move(*message));
          note(s.clock, s.messages.back().sample.stamp_ns, entry);
        });
  }

  static constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
  template <class Take>
  void add(std::size_t topic, std::size_t at_most, Take&& take) {
    takers_.push_back({topic, at_most, std::forward<Take>(take)});
  }
  const BagFile& bag_;
  BagStreams& streams_;
  std::vector<Taker> takers_;
};

void settle_all(const BagFile& bag, const TopicRoles& roles, BagStreams& s, std::vector<drive::Finding>& findings) {
  const auto name = [&](const std::optional<std::size_t>& topic) {
    return topic ? bag.topics()[*topic].name : std::string();
  };
  const auto header_stamp = [](auto& message) -> std::int64_t& { return message.header.stamp_ns; };
  const auto own_stamp = [](auto& item) -> std::int64_t& { return item.stamp_ns; };
  settle(s.scans.scans, s.scans.clock, own_stamp, name(roles.lidar), findings);
  settle(s.lidar_poses.world_from_child, s.lidar_poses.clock, own_stamp, name(roles.lidar), findings);
  settle(s.ins_poses.world_from_child, s.ins_poses.clock, own_stamp, name(roles.ins), findings);
  const auto sample_stamp = [](InspvaxMessage& message) -> std::int64_t& { return message.sample.stamp_ns; };
  settle(s.inspvax.messages, s.inspvax.clock, sample_stamp, name(roles.ins), findings);
  settle(s.inspvax_beside.messages, s.inspvax_beside.clock, sample_stamp, name(roles.ins), findings);
  settle(s.insstdev.messages, s.insstdev.clock, own_stamp, name(roles.ins), findings);
  settle(s.attitude.messages, s.attitude.clock, header_stamp, name(roles.ins), findings);
  settle(s.position.messages, s.position.clock, header_stamp, name(roles.ins_position), findings);
  settle(s.gnss.messages, s.gnss.clock, header_stamp, name(roles.gnss), findings);
  settle(s.imu.messages, s.imu.clock, header_stamp, name(roles.imu), findings);
}

/// From the first scan, of three, that can be read.
double ends_after_s(const BagFile& bag, std::size_t topic_index, const ScanStream& stream) {
  constexpr double kLongest_s = 2.0;  // a scan that takes longer was thinned out, not taken so long
  const BagTopic& topic = bag.topics()[topic_index];
  for (std::size_t i = 0; i < std::min<std::size_t>(stream.scans.size(), 3); ++i) try {
      const drive::IndexedScan& scan = stream.scans[i];
      const std::string bytes = bag.message(topic.entries[scan.index]);
      MessageReader reader(bytes, topic.encoding, place_of(bag, topic.name, scan.index));
      const cloud::PointCloud cloud = read_cloud(reader, message_kind(topic.type), scan.stamp_ns).cloud;
      const auto last = std::max_element(cloud.time_from_stamp_s.begin(), cloud.time_from_stamp_s.end());
      if (last != cloud.time_from_stamp_s.end()) return std::clamp<double>(*last, 0.0, kLongest_s);
      break;
    } catch (const Error&) {
      continue;  // becomes known when the scan is used
    }
  return std::clamp(drive::median_period_s(stream.scans), 0.0, kLongest_s);
}

/// What one INS publishes of its errors beside the solution which serves, `of` a kind that states none: of the same
/// device, or the only one there is.
std::optional<std::size_t> errors_beside(const BagFile& bag, const TopicRoles& roles, MessageKind of,
                                         MessageKind kind) {
  if (!roles.ins || message_kind(bag.topics()[*roles.ins].type) != of) return std::nullopt;
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < bag.topics().size(); ++i) {
    const BagTopic& topic = bag.topics()[i];
    if (message_kind(topic.type) != kind || topic.entries.empty()) continue;
    if (topic.encoding == MessageEncoding::Other) continue;
    if (of_one_device(bag.topics()[*roles.ins].name, topic.name)) return i;
    all.push_back(i);
  }
  return all.size() == 1 ? std::optional(all.front()) : std::nullopt;
}

}  // namespace

double StreamClock::behind_s() const {
  if (readings.empty()) return 0.0;
  std::vector<double> apart_s;
  for (const ClockReading& reading : readings) apart_s.push_back(seconds(reading.log_time_ns - reading.stamp_ns));
  return median_of(std::move(apart_s));
}

BagStreams read_streams(const BagFile& bag, const ChosenTopics& chosen, std::vector<drive::Finding>& findings,
                        Progress& progress) {
  const TopicRoles& roles = chosen.roles;
  BagStreams streams;
  StreamReader reader(bag, streams);
  const auto kind = [&](std::size_t topic) { return message_kind(bag.topics()[topic].type); };
  if (roles.lidar && is_cloud(kind(*roles.lidar))) reader.add_scans(*roles.lidar);
  if (roles.lidar && kind(*roles.lidar) == MessageKind::LidarPackets) reader.add_packets(*roles.lidar, *chosen.packets);
  if (roles.lidar && is_pose(kind(*roles.lidar))) reader.add_poses(*roles.lidar, streams.lidar_poses);
  if (roles.ins && is_pose(kind(*roles.ins))) reader.add_poses(*roles.ins, streams.ins_poses);
  if (roles.ins && is_solution(kind(*roles.ins))) reader.add_inspvax(*roles.ins, streams.inspvax);
  if (const auto beside = errors_beside(bag, roles, MessageKind::Inspva, MessageKind::Inspvax))
    reader.add_inspvax(*beside, streams.inspvax_beside);
  if (const auto beside = errors_beside(bag, roles, MessageKind::Inspva, MessageKind::Insstdev))
    reader.add_insstdev(*beside, streams.insstdev);
  if (const auto beside = errors_beside(bag, roles, MessageKind::Gsof49, MessageKind::Gsof50))
    reader.add_insstdev(*beside, streams.insstdev);
  for (const MessageKind poses : {MessageKind::ApolloGps, MessageKind::ApolloLocalization})
    if (const auto beside = errors_beside(bag, roles, poses, MessageKind::ApolloInsStat))
      reader.add_position_types(*beside);
  if (roles.ins && is_attitude(kind(*roles.ins))) reader.add_imu(*roles.ins, streams.attitude);
  if (roles.ins_position) reader.add_fixes(*roles.ins_position, streams.position);
  const auto tells_nmea = [&](const std::optional<std::size_t>& topic) {
    return topic && kind(*topic) == MessageKind::NmeaSentence;
  };
  if (tells_nmea(roles.ins)) reader.add_sentences(*roles.ins, streams.ins_sentences);
  if (tells_nmea(roles.gnss)) reader.add_sentences(*roles.gnss, streams.gnss_sentences);
  if (roles.gnss && !tells_nmea(roles.gnss)) reader.add_fixes(*roles.gnss, streams.gnss);
  if (roles.imu) reader.add_imu(*roles.imu, streams.imu);
  reader.add_static_transforms();
  visit_all(bag, reader.takers(), findings, progress);
  settle_all(bag, roles, streams, findings);
  if (!streams.scans.scans.empty() && !progress.cancelled())
    streams.scans.ends_after_s = ends_after_s(bag, *roles.lidar, streams.scans);
  return streams;
}

}  // namespace remount::bags
