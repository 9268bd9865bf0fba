#include "model/pair_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>

#include "algorithms/core/median.h"
#include "algorithms/messages/render.h"
#include "model/session_frames.h"

namespace remount {
namespace {

constexpr std::string_view kOpen = "does not determine ", kContradicts = "contradicts the INS motion",
                           kSlid = "aligned ";

/// The words between commas, but for commas in brackets; without "(axes of the lidar)".
std::vector<std::string> parts_of(std::string list) {
  list = list.substr(0, list.find(" (axes"));
  std::vector<std::string> parts(1);
  bool in_brackets = false;
  for (const char letter : list) {
    in_brackets = letter == '[' || (in_brackets && letter != ']');
    if (letter == ',' && !in_brackets)
      parts.emplace_back();
    else if (letter != ' ' || !parts.back().empty())
      parts.back() += letter;
  }
  return parts;
}

struct OpenDirections {
  std::vector<Eigen::Vector3d> shifts, turns;  ///< in the lidar's axes
  bool known = true;                           ///< every part was understood
};

std::optional<Eigen::Vector3d> bracketed(const std::string& part) {
  const std::size_t bracket = part.find('[');
  Eigen::Vector3d v;
  if (bracket == std::string::npos || std::sscanf(part.c_str() + bracket, "[%lf, %lf, %lf]", &v[0], &v[1], &v[2]) != 3)
    return std::nullopt;
  return v;
}

OpenDirections open_directions_of(const std::string& list) {
  constexpr std::array<std::string_view, 3> kShifts{"x", "y", "z"}, kTurns{"roll", "pitch", "yaw"};
  OpenDirections open;
  for (const std::string& part : parts_of(list)) {
    const auto shift = std::find(kShifts.begin(), kShifts.end(), part),
               turn = std::find(kTurns.begin(), kTurns.end(), part);
    if (shift != kShifts.end())
      open.shifts.emplace_back(Eigen::Vector3d::Unit(shift - kShifts.begin()));
    else if (turn != kTurns.end())
      open.turns.emplace_back(Eigen::Vector3d::Unit(turn - kTurns.begin()));
    else if (const auto along = bracketed(part))
      (part.starts_with("the shift") ? open.shifts : open.turns).push_back(*along);
    else
      open.known = false;
  }
  return open;
}

/// Axes of the INS as forward, left, up.
Eigen::Vector3d forward_left_up(const Eigen::Vector3d& in_ins, InsAxes axes) {
  return forward_left_up_from(axes).linear() * in_ins;
}

/// The axis that a direction lies along, within 41 degrees; -1 between them.
int axis_along(const Eigen::Vector3d& direction) {
  constexpr double kAlong = 0.75;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(direction.normalized()[axis]) > kAlong) return axis;
  return -1;
}

std::string shifts_in_words(const std::vector<Eigen::Vector3d>& shifts) {
  const auto level = std::count_if(shifts.begin(), shifts.end(),
                                   [](const Eigen::Vector3d& shift) { return std::abs(shift.normalized().z()) < 0.5; });
  if (shifts.size() == 3) return "any shift";
  if (shifts.size() == 2 && level == 2) return "any shift over the ground";
  if (shifts.size() == 2) return "the shift in two directions";
  switch (axis_along(shifts.front())) {
    case 0:
      return "the shift along the street";
    case 1:
      return "the shift across the street";
    case 2:
      return "the height";
    default:
      return "the shift in one direction";
  }
}

std::string turns_in_words(const std::vector<Eigen::Vector3d>& turns) {
  constexpr std::array<const char*, 3> kNames{"roll", "pitch", "yaw"};
  if (turns.size() > 1) return turns.size() == 3 ? "any turn" : "turns about two axes";
  const int axis = axis_along(turns.front());
  return axis < 0 ? "the turn about one axis" : kNames[static_cast<std::size_t>(axis)];
}

/// What is counted together, and how a line tells it.
struct CountedKind {
  int count = 0;
  std::string words;
  bool differ = false;  ///< the words are those of the first; others have other numbers
  std::vector<double> residuals_m;
};
using CountedKinds = std::map<std::string, CountedKind>;

/// Reasons differ in their numbers: "overlap 0.21 is below 0.30" and so on.
std::string without_numbers(const std::string& reason) {
  const auto is_digit = [&](std::size_t i) { return i < reason.size() && reason[i] >= '0' && reason[i] <= '9'; };
  std::string kind;
  for (std::size_t i = 0; i < reason.size(); ++i) {
    const bool sign = (reason[i] == '.' || reason[i] == '-') && is_digit(i + 1) &&
                      (kind.empty() || kind.back() == '#' || kind.back() == ' ');
    if (!is_digit(i) && !sign)
      kind += reason[i];
    else if (kind.empty() || kind.back() != '#')
      kind += '#';
  }
  return kind;
}

void count_rejected(const PairRecord& pair, CountedKinds& kinds) {
  const std::string reason = english(pair.reason);
  const bool contradicts = reason.starts_with(kContradicts), slid = reason.starts_with(kSlid);
  CountedKind& kind = kinds[contradicts ? std::string(kContradicts)
                            : slid      ? std::string(kSlid)
                                        : without_numbers(reason)];
  if (kind.count++ == 0)
    kind.words = contradicts ? "scans and INS tell different motions"
                 : slid      ? "the scans show too little and were aligned in the wrong place"
                             : reason;
  kind.differ = !contradicts && !slid && (kind.differ || reason != kind.words);
  if (contradicts || slid) kind.residuals_m.push_back(pair.residual_translation_m);
}

std::vector<CountedKind> by_count(const CountedKinds& kinds) {
  std::vector<CountedKind> list;
  for (const auto& [key, kind] : kinds) list.push_back(kind);
  std::stable_sort(list.begin(), list.end(),
                   [](const CountedKind& a, const CountedKind& b) { return a.count > b.count; });
  return list;
}

std::string line_of(const CountedKind& kind, const char* state) {
  std::string text = std::to_string(kind.count) + " " + state + (kind.differ ? ", for instance: " : ": ") + kind.words;
  std::vector<double> residuals_m = kind.residuals_m;
  if (residuals_m.empty()) return text;
  const double middle_m = median_of(std::move(residuals_m));
  char by[48];
  std::snprintf(by, sizeof by, kind.count > 1 ? ", half of them by more than %.2g m" : ", by %.2g m", middle_m);
  return std::isfinite(middle_m) ? text + by : text;
}

}  // namespace

std::string not_shown_by(const std::string& reason, const ResultFile& file) {
  const std::size_t at = reason.find(kOpen);
  if (at == std::string::npos) return {};
  OpenDirections open = open_directions_of(reason.substr(at + kOpen.size()));
  if (!open.known) return "every direction of motion";
  const bool axes_known = is_usable(file.result) && file.result.reference_frame == "ins" && file.ins_axes;
  if (!axes_known) return "every direction of motion";
  for (auto* list : {&open.shifts, &open.turns})
    for (Eigen::Vector3d& direction : *list)
      direction = forward_left_up(file.result.ins_from_lidar.linear() * direction, *file.ins_axes);
  if (open.shifts.size() == 3 && open.turns.size() == 3) return "any motion at all";
  if (open.turns.empty()) return shifts_in_words(open.shifts);
  if (open.shifts.empty()) return turns_in_words(open.turns);
  return shifts_in_words(open.shifts) + " and " + turns_in_words(open.turns);
}

std::vector<std::string> pair_lines(const ResultFile& file, std::size_t most_kinds) {
  CountedKinds accepted, rejected;
  for (const PairRecord& pair : file.pairs) {
    if (pair.state == PairState::Rejected) count_rejected(pair, rejected);
    if (pair.state != PairState::Accepted || pair.decided_by != DecidedBy::Program) continue;
    const std::string words = not_shown_by(english(pair.reason), file);
    if (words.empty()) continue;
    ++accepted[words].count;
    accepted[words].words = "the scans do not show " + words;
  }
  std::vector<std::string> lines;
  for (const auto& [kinds, state] :
       {std::pair(&accepted, "of the accepted"), std::pair(&rejected, "of the rejected")}) {
    const std::vector<CountedKind> list = by_count(*kinds);
    int others = 0;
    for (std::size_t i = 0; i < list.size(); ++i)
      if (i < most_kinds)
        lines.push_back(line_of(list[i], state));
      else
        others += list[i].count;
    if (others > 0)
      lines.push_back(std::to_string(others) + " " + state + ": " +
                      (kinds == &accepted ? "the scans do not show other motions" : "other reasons") +
                      " (see the result file)");
  }
  return lines;
}

}  // namespace remount
