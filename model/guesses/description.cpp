#include "model/guesses/description.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "algorithms/core/error.h"
#include "algorithms/core/median.h"
#include "messages/guesses.h"
#include "messages/stages.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/ins/ins_log.h"
#include "model/formats/ins/nmea_log.h"
#include "model/formats/ins/novatel_log.h"
#include "model/formats/poses/pose_file.h"
#include "model/formats/session_readers.h"
#include "model/formats/sessions/native_declared.h"
#include "model/formats/sessions/several_sessions.h"
#include "model/guesses/clock_guess.h"
#include "model/guesses/found_tables.h"
#include "model/guesses/joined_tables.h"
#include "model/guesses/motion_parts.h"
#include "model/guesses/scan_clock.h"
#include "model/guesses/table_guess.h"

namespace remount::guesses {

namespace fs = std::filesystem;

namespace {

/// What comes of opening what a reader recognises.
struct Opened {
  bool whole = false;  ///< some recognise a log of the INS beside clouds that they do not read
  std::optional<Message> refused;
};

Opened opened_by(const formats::SessionReader& reader, const fs::path& path, bool clouds, Progress& progress) {
  try {
    const drive::Session session = reader.open(path, progress);
    return {!clouds || session.scans || !session.odometry_from_lidar.empty(), std::nullopt};
  } catch (const formats::SeveralSessions&) {
    return {true, std::nullopt};
  } catch (const Error& error) {
    return {false, drive::message_of(error)};
  }
}

/// @param clouds are there, which the reader must read to make a manifest needless
std::optional<KnownSession> known_session(const std::vector<fs::path>& paths, bool clouds, Progress& progress,
                                          std::vector<NotUsed>& not_used) {
  for (const fs::path& path : paths) {
    const formats::SessionReader* reader = formats::recognise_session(path);
    if (!reader) continue;
    const bool native = reader->id() == "native";  // which may name clouds that lie elsewhere, or none
    Opened opened = opened_by(*reader, path, clouds && !native, progress);
    if (opened.whole) return KnownSession{path, std::string(reader->id()), reader->description()};
    if (opened.refused)
      not_used.push_back({path, native ? say::guess_manifest_refused(std::move(*opened.refused))
                                       : say::guess_format_refused(reader->description(), std::move(*opened.refused))});
  }
  return std::nullopt;
}

/// A log that says itself what it holds. Exports that name no program are tables like others: what stands in them is
/// compared with the drive.
bool is_log(const fs::path& file) {
  const formats::InsLogKind* kind = formats::ins_log_kind(file);
  if (kind) return kind->id != "trajectory-text" || kind->post_processed(file);
  return formats::recognise_nmea(file) || formats::recognise_novatel(file) == formats::NovatelFormat::Log;
}

std::optional<InsGuess> read_log(const fs::path& file, std::vector<NotUsed>& not_used) {
  InsGuess ins{.file = file, .log = true};
  drive::Session session;
  try {
    const formats::DocumentNode name = formats::DocumentNode::string(file.string());
    if (!formats::read_ins_log(formats::DocumentView(name, file.string()), file, session)) return std::nullopt;
  } catch (const Error& error) {
    not_used.push_back({file, drive::message_of(error)});
    return std::nullopt;
  }
  put_times_of(session.ins, ins);
  ins.week_open = session.ins_week_open;
  ins.guesses.push_back({GuessKind::Rows, {}, "", Sureness::Checked, {say::guess_is_a_log(ins.samples)}, {}});
  return ins;
}

/// Of several the one during which most scans were taken, of those the surest, then the one with most samples.
double rank_of(const InsGuess& ins, const std::vector<std::int64_t>& stamps_ns) {
  const std::size_t inside = count_within(ins, stamps_ns);
  constexpr double kOfScans = 200.0, kOfLog = 100.0;
  double rank = ins.log ? kOfLog : 0.0;
  if (!stamps_ns.empty()) rank += kOfScans * static_cast<double>(inside) / static_cast<double>(stamps_ns.size());
  for (const Guess& guess : ins.guesses)
    rank += guess.sureness == Sureness::Checked  ? 10.0
            : guess.sureness == Sureness::Named  ? 6.0
            : guess.sureness == Sureness::Likely ? 3.0
                                                 : 0.0;
  return rank + std::log10(1.0 + static_cast<double>(ins.samples));
}

bool is_used(const fs::path& file, const Description& description) {
  if (description.ins && description.ins->file == file) return true;
  if (description.ins && description.ins->attitude && description.ins->attitude->file == file) return true;
  return std::ranges::any_of(description.lidars, [&](const ScansGuess& lidar) { return is_of_scans(lidar, file); });
}

/// A file of LiDAR poses, where nothing else of a LiDAR is there.
void take_lidar_poses(const std::vector<FoundTable>& tables, Description& description) {
  for (const FoundTable& found : tables) {
    if (description.ins && description.ins->file == found.file) continue;
    const auto format = formats::recognise_pose_file(found.file);
    if (!format) continue;
    std::vector<drive::Finding> findings;
    try {
      const auto poses = formats::read_pose_file(found.file, *format, findings);
      ScansGuess lidar;
      lidar.directory = found.file;
      lidar.pose_format = std::string(formats::to_string(*format));
      lidar.count = poses.size();
      lidar.timed = true;
      for (const motion::StampedPose& pose : poses) lidar.stamps_ns.push_back(pose.stamp_ns);
      lidar.guesses.push_back({GuessKind::Scans, {}, "", Sureness::Likely, {say::guess_lidar_poses(poses.size())}, {}});
      description.lidars.push_back(std::move(lidar));
      return;
    } catch (const Error& error) {
      description.not_used.push_back({found.file, drive::message_of(error)});
    }
  }
}

std::vector<std::int64_t> stamps_of_lidars(const Description& description) {
  std::vector<std::int64_t> stamps_ns;
  for (const ScansGuess& lidar : description.lidars)
    stamps_ns.insert(stamps_ns.end(), lidar.stamps_ns.begin(), lidar.stamps_ns.end());
  return stamps_ns;
}

/// Where the week is open it stays so: which it is, the scans tell.
void guess_ins(const std::vector<fs::path>& logs, const std::vector<FoundTable>& tables, const Progress& progress,
               Description& description) {
  const std::vector<std::int64_t> stamps_ns = stamps_of_lidars(description);
  double best = 0.0;
  const auto offer = [&](std::optional<InsGuess> one) {
    if (!one) return;
    InsGuess placed = *one;
    place_in_week(placed, stamps_ns);
    const double rank = rank_of(placed, stamps_ns);
    if (description.ins && rank <= best) return;
    best = rank;
    description.ins = std::move(one);
  };
  for (const fs::path& log : logs) offer(read_log(log, description.not_used));
  for (const FoundTable& found : tables) {
    if (progress.cancelled()) return;
    const bool of_scans =
        std::ranges::any_of(description.lidars, [&](const ScansGuess& lidar) { return lidar.stamps == found.file; });
    if (of_scans || found.table.columns.size() < kFewestColumnsOfMotion) continue;
    std::vector<Message> lacks;
    auto motion = guess_ins_of(found, stamps_ns, progress, lacks);
    if (!motion && !description.lidars.empty()) motion = poses_as_ins(found.file);
    if (motion) lacks.clear();
    offer(std::move(motion));
    for (Message& lack : lacks) description.not_used.push_back({found.file, say::guess_lacks(std::move(lack))});
  }
}

/// Where no table has the whole motion: positions from one, attitudes from another.
void guess_ins_of_parts(const std::vector<FoundTable>& tables, const Progress& progress, Description& description) {
  constexpr std::size_t kMostPairs = 20;
  const std::vector<std::int64_t> stamps_ns = stamps_of_lidars(description);
  std::vector<const FoundTable*> positions, attitudes;
  for (const FoundTable& found : tables) {
    const MotionPart part = motion_part_of(found.table);
    if (part == MotionPart::Positions) positions.push_back(&found);
    if (part == MotionPart::Attitudes) attitudes.push_back(&found);
  }
  double best = 0.0;
  std::size_t pairs = 0;
  for (const FoundTable* places : positions)
    for (const FoundTable* turns : attitudes) {
      if (progress.cancelled() || ++pairs > kMostPairs) return;
      std::vector<Message> lacks;
      auto one = guess_ins_of_two(*places, *turns, stamps_ns, progress, lacks);
      for (Message& lack : lacks) description.not_used.push_back({turns->file, say::guess_lacks(std::move(lack))});
      if (!one) continue;
      InsGuess placed = *one;
      place_in_week(placed, stamps_ns);
      const double rank = rank_of(placed, stamps_ns);
      if (rank <= best) continue;
      best = rank;
      description.ins = std::move(one);
    }
}

void tell_missing(const std::vector<FoundTable>& tables, Description& description) {
  description.missing = what_is_missing(description);
  for (const FoundTable& found : tables)
    if (!is_used(found.file, description) &&
        std::ranges::none_of(description.not_used, [&](const NotUsed& one) { return one.path == found.file; }))
      description.not_used.push_back({found.file, found.table.columns.size() < kFewestColumnsOfMotion
                                                      ? say::guess_too_few_columns()
                                                      : say::guess_other_is_better()});
  std::erase_if(description.not_used, [&](const NotUsed& one) { return is_used(one.path, description); });
}

}  // namespace

Message words(Sureness sureness) {
  switch (sureness) {
    case Sureness::Checked:
      return say::guess_is_checked();
    case Sureness::Named:
      return say::guess_is_named();
    case Sureness::Likely:
      return say::guess_is_likely();
    case Sureness::Chosen:
      return say::guess_is_chosen();
    default:
      return say::guess_is_open();
  }
}

void put_times(const std::vector<std::int64_t>& stamps_ns, InsGuess& ins) {
  constexpr double kShortestGap_ns = 5e8, kGapInSteps = 5.0;
  // Further apart than an integer holds they may be as well.
  const auto apart_ns = [](std::int64_t a, std::int64_t b) { return static_cast<double>(b) - static_cast<double>(a); };
  ins.samples = stamps_ns.size();
  ins.span = {stamps_ns.front(), stamps_ns.back()};
  std::vector<double> steps_ns;
  for (std::size_t i = 1; i < stamps_ns.size(); ++i) steps_ns.push_back(apart_ns(stamps_ns[i - 1], stamps_ns[i]));
  const double usual_ns = steps_ns.empty() ? 0.0 : median_of(std::move(steps_ns));
  const double gap_ns = std::max(kShortestGap_ns, kGapInSteps * usual_ns);
  ins.stretches = {{stamps_ns.front(), stamps_ns.front()}};
  for (const std::int64_t stamp_ns : stamps_ns) {
    if (apart_ns(ins.stretches.back().last_ns, stamp_ns) > gap_ns) ins.stretches.push_back({stamp_ns, stamp_ns});
    ins.stretches.back().last_ns = stamp_ns;
  }
}

std::optional<InsGuess> poses_as_ins(const fs::path& file) {
  const auto format = formats::recognise_pose_file(file);
  if (!format) return std::nullopt;
  try {
    std::vector<drive::Finding> findings;
    const auto poses = formats::read_pose_file(file, *format, findings);
    InsGuess ins{.file = file, .pose_format = std::string(formats::to_string(*format))};
    put_times_of(poses, ins);
    ins.guesses.push_back({GuessKind::Rows, {}, "", Sureness::Open, {say::guess_as_poses(poses.size())}, {}});
    return ins;
  } catch (const Error&) {
    return std::nullopt;  // what the table lacks has been said
  }
}

bool is_of_scans(const ScansGuess& lidar, const fs::path& file) {
  return lidar.directory == file || lidar.stamps == file || (lidar.table && lidar.table->table == file);
}

std::vector<Message> what_is_missing(const Description& description) {
  std::vector<Message> missing;
  if (!description.ins) missing.push_back(say::guess_needs_ins());
  if (description.lidars.empty()) missing.push_back(say::guess_needs_lidar());
  for (const ScansGuess& lidar : description.lidars)
    if (!lidar.timed && !lidar.capture)
      missing.push_back(say::guess_needs_stamps(lidar.count, lidar.directory.string()));
  return missing;
}

bool Description::open() const {
  const auto any_open = [](const std::vector<Guess>& guesses) {
    return std::ranges::any_of(guesses, [](const Guess& one) { return one.sureness == Sureness::Open; });
  };
  // Whether scans are compensated is tried before a calibration: timing is no question to anybody.
  const auto lidar_open = [&](const ScansGuess& lidar) {
    std::vector<Guess> asked = lidar.guesses;
    std::erase_if(asked, [](const Guess& one) { return one.kind == GuessKind::Timing; });
    return any_open(asked);
  };
  return (ins && any_open(ins->guesses)) || (ins && ins->attitude && any_open(ins->attitude->guesses)) ||
         std::ranges::any_of(lidars, lidar_open) || (clock && clock->sureness == Sureness::Open);
}

Description describe_data(const std::vector<fs::path>& paths, Progress& progress, KnownFormats known) {
  return look_at_data(paths, progress, known).description;
}

DescribedTables look_at_data(const std::vector<fs::path>& paths, Progress& progress, KnownFormats known) {
  DescribedTables looked_at;
  Description& description = looked_at.description;
  progress.report(say::stage_looking_at_files, 0, 0);
  FoundFiles found = find_files(paths, progress);
  if (known == KnownFormats::Told)
    description.known = known_session(paths, !found.clouds.empty(), progress, found.not_used);
  if (description.known) return looked_at;
  description.not_used = std::move(found.not_used);
  put_rare_kinds_first(found.others);
  constexpr std::size_t kMostLookedAt = 2000;
  if (found.others.size() > kMostLookedAt) {
    description.not_used.push_back(
        {found.others[kMostLookedAt], say::guess_not_looked_at(found.others.size() - kMostLookedAt)});
    found.others.resize(kMostLookedAt);
  }
  std::vector<fs::path> logs, texts;
  for (const fs::path& file : found.others) (is_log(file) ? logs : texts).push_back(file);
  looked_at.tables = find_tables(texts, found.clouds, progress, description.not_used);
  const std::vector<FoundTable>& tables = looked_at.tables;
  for (const CloudFolder& folder : found.clouds) {
    if (progress.cancelled()) return looked_at;
    description.lidars.push_back(guess_scans(folder, tables, progress));
  }
  for (const fs::path& capture : found.captures) {
    ScansGuess lidar;
    lidar.directory = capture;
    lidar.capture = true;
    lidar.name = capture.stem().string();
    lidar.guesses.push_back({GuessKind::Scans, {}, "", Sureness::Named, {say::guess_capture()}, {}});
    description.lidars.push_back(std::move(lidar));
  }
  guess_ins(logs, tables, progress, description);
  if (!description.ins || description.ins->pose_format) guess_ins_of_parts(tables, progress, description);
  if (description.ins) {
    for (std::size_t i = 0; i < found.clouds.size(); ++i)
      take_clock_of_ins(found.clouds[i], *description.ins, description.lidars[i]);
    place_in_week(*description.ins, stamps_of_lidars(description));
  }
  if (description.lidars.empty()) take_lidar_poses(tables, description);
  tell_missing(tables, description);
  if (description.ins) description.clock = guess_clock(*description.ins, description.lidars);
  return looked_at;
}

}  // namespace remount::guesses
