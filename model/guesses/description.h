// Data without a manifest, described: what the motion of the INS and the scans are taken for, and how sure that is.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/conventions/clock_hint.h"
#include "model/formats/ins/ins_table.h"
#include "model/guesses/found_files.h"
#include "model/guesses/found_tables.h"
#include "model/guesses/guess.h"
#include "model/guesses/scans_guess.h"

namespace remount::guesses {

/// What a session reader reads as it is.
struct KnownSession {
  std::filesystem::path path;
  std::string format;  ///< id of the reader
  Message what;
};

/// Attitudes that stand in a table of their own.
struct AttitudeGuess {
  std::filesystem::path file;
  formats::InsTableLayout layout{};
  std::vector<Guess> guesses{};
};

/// Where the motion of the INS comes from.
struct InsGuess {
  std::filesystem::path file;
  bool log = false;                          ///< is read by its own reader, without columns
  std::optional<std::string> pose_format{};  ///< likewise, of a file of poses
  formats::InsTableLayout layout{};
  std::vector<Guess> guesses{};
  std::optional<AttitudeGuess> attitude{};  ///< the layout is that of the positions then
  std::size_t samples = 0;
  conventions::TimeSpan span{};
  /// From sample to sample, but for gaps; ascending.
  std::vector<conventions::TimeSpan> stretches{};
  bool week_open = false;
};

/// Count, span and stretches of samples. @param stamps_ns ascending, of one at least
void put_times(const std::vector<std::int64_t>& stamps_ns, InsGuess& ins);
template <class Items>
void put_times_of(const Items& items, InsGuess& ins) {
  std::vector<std::int64_t> stamps_ns;
  for (const auto& item : items) stamps_ns.push_back(item.stamp_ns);
  put_times(stamps_ns, ins);
}

struct Description {
  std::optional<KnownSession> known;  ///< nothing else then
  std::optional<InsGuess> ins;
  std::vector<ScansGuess> lidars;
  std::optional<Guess> clock;  ///< how the clocks of both go together
  std::vector<NotUsed> not_used;
  std::vector<Message> missing;  ///< what a session needs and nothing there gives

  /// A manifest of it can be opened.
  bool complete() const { return missing.empty() && ins && !lidars.empty(); }
  /// One of the guesses has to be settled by whoever recorded it.
  bool open() const;
};

/// What a session needs and a description does not have.
std::vector<Message> what_is_missing(const Description& description);

/// A file of poses of whatever moves, which keep to no direction of travel or have too few turns to tell; nothing where
/// it is none.
std::optional<InsGuess> poses_as_ins(const std::filesystem::path& file);

/// Whether a file is one from which those scans are read: their poses, their times, their table.
bool is_of_scans(const ScansGuess& lidar, const std::filesystem::path& file);

enum class KnownFormats { Told, PassedOver };

/// Looks at files and folders. Asks nothing and writes nothing. What was not compared with the data is said to be so.
/// Throws Error(Io) where something cannot be read.
/// @param known whether what a session reader reads is told as such, and not looked at
Description describe_data(const std::vector<std::filesystem::path>& paths, Progress& progress,
                          KnownFormats known = KnownFormats::Told);

/// The same, with the tables that were looked at.
struct DescribedTables {
  Description description;
  std::vector<FoundTable> tables;
};
DescribedTables look_at_data(const std::vector<std::filesystem::path>& paths, Progress& progress,
                             KnownFormats known = KnownFormats::Told);

}  // namespace remount::guesses
