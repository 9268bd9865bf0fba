#include "model/results/pair_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <utility>
#include <variant>

#include "algorithms/core/median.h"
#include "algorithms/messages/catalogue.h"
#include "algorithms/messages/render.h"
#include "messages/pairs.h"
#include "model/drive/session_frames.h"

namespace remount::results {
namespace {

struct OpenDirections {
  std::vector<Eigen::Vector3d> shifts, turns;  ///< in the lidar's axes
  bool known = true;                           ///< every one was understood
};

/// What stands in that place; null where the message has none of that kind.
template <class Value>
const Value* value_at(const Message& message, std::string_view place) {
  const Argument* argument = message.argument(place);
  return argument == nullptr ? nullptr : std::get_if<Value>(&argument->value);
}

bool is_one_of(const Message& message, std::initializer_list<Message> others) {
  return std::any_of(others.begin(), others.end(),
                     [&](const Message& other) { return message.code() == other.code(); });
}

/// The vector of a direction between axes.
std::optional<Eigen::Vector3d> vector_of(const Message& direction) {
  constexpr std::array<std::string_view, 3> kPlaces{"x", "y", "z"};
  Eigen::Vector3d v;
  for (int axis = 0; axis < 3; ++axis) {
    const auto* number = value_at<Quantity>(direction, kPlaces[static_cast<std::size_t>(axis)]);
    if (number == nullptr) return std::nullopt;
    v[axis] = number->value;
  }
  return v;
}

void add_direction(const Message& direction, OpenDirections& open) {
  constexpr std::array<Message (*)(), 3> kShifts{say::open_shift_x, say::open_shift_y, say::open_shift_z},
      kTurns{say::open_turn_x, say::open_turn_y, say::open_turn_z};
  const auto is = [&](Message (*axis)()) { return direction.code() == axis().code(); };
  const auto shift = std::find_if(kShifts.begin(), kShifts.end(), is),
             turn = std::find_if(kTurns.begin(), kTurns.end(), is);
  const bool along = is_one_of(direction, {say::open_shift_along(0.0, 0.0, 0.0)}),
             about = is_one_of(direction, {say::open_turn_about(0.0, 0.0, 0.0)});
  const auto between = along || about ? vector_of(direction) : std::nullopt;
  if (shift != kShifts.end())
    open.shifts.emplace_back(Eigen::Vector3d::Unit(shift - kShifts.begin()));
  else if (turn != kTurns.end())
    open.turns.emplace_back(Eigen::Vector3d::Unit(turn - kTurns.begin()));
  else if (between)
    (along ? open.shifts : open.turns).push_back(*between);
  else
    open.known = false;
}

/// @return nothing where the reason is of another kind
std::optional<OpenDirections> open_directions_of(const Message& reason) {
  OpenDirections open;
  if (reason.code() == kVerbatim) {  // of an older file, where accepted pairs had no other reasons
    open.known = false;
    return open;
  }
  const auto* words = value_at<Message>(reason, "directions");
  if (words == nullptr) return std::nullopt;
  const auto* list = value_at<std::vector<Message>>(*words, "directions");
  if (list == nullptr || list->empty()) open.known = false;
  if (list != nullptr)
    for (const Message& direction : *list) add_direction(direction, open);
  return open;
}

/// Axes of the INS as forward, left, up.
Eigen::Vector3d forward_left_up(const Eigen::Vector3d& in_ins, drive::InsAxes axes) {
  return drive::forward_left_up_from(axes).linear() * in_ins;
}

/// The axis that a direction lies along, within 41 degrees; -1 between them.
int axis_along(const Eigen::Vector3d& direction) {
  constexpr double kAlong = 0.75;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(direction.normalized()[axis]) > kAlong) return axis;
  return -1;
}

Message shifts_in_words(const std::vector<Eigen::Vector3d>& shifts) {
  const auto level = std::count_if(shifts.begin(), shifts.end(),
                                   [](const Eigen::Vector3d& shift) { return std::abs(shift.normalized().z()) < 0.5; });
  if (shifts.size() == 3) return say::unseen_any_shift();
  if (shifts.size() == 2) return level == 2 ? say::unseen_any_shift_level() : say::unseen_shift_two();
  switch (axis_along(shifts.front())) {
    case 0:
      return say::unseen_shift_along();
    case 1:
      return say::unseen_shift_across();
    case 2:
      return say::unseen_height();
    default:
      return say::unseen_shift_one();
  }
}

Message turns_in_words(const std::vector<Eigen::Vector3d>& turns) {
  constexpr std::array<Message (*)(), 3> kNames{say::open_turn_x, say::open_turn_y, say::open_turn_z};
  if (turns.size() > 1) return turns.size() == 3 ? say::unseen_any_turn() : say::unseen_turns_two();
  const int axis = axis_along(turns.front());
  return axis < 0 ? say::unseen_turn_one() : kNames[static_cast<std::size_t>(axis)]();
}

/// What is counted together, and how a line tells it.
struct CountedKind {
  Message words;
  int count = 0;
  bool differ = false;  ///< the words are those of the first; others have other numbers
  std::vector<double> residuals_m;
};
using CountedKinds = std::vector<CountedKind>;

CountedKind& kind_of(CountedKinds& kinds, const Message& words, bool (*alike)(const Message&, const Message&)) {
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const CountedKind& kind) { return alike(kind.words, words); });
  if (found != kinds.end()) return *found;
  kinds.emplace_back().words = words;
  return kinds.back();
}

bool are_equal(const Message& a, const Message& b) { return a == b; }

/// Reasons of one sentence differ in their numbers. The program's own words in files of former versions are one kind:
/// nothing tells which sentence they were. What a user typed is of its own kind.
bool are_of_one_kind(const Message& a, const Message& b) { return a.code() == b.code(); }

void count_rejected(const PairRecord& pair, CountedKinds& kinds) {
  const bool contradicts =
      is_one_of(pair.reason, {say::pair_contradicts_ins({}, {}, 0.0), say::pair_contradicts_ins_screw({}, {}, 0.0)});
  const bool slid = is_one_of(pair.reason, {say::pair_slid({}, {}, {})});
  const Message words = contradicts ? say::pairs_tell_different_motions()
                        : slid      ? say::pairs_aligned_in_wrong_place()
                                    : pair.reason;
  const bool typed = pair.decided_by == motion::DecidedBy::User && words.code() == kVerbatim;
  CountedKind& kind = kind_of(kinds, words, typed ? are_equal : are_of_one_kind);
  ++kind.count;
  kind.differ = kind.differ || kind.words != words;
  if (contradicts || slid) kind.residuals_m.push_back(pair.residual_translation_m);
}

void count_accepted(const PairRecord& pair, const ResultFile& file, CountedKinds& kinds) {
  if (pair.decided_by != motion::DecidedBy::Program) return;
  const Message directions = not_shown_by(pair.reason, file);
  if (!directions.empty()) ++kind_of(kinds, say::pairs_do_not_show(directions), are_equal).count;
}

Message words_of(const CountedKind& kind) {
  std::vector<double> residuals_m = kind.residuals_m;
  if (residuals_m.empty()) return kind.words;
  const double middle_m = median_of(std::move(residuals_m));
  if (!std::isfinite(middle_m)) return kind.words;
  return (kind.count > 1 ? say::pairs_half_by_more : say::pairs_by)(kind.words, {middle_m});
}

using OtherLine = Message (*)(Count);

/// Lines of one state, from the most pairs to the fewest.
void add_lines(CountedKinds kinds, std::size_t most, Message (*line)(Count, Message),
               Message (*instance)(Count, Message), OtherLine other_line, std::vector<Message>& lines) {
  std::stable_sort(kinds.begin(), kinds.end(),
                   [](const CountedKind& a, const CountedKind& b) { return a.count > b.count; });
  int others = 0;
  for (std::size_t i = 0; i < kinds.size(); ++i)
    if (i < most)
      lines.push_back((kinds[i].differ ? instance : line)(kinds[i].count, words_of(kinds[i])));
    else
      others += kinds[i].count;
  if (others > 0) lines.push_back(other_line(others));
}

}  // namespace

Message not_shown_by(const Message& reason, const ResultFile& file) {
  std::optional<OpenDirections> open = open_directions_of(reason);
  if (!open) return {};
  const bool axes_known = calibration::is_usable(file.result) &&
                          file.result.mounting.reference == calibration::BodyFrame::Ins && file.ins_axes;
  if (!open->known || !axes_known) return say::unseen_every_direction();
  for (auto* list : {&open->shifts, &open->turns})
    for (Eigen::Vector3d& direction : *list)
      direction = forward_left_up(file.result.mounting.ins_from_lidar().linear() * direction, *file.ins_axes);
  if (open->shifts.size() == 3 && open->turns.size() == 3) return say::unseen_any_motion();
  if (open->turns.empty()) return shifts_in_words(open->shifts);
  if (open->shifts.empty()) return turns_in_words(open->turns);
  return say::unseen_both(shifts_in_words(open->shifts), turns_in_words(open->turns));
}

std::vector<Message> pair_lines(const ResultFile& file, std::size_t most_kinds) {
  CountedKinds accepted, rejected;
  for (const PairRecord& pair : file.pairs) {
    if (pair.state == motion::PairState::Rejected) count_rejected(pair, rejected);
    if (pair.state == motion::PairState::Accepted) count_accepted(pair, file, accepted);
  }
  std::vector<Message> lines;
  add_lines(std::move(accepted), most_kinds, say::pairs_of_accepted, say::pairs_of_accepted, say::pairs_other_accepted,
            lines);
  add_lines(std::move(rejected), most_kinds, say::pairs_of_rejected, say::pairs_of_rejected_such_as,
            say::pairs_other_rejected, lines);
  return lines;
}

}  // namespace remount::results
