#include "remount/session.h"

#include <algorithm>
#include <utility>

#include "algorithms/motion/keyframes.h"
#include "api/bridge.h"
#include "api/own_recording.h"
#include "messages/programs.h"
#include "model/drive/session_frames.h"
#include "model/formats/session_readers.h"
#include "model/overview/session_report.h"
#include "model/pipeline/drive_motion.h"

namespace remount::api {
namespace {

template <class Samples>
std::vector<std::int64_t> stamps_of(const Samples& samples) {
  std::vector<std::int64_t> stamps_ns;
  for (const auto& sample : samples) stamps_ns.push_back(sample.stamp_ns);
  return stamps_ns;
}

void add_stream(const std::string& sensor, const std::vector<std::int64_t>& stamps_ns, std::vector<Stream>& streams) {
  if (stamps_ns.empty()) return;
  const overview::StreamReport report = overview::report_stream(stamps_ns);
  streams.push_back(
      {sensor, report.count, report.first_ns, report.last_ns, report.rate_hz, report.gaps, report.longest_gap_s});
}

/// The topics that open the LiDAR of that name. Throws remount::Error(Contract) that lists those that are there.
drive::TopicChoice choice_of(const std::filesystem::path& path, const std::string& lidar, remount::Progress& progress) {
  std::vector<std::string> names;
  for (const drive::LidarOffer& offer : formats::offer_lidars(path, progress)) {
    if (offer.name == lidar) return offer.choice;
    names.push_back(offer.name);
  }
  const bool unnamed = std::ranges::all_of(names, [](const std::string& name) { return name.empty(); });
  throw remount::Error(remount::ErrorCode::Contract, path.string(),
                       unnamed ? say::api_unnamed_lidars(lidar) : say::api_no_such_lidar(lidar, names));
}

/// Throws remount::Error(Contract).
const drive::ScanSource& scans_with(const drive::Session& session, std::size_t scan) {
  const std::size_t count = session.scans ? session.scans->size() : 0;
  if (scan >= count)
    throw remount::Error(remount::ErrorCode::Contract, session.name, say::api_no_such_scan(scan, count));
  return *session.scans;
}

}  // namespace

// Defined here, so that the class has its vtable and type information in the library.
ScanSource::~ScanSource() = default;

Session::Session(std::shared_ptr<const drive::Session> session) : session_(std::move(session)) {}

std::string Session::name() const { return session_->name; }
std::filesystem::path Session::path() const { return session_->path; }
std::string Session::format() const { return session_->format; }
std::string Session::lidar() const { return session_->lidar_name; }
std::optional<Matrix4> Session::nominal_ins_from_lidar() const {
  if (!session_->nominal_ins_from_lidar) return std::nullopt;
  return matrix_of(*session_->nominal_ins_from_lidar);
}
std::vector<Finding> Session::findings() const { return findings_of(session_->findings); }

std::vector<Stream> Session::sensors() const {
  std::vector<Stream> streams;
  add_stream("lidar", overview::lidar_stamps_ns(*session_), streams);
  add_stream("ins", session_->ins.empty() ? stamps_of(session_->world_from_ins) : stamps_of(session_->ins), streams);
  add_stream("imu", stamps_of(session_->imu), streams);
  add_stream("gnss", stamps_of(session_->gnss), streams);
  add_stream("wheels", stamps_of(session_->wheels), streams);
  add_stream("barometer", stamps_of(session_->barometer), streams);
  return streams;
}

std::vector<Keyframe> Session::keyframes(const Settings& settings) const {
  return guarded([&] {
    const pipeline::DriveMotion motion({session_});
    constexpr motion::SessionIndex kOnly;
    std::vector<Keyframe> keyframes;
    for (const motion::Keyframe& keyframe : motion::select_keyframes(
             kOnly, motion.lidar_stamps_ns(kOnly), motion.track(kOnly), 0.0, settings.inside().keyframes))
      keyframes.push_back({0, keyframe.scan, keyframe.stamp_ns, keyframe.travelled_m});
    return keyframes;
  });
}

std::size_t Session::scan_count() const { return session_->scans ? session_->scans->size() : 0; }

std::int64_t Session::scan_stamp_ns(std::size_t scan) const {
  return guarded([&] { return scans_with(*session_, scan).stamp_ns(scan); });
}

Scan Session::load_scan(std::size_t scan) const {
  return guarded([&] {
    cloud::PointCloud cloud = scans_with(*session_, scan).load(scan);
    return Scan{std::move(cloud.points), std::move(cloud.time_from_stamp_s), std::move(cloud.intensity),
                std::move(cloud.ring)};
  });
}

std::vector<Pose> Session::local_from_ins() const {
  return guarded([&] {
    std::vector<Pose> poses;
    for (const motion::StampedPose& pose : drive::metric_poses(*session_))
      poses.push_back({pose.stamp_ns, matrix_of(pose.pose)});
    return poses;
  });
}

Session open_session(const std::filesystem::path& path, const OpenOptions& options, const Progress& progress) {
  return to_the_end(progress, path.string(), [&](remount::Progress& inner) {
    drive::TopicChoice choice;
    if (!options.lidar.empty()) choice = choice_of(path, options.lidar, inner);
    for (const auto& [role, topic] : options.topics) choice[role] = topic;
    return Session(std::make_shared<const drive::Session>(formats::open_session(path, choice, inner)));
  });
}

std::vector<std::string> lidars_of(const std::filesystem::path& path, const Progress& progress) {
  return to_the_end(progress, path.string(), [&](remount::Progress& inner) {
    std::vector<std::string> names;
    for (const drive::LidarOffer& offer : formats::offer_lidars(path, inner)) names.push_back(offer.name);
    return names;
  });
}

Session make_session(const Recording& recording, const Progress& progress) {
  return to_the_end(progress, recording.name, [&](remount::Progress& inner) {
    return Session(std::make_shared<const drive::Session>(formats::settled_session(session_of(recording), inner)));
  });
}

}  // namespace remount::api
