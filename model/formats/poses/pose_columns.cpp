#include "model/formats/poses/pose_columns.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>

#include "algorithms/core/index.h"
#include "algorithms/core/median.h"
#include "algorithms/core/stamps.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/time_unit.h"

namespace remount::formats {
namespace {

using Words = std::vector<std::string>;

constexpr std::array<std::int64_t, 4> kUnits_ns{1'000'000'000, 1'000'000, 1'000, 1};

/// A column's name in small words ("p_RS_R_x [m]": p, rs, r, x), and the unit in brackets.
struct ColumnName {
  Words words;
  std::string unit;
};

/// The sign or the Greek letter: "µs" is not "s". Other scripts part words: "位置x".
bool is_micro(std::string_view letter) { return letter == "\xc2\xb5" || letter == "\xce\xbc"; }

ColumnName column_name(std::string_view text) {
  ColumnName name;
  std::string word;
  bool in_unit = false;
  const auto end_word = [&] {
    if (!word.empty()) name.words.push_back(word);
    word.clear();
  };
  const std::string letters = lower_case(text);
  for (std::size_t i = 0; i < letters.size(); ++i) {
    const char c = letters[i];
    if (c == '[' || c == '(') in_unit = true;
    const bool of_more_bytes = static_cast<unsigned char>(c) > 0x7f;
    const bool letter = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (in_unit && (letter || of_more_bytes)) name.unit += c;
    if (in_unit) continue;
    if (is_micro(letters.substr(i, 2)))
      word += letters.substr(i++, 2);
    else if (letter)
      word += c;
    else
      end_word();
  }
  end_word();
  return name;
}

bool has_any(const Words& words, std::initializer_list<std::string_view> wanted) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::find(wanted.begin(), wanted.end(), word) != wanted.end();
  });
}

/// "x" of "tx" or "position.x", as far as it is of one of these quantities; -1 where it is not.
int axis_of(const Words& words, std::initializer_list<std::string_view> quantities, char short_name) {
  constexpr std::string_view kAxes = "xyzw";
  if (words.empty()) return -1;
  const std::string& last = words.back();
  if (words.size() == 1 && last.size() == 2 && last.front() == short_name)
    return static_cast<int>(kAxes.find(last.back()) == kAxes.npos ? -1 : static_cast<int>(kAxes.find(last.back())));
  const std::size_t axis = last.size() == 1 ? kAxes.find(last) : kAxes.npos;
  return axis != kAxes.npos && words.size() > 1 && has_any(words, quantities) ? static_cast<int>(axis) : -1;
}

int quaternion_axis(const Words& words) {
  return axis_of(words, {"q", "quat", "quaternion", "orientation", "rotation", "rot", "attitude"}, 'q');
}

int position_axis(const Words& words) {
  if (words.size() == 1 && words[0].size() == 1 && words[0][0] >= 'x' && words[0][0] <= 'z') return words[0][0] - 'x';
  int axis = axis_of(words, {"p", "pos", "position", "t", "trans", "translation"}, 't');
  if (axis < 0) axis = axis_of(words, {}, 'p');
  return axis < 3 ? axis : -1;
}

/// How surely a column is the time: the stamp of a header before the time at which somebody wrote the line.
int time_rank(const ColumnName& name) {
  Words words = name.words;
  while (words.size() > 1 && time_unit_named_ns(words.back())) words.pop_back();
  if (words.empty()) return 0;
  if (has_any(words, {"header"}) && words.back() == "stamp") return 3;
  if (words.back() == "timestamp" || words.back() == "stamp" || words.back() == "timestamps") return 2;
  return words.size() == 1 && has_any(words, {"t", "time", "ts", "sec", "secs", "seconds", "ns", "nsec"}) ? 1 : 0;
}

std::int64_t time_unit_ns(const ColumnName& name) {
  std::optional<std::int64_t> unit_ns = time_unit_named_ns(name.unit);
  if (!unit_ns && !name.words.empty()) unit_ns = time_unit_named_ns(name.words.back());
  return unit_ns.value_or(0);
}

/// Names apart by commas, or by blanks, where a unit in brackets belongs to the name before it.
std::vector<std::string> names_of(std::string_view line) {
  line = trim(line);
  while (line.starts_with('#') || line.starts_with('%')) line = trim(line.substr(1));
  std::vector<std::string_view> fields;
  if (line.find(',') != std::string_view::npos)
    split_csv(line, fields);
  else
    split_blanks(line, fields);
  std::vector<std::string> names;
  for (const std::string_view field : fields) {
    if ((field.starts_with('[') || field.starts_with('(')) && !names.empty())
      names.back() += field;
    else
      names.emplace_back(field);
  }
  return names;
}

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// What was found in a line of names; the first of each counts.
struct Found {
  PoseColumns columns;
  int time_rank = 0;
  std::size_t seconds = kNone, nanoseconds = kNone;
  std::array<std::size_t, 3> position{kNone, kNone, kNone};
  std::array<std::size_t, 4> quaternion{kNone, kNone, kNone, kNone};

  void add(const ColumnName& name, std::size_t column) {
    const auto keep_first = [column](std::size_t& place) { place = place == kNone ? column : place; };
    if (const int axis = quaternion_axis(name.words); axis >= 0) return keep_first(quaternion[index_at(axis)]);
    if (const int axis = position_axis(name.words); axis >= 0) return keep_first(position[index_at(axis)]);
    if (has_any(name.words, {"stamp"}) && has_any(name.words, {"sec", "secs"})) return keep_first(seconds);
    if (has_any(name.words, {"stamp"}) && has_any(name.words, {"nsec", "nsecs", "nanosec"}))
      return keep_first(nanoseconds);
    const int rank = formats::time_rank(name);
    if (rank <= time_rank) return;
    time_rank = rank;
    columns.time = column;
    columns.time_unit_ns = time_unit_ns(name);
  }
};

}  // namespace

std::size_t PoseColumns::last() const {
  return std::max({time, nanoseconds.value_or(0), *std::max_element(position.begin(), position.end()),
                   *std::max_element(quaternion_xyzw.begin(), quaternion_xyzw.end())});
}

PoseColumns usual_pose_columns(bool numbered) {
  PoseColumns columns;
  if (!numbered) return columns;
  ++columns.time;
  for (std::size_t& column : columns.position) ++column;
  for (std::size_t& column : columns.quaternion_xyzw) ++column;
  return columns;
}

bool holds_letters(std::string_view line) {
  return std::ranges::any_of(line, [](char c) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    return static_cast<unsigned char>(c) > 0x7f || (letter && c != 'e' && c != 'E');
  });
}

std::optional<PoseColumns> named_pose_columns(std::string_view line) {
  if (!holds_letters(line)) return std::nullopt;  // known sooner than what each column is called
  Found found;
  const std::vector<std::string> names = names_of(line);
  for (std::size_t i = 0; i < names.size(); ++i) found.add(column_name(names[i]), i);
  if (found.seconds != kNone && found.nanoseconds != kNone) {
    found.columns.time = found.seconds;
    found.columns.nanoseconds = found.nanoseconds;
    found.columns.time_unit_ns = kUnits_ns[0];
  } else if (found.time_rank == 0) {
    return std::nullopt;
  }
  const auto missing = [](std::size_t column) { return column == kNone; };
  if (std::any_of(found.position.begin(), found.position.end(), missing) ||
      std::any_of(found.quaternion.begin(), found.quaternion.end(), missing))
    return std::nullopt;
  found.columns.position = found.position;
  found.columns.quaternion_xyzw = found.quaternion;
  return found.columns;
}

std::optional<std::int64_t> unit_of_stamps_ns(const std::vector<double>& stamps) {
  constexpr double kEarliest_s = 3e8, kLatest_s = 4.1e9;  // 1979 to 2099
  constexpr double kShortestStep_s = 5e-4, kLongestStep_s = 20.0;
  if (stamps.empty()) return std::nullopt;
  std::vector<double> steps;
  for (std::size_t i = 1; i < stamps.size(); ++i)
    if (stamps[i] > stamps[i - 1]) steps.push_back(stamps[i] - stamps[i - 1]);
  const bool one_time = steps.empty();
  const double step = one_time ? 0.0 : median_of(std::move(steps));
  // Nanoseconds since power-on soon have the size of seconds since 1970; their steps have not.
  for (const std::int64_t unit_ns : kUnits_ns) {
    const double in_s = seconds(unit_ns), time_s = stamps.front() * in_s;
    if (time_s > kEarliest_s && time_s < kLatest_s && step * in_s <= kLongestStep_s) return unit_ns;
  }
  if (one_time) return kUnits_ns[0];
  const auto possible = [&](std::int64_t unit_ns) {
    const double step_s = step * static_cast<double>(unit_ns) * 1e-9;
    return step_s >= kShortestStep_s && step_s <= kLongestStep_s;
  };
  if (possible(kUnits_ns[0])) return kUnits_ns[0];
  const auto count = std::count_if(kUnits_ns.begin(), kUnits_ns.end(), possible);
  return count == 1 ? std::optional(*std::find_if(kUnits_ns.begin(), kUnits_ns.end(), possible)) : std::nullopt;
}

std::size_t possible_poses(std::string_view text) {
  constexpr std::size_t kShortest = 15;
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    count += end - at >= kShortest ? 1 : 0;
    at = end + 1;
  }
  return count;
}

}  // namespace remount::formats
