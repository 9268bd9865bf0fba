#include "model/formats/sessions/capture_reader.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "messages/captures.h"
#include "messages/sessions.h"
#include "messages/stages.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/input_file.h"
#include "model/formats/packets/capture_index.h"
#include "model/formats/packets/capture_records.h"
#include "model/formats/packets/capture_scans.h"
#include "model/formats/packets/receiver_fixes.h"
#include "model/formats/sessions/ins_beside.h"
#include "model/formats/sessions/several_sessions.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kLidarRole = "lidar";

/// The captures among the files of a folder, and what lies beside them.
struct CaptureContents {
  std::vector<fs::path> captures, others;
};

CaptureContents examine_captures(const fs::path& path) {
  CaptureContents contents;
  if (is_file(path)) return {{path}, {}};
  for (const fs::path& file : files_in(path)) (is_capture(file) ? contents.captures : contents.others).push_back(file);
  return contents;
}

/// The only one of a folder that has packets of a LiDAR: of others something else was recorded.
fs::path only_capture(const CaptureContents& contents, const fs::path& path) {
  if (contents.captures.size() == 1) return contents.captures.front();
  std::vector<fs::path> found;
  std::copy_if(contents.captures.begin(), contents.captures.end(), std::back_inserter(found), holds_lidar);
  if (found.size() == 1) return found.front();
  if (found.size() > 1)
    throw SeveralSessions(path, say::capture_several(found[0].filename().string(), found[1].filename().string()),
                          found);
  throw Error(ErrorCode::Format, path.string(), say::capture_none());
}

drive::SessionTopic sensor_topic(const SensorPackets& sensor) {
  return {name_of(sensor), sensor.decoder->model(), sensor.packets.size(), 0.0, {std::string(kLidarRole)}, {}};
}

std::string asked_sensor(const drive::TopicChoice& topics) {
  const auto asked = topics.find(kLidarRole);
  return asked == topics.end() || asked->second == drive::kNoTopic ? std::string() : asked->second;
}

}  // namespace

int CaptureReader::probe(const fs::path& path) const {
  constexpr int kSure = 95, kFolder = 90, kNothingElse = 20;
  if (is_file(path)) return !is_capture(path) ? 0 : holds_lidar(path) ? kSure : kNothingElse;
  if (!is_folder(path)) return 0;
  const std::vector<fs::path> captures = examine_captures(path).captures;
  return std::any_of(captures.begin(), captures.end(), holds_lidar) ? kFolder : 0;
}

drive::Session CaptureReader::open(const fs::path& path, Progress& progress) const {
  return open_topics(path, {}, progress);
}

drive::Session CaptureReader::open_topics(const fs::path& path, const drive::TopicChoice& topics,
                                          Progress& progress) const {
  const bool others = std::any_of(topics.begin(), topics.end(), [](const auto& topic) {
    return topic.first != kLidarRole && topic.second != drive::kNoTopic;
  });
  if (others) throw Error(ErrorCode::Contract, path.string(), say::session_no_topics(std::string(id())));
  const CaptureContents contents = examine_captures(path);
  const fs::path capture = only_capture(contents, path);
  drive::Session session;
  session.name = (path.has_filename() ? path : path.parent_path()).filename().string();
  session.path = path;
  session.format = id();
  session.files = {capture};
  session.topic_choice = topics;
  PacketIndex index = index_capture(capture, progress);
  if (progress.cancelled()) return session;
  const std::size_t sensor = choose_sensor(index, asked_sensor(topics), capture.string());
  const std::uint32_t address = index.sensors[sensor].route.address;
  if (index.sensors.size() > 1) {
    session.lidar_name = name_of(index.sensors[sensor]);
    for (const SensorPackets& one : index.sensors) {
      session.topics.push_back(sensor_topic(one));
      if (&one == &index.sensors[sensor]) session.topics.back().used_as = session.topics.back().can_be;
    }
  }
  take_scans(index, sensor, session);
  progress.report(say::stage_reading_ins, 1, 2);
  const bool moves = read_ins_beside(contents.others, path, session);
  if (const auto receiver = index.receivers.find(address); receiver != index.receivers.end())
    take_receiver(receiver->second, capture, session);
  if (!moves && session.gnss.empty())
    session.findings.push_back(
        drive::make_finding(drive::Severity::Problem, "one-stream", path.string(), say::capture_half_a_session()));
  return session;
}

std::optional<drive::TopicOffer> CaptureReader::offer_topics(const fs::path& path, Progress&) const {
  const fs::path capture = only_capture(examine_captures(path), path);
  drive::TopicOffer offer;
  for (const SensorPackets& sensor : sensors_at_begin(capture)) {
    drive::OfferedTopic offered{sensor_topic(sensor), {}, {}};
    offered.uses = {{std::string(kLidarRole), say::capture_offered(sensor.decoder->model())}};
    offer.topics.push_back(std::move(offered));
  }
  if (offer.topics.size() < 2) return std::nullopt;  // nothing to choose
  offer.path = path;
  offer.open = [path](const drive::TopicChoice& topics, Progress& reading) {
    return CaptureReader().open_topics(path, topics, reading);
  };
  return offer;
}

std::vector<drive::LidarOffer> CaptureReader::offer_lidars(const fs::path& path, Progress& progress) const {
  const std::optional<drive::TopicOffer> offer = offer_topics(path, progress);
  if (!offer) return SessionReader::offer_lidars(path, progress);
  std::vector<drive::LidarOffer> offers;
  for (const drive::OfferedTopic& offered : offer->topics)
    offers.push_back({offered.topic.name, {{std::string(kLidarRole), offered.topic.name}}, std::nullopt});
  return offers;
}

}  // namespace remount::formats
