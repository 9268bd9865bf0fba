// What data without a manifest are taken for: each a value with its reasons, for whoever shows or writes them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/messages/message.h"
#include "model/formats/ins/ins_table.h"

namespace remount::guesses {

enum class GuessKind {
  Rows,
  Time,
  Position,
  Attitude,
  PositionSigma,
  AttitudeSigma,
  Quality,
  Scans,
  Stamps,
  Timing,
  Clock
};

enum class Sureness {
  Checked,  ///< the data bear it out, and of what may mean several things refute the others
  Named,    ///< names say so, and nothing contradicts them
  Likely,   ///< better supported than what else it might mean
  Open,     ///< others fit as well: whoever recorded it has to say
  Chosen,   ///< somebody said so
};
/// "checked against the data".
Message words(Sureness sureness);

struct Guess {
  GuessKind kind = GuessKind::Rows;
  std::vector<std::string> columns{};  ///< as the table names them, or their numbers from 0
  std::string unit{};                  ///< "deg", "ns"; empty where there is none
  Sureness sureness = Sureness::Open;
  std::vector<Message> evidence{};      ///< what was looked at, with numbers
  std::vector<Message> alternatives{};  ///< what else it may be, and how that is written
  /// The same as a manifest would read them: of a time its columns alone, else position and attitude.
  std::vector<formats::InsTableLayout> other_layouts{};
  std::optional<std::int64_t>
      added_ns{};  ///< of clocks: to the times of the INS, where one difference brings them together
};

}  // namespace remount::guesses
