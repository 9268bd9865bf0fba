#include "model/formats/session_readers.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "messages/sessions.h"
#include "model/conventions/held_positions.h"
#include "model/conventions/impossible_motion.h"
#include "model/conventions/plane_poses.h"
#include "model/conventions/pose_north.h"
#include "model/conventions/pose_units.h"
#include "model/conventions/travel_axes.h"
#include "model/conventions/week_rollover.h"
#include "model/formats/bags/bag_reader.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/printable_text.h"
#include "model/formats/files/regular_file.h"
#include "model/formats/files/system_call.h"
#include "model/formats/sessions/capture_reader.h"
#include "model/formats/sessions/gnss_log_reader.h"
#include "model/formats/sessions/ins_log_reader.h"
#include "model/formats/sessions/kitti_odometry_reader.h"
#include "model/formats/sessions/kitti_raw_reader.h"
#include "model/formats/sessions/known_files.h"
#include "model/formats/sessions/native_session_reader.h"
#include "model/formats/sessions/novatel_reader.h"
#include "model/formats/sessions/nuscenes_reader.h"
#include "model/formats/sessions/opencalib_reader.h"
#include "model/formats/sessions/pose_session_reader.h"
#include "model/formats/sessions/several_sessions.h"
#include "model/formats/sessions/smartloc_reader.h"
#include "model/formats/sessions/unused_recordings.h"

namespace remount::formats {

// What each reads stands in one room of the catalogue: here, so that no reader needs it for this alone.
Message NativeSessionReader::description() const { return say::format_native(); }
Message KittiRawReader::description() const { return say::format_kitti_raw(); }
Message KittiOdometryReader::description() const { return say::format_kitti_odometry(); }
Message NuscenesReader::description() const { return say::format_nuscenes(); }
Message OpenCalibReader::description() const { return say::format_opencalib(); }
Message NovatelReader::description() const { return say::format_novatel(); }
Message SmartlocReader::description() const { return say::format_smartloc(); }
Message GnssLogReader::description() const { return say::format_gnss_log(); }
Message InsLogReader::description() const { return say::format_ins_log(); }
Message PoseSessionReader::description() const { return say::format_poses(); }
Message CaptureReader::description() const { return say::format_lidar_capture(); }
}  // namespace remount::formats

namespace remount::bags {
Message BagReader::description() const { return say::format_bag(); }
Message RecordReader::description() const { return say::format_apollo_record(); }
}  // namespace remount::bags

namespace remount::formats {

const std::vector<std::unique_ptr<SessionReader>>& session_readers() {
  static const std::vector<std::unique_ptr<SessionReader>> readers = [] {
    std::vector<std::unique_ptr<SessionReader>> list;
    list.push_back(std::make_unique<NativeSessionReader>());
    list.push_back(std::make_unique<KittiRawReader>());
    list.push_back(std::make_unique<KittiOdometryReader>());
    list.push_back(std::make_unique<NuscenesReader>());
    list.push_back(std::make_unique<OpenCalibReader>());
    list.push_back(std::make_unique<NovatelReader>());
    list.push_back(std::make_unique<SmartlocReader>());
    list.push_back(std::make_unique<GnssLogReader>());
    list.push_back(std::make_unique<InsLogReader>());
    list.push_back(std::make_unique<PoseSessionReader>());
    list.push_back(std::make_unique<bags::BagReader>());
    list.push_back(std::make_unique<bags::RecordReader>());
    list.push_back(std::make_unique<CaptureReader>());
    return list;
  }();
  return readers;
}

namespace {

/// What cannot be read is not recognised either: what is without permission must not pass for no known format.
void refuse_unreadable(const std::filesystem::path& path) {
  if (!is_folder(path)) (void)open_regular_file(path);  // names FIFOs and devices
  for (const std::filesystem::path& file : files_in(path)) (void)open_regular_file(file);
  for (const std::filesystem::path& folder : directories_in(path))
    if (!may_look_into(folder)) (void)files_in(folder);  // says why not
}

const SessionReader* surest_reader(const std::filesystem::path& path) {
  const SessionReader* best = nullptr;
  int best_score = 0;
  for (const auto& reader : session_readers()) {
    const int score = reader->probe(path);
    if (score > best_score) best = reader.get(), best_score = score;
  }
  return best;
}

/// A day's folder: sessions lie right below it. None where that is cancelled.
std::vector<std::filesystem::path> sessions_below(const std::filesystem::path& folder, const Progress& progress) {
  constexpr std::size_t kMostEntries = 1000;  // more is no folder of drives
  std::vector<std::filesystem::path> entries = files_in(folder), found;
  for (std::filesystem::path& below : directories_in(folder))
    if (may_look_into(below)) entries.push_back(std::move(below));
  if (entries.size() > kMostEntries) return {};
  for (const std::filesystem::path& entry : entries) {
    if (progress.cancelled()) return {};
    if (surest_reader(entry)) found.push_back(entry);
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// What can be read, a line each.
std::vector<Message> format_lines() {
  std::vector<Message> lines;
  for (const auto& reader : session_readers()) lines.push_back(say::session_format_line("  ", reader->description()));
  return lines;
}

/// That it is no session, with what lies there where that is known: of a file itself, of a folder the first such file.
Message no_session_words(const std::filesystem::path& path) {
  constexpr std::size_t kMostLookedAt = 200;
  if (!is_folder(path)) {
    const auto known = known_file(path);
    return known ? say::session_unknown_file(known->what(), known->remedy(), format_lines())
                 : say::session_unknown(format_lines());
  }
  std::size_t looked_at = 0;
  for (const std::filesystem::path& file : files_in(path)) {
    if (looked_at++ == kMostLookedAt) break;
    if (const auto known = known_file(file))
      return say::session_unknown_folder(known->what(), printable(file.filename().string(), LineBreaks::Escaped),
                                         known->remedy(), format_lines());
  }
  return say::session_unknown(format_lines());
}

}  // namespace

const SessionReader* recognise_session(const std::filesystem::path& path) { return surest_reader(path); }

namespace {

/// The reader that is surest of what lies there. Throws Error where none recognises it.
const SessionReader& reader_of(const std::filesystem::path& path, const Progress& progress) {
  std::error_code error;
  if (!status_of(path))
    throw Error(ErrorCode::Io, path.string(),
                std::filesystem::is_symlink(path, error) ? say::session_dangling_link() : say::session_missing());
  if (const SessionReader* best = surest_reader(path)) return *best;
  if (const auto sessions = sessions_below(path, progress); !sessions.empty()) {
    // Files beside others that may not be read: half of a session, likely.
    if (std::any_of(sessions.begin(), sessions.end(), is_file)) refuse_unreadable(path);
    throw SeveralSessions(path, say::session_several_below(lines_of(sessions)), sessions);
  }
  refuse_unreadable(path);
  if (std::filesystem::is_regular_file(path, error) && std::filesystem::file_size(path, error) == 0)
    throw Error(ErrorCode::Format, path.string(), say::session_empty_file(Bytes{0}));
  throw Error(ErrorCode::Unsupported, path.string(), no_session_words(path));
}

/// What no reader can judge while it reads line by line, alike for all of them.
void settle(drive::Session& session) {
  conventions::mend_week_rollover(session);
  conventions::leave_out_impossible(session);
  conventions::refuse_foreign_units(session);
  conventions::interpolate_held_positions(session);
  conventions::settle_north(session);
  conventions::settle_axes(session);
  conventions::settle_plane(session);
}

}  // namespace

drive::Session settled_session(drive::Session session, const Progress& progress, checks::LookAt look_at) {
  settle(session);
  tell_unused_recordings(session);
  for (drive::Finding& finding : checks::data_findings(session, look_at, progress))
    session.findings.push_back(std::move(finding));
  return session;
}

drive::Session open_session(const std::filesystem::path& path, Progress& progress, checks::LookAt look_at) {
  return open_session(path, {}, progress, look_at);
}

drive::Session open_session(const std::filesystem::path& path, const drive::TopicChoice& topics, Progress& progress,
                            checks::LookAt look_at) {
  return settled_session(reader_of(path, progress).open_topics(path, topics, progress), progress, look_at);
}

std::optional<drive::TopicOffer> offer_topics(const std::filesystem::path& path, Progress& progress) {
  std::optional<drive::TopicOffer> offer = reader_of(path, progress).offer_topics(path, progress);
  if (offer)
    offer->open = [open = offer->open](const drive::TopicChoice& topics, Progress& reading) {
      return settled_session(open(topics, reading), reading);
    };
  return offer;
}

std::vector<drive::LidarOffer> offer_lidars(const std::filesystem::path& path, Progress& progress) {
  return reader_of(path, progress).offer_lidars(path, progress);
}

}  // namespace remount::formats
