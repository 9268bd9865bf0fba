// Whether what is said of a table goes with what stands in it: the rows, the way that it drives, its clock.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/guesses/description.h"
#include "model/overview/drive_overview.h"

namespace remount::guesses {

enum class CheckKind { Rows, Rate, Position, Height, Heading, Pitch, Clock };
inline constexpr std::size_t kCheckKindCount = 7;
Message words(CheckKind kind);

enum class Verdict {
  Good,
  NotTold,   ///< the drive does not tell
  Doubtful,  ///< unusual
  Bad,       ///< so it cannot be meant
};

struct ImportCheck {
  CheckKind kind = CheckKind::Rows;
  Verdict verdict = Verdict::Good;
  std::vector<Message> evidence{};         ///< what was found, with numbers; the first is the most important
  std::optional<std::int64_t> added_ns{};  ///< of the clocks: what is advised to be added to the times of the table
};

/// What a layout makes of a table.
struct ImportChecks {
  std::vector<ImportCheck> checks;  ///< each kind once at most; where nothing can be read, that of the rows alone
  std::size_t samples = 0;          ///< 0: nothing can be read
  conventions::TimeSpan span{};     ///< of the samples; placed in the week of the scans
  std::vector<conventions::TimeSpan> stretches{};  ///< of it, without gaps
  bool week_open = false;
  overview::DriveOverview drive;  ///< its streams, how long and far it goes, and its track; nothing else of it

  const ImportCheck* find(CheckKind kind) const;
};

/// Reads the whole table. Where that is cancelled, something of no meaning.
/// @param ins file, and layout or format of poses
/// @param rows that there are, for the count of those which were rejected
/// @param stamps_ns of the scans; may be empty
ImportChecks check_import(const InsGuess& ins, std::size_t rows, const std::vector<std::int64_t>& stamps_ns,
                          const Progress& progress);

/// The rows of a layout that is not whole.
ImportChecks unreadable(std::vector<Message> why);

}  // namespace remount::guesses
