#include "model/formats/ins/text_layout.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "model/formats/files/input_file.h"
#include "model/formats/files/time_unit.h"

namespace remount::formats {
namespace {

constexpr std::size_t kMostHeadLines = 300, kLeastColumns = 4;

/// Letters and digits in small letters: programs write "SDNorth", "SD North" and "sd_north".
std::string plain_name(std::string_view name) {
  std::string plain;
  for (const char c : lower_case(name))
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) plain += c;
  return plain;
}

constexpr std::pair<std::string_view, TextColumn> kNames[] = {
    {"week", TextColumn::Week},
    {"gpsweek", TextColumn::Week},
    {"gpstime", TextColumn::GpsTime},
    {"corrtime", TextColumn::GpsTime},
    {"gpstow", TextColumn::GpsTime},
    {"tow", TextColumn::GpsTime},
    {"timeofweek", TextColumn::GpsTime},
    {"gpstimeofweek", TextColumn::GpsTime},
    {"gpssow", TextColumn::GpsTime},
    {"date", TextColumn::GpsDate},
    {"gpsdate", TextColumn::GpsDate},
    {"utctime", TextColumn::UtcTime},
    {"utctim", TextColumn::UtcTime},
    {"timeutc", TextColumn::UtcTime},
    {"utcdate", TextColumn::UtcDate},
    {"dateutc", TextColumn::UtcDate},
    {"latitude", TextColumn::Latitude},
    {"lat", TextColumn::Latitude},
    {"poslat", TextColumn::Latitude},
    {"longitude", TextColumn::Longitude},
    {"lon", TextColumn::Longitude},
    {"long", TextColumn::Longitude},
    {"poslon", TextColumn::Longitude},
    {"hell", TextColumn::Height},
    {"height", TextColumn::Height},
    {"hght", TextColumn::Height},
    {"ellipsoidheight", TextColumn::Height},
    {"ellipsoidalheight", TextColumn::Height},
    {"heightellipsoid", TextColumn::Height},
    {"altitudeellipsoid", TextColumn::Height},
    {"altitudehae", TextColumn::Height},
    {"altitude", TextColumn::Height},
    {"posalt", TextColumn::Height},
    {"hmsl", TextColumn::SeaHeight},
    {"altitudemsl", TextColumn::SeaHeight},
    {"heightmsl", TextColumn::SeaHeight},
    {"undulation", TextColumn::Undulation},
    {"undul", TextColumn::Undulation},
    {"roll", TextColumn::Roll},
    {"angleroll", TextColumn::Roll},
    {"pitch", TextColumn::Pitch},
    {"anglepitch", TextColumn::Pitch},
    {"heading", TextColumn::Heading},
    {"head", TextColumn::Heading},
    {"yaw", TextColumn::Heading},
    {"azimuth", TextColumn::Heading},
    {"angleheading", TextColumn::Heading},
    {"sdnorth", TextColumn::SigmaNorth},
    {"latitudestd", TextColumn::SigmaNorth},
    {"latitudestddev", TextColumn::SigmaNorth},
    {"northstd", TextColumn::SigmaNorth},
    {"poslatstdev", TextColumn::SigmaNorth},
    {"sdeast", TextColumn::SigmaEast},
    {"longitudestd", TextColumn::SigmaEast},
    {"longitudestddev", TextColumn::SigmaEast},
    {"eaststd", TextColumn::SigmaEast},
    {"poslonstdev", TextColumn::SigmaEast},
    {"sdheight", TextColumn::SigmaUp},
    {"altitudestd", TextColumn::SigmaUp},
    {"altitudestddev", TextColumn::SigmaUp},
    {"posaltstdev", TextColumn::SigmaUp},
    {"rollsd", TextColumn::SigmaRoll},
    {"rollstd", TextColumn::SigmaRoll},
    {"rollstddev", TextColumn::SigmaRoll},
    {"anglerollstdev", TextColumn::SigmaRoll},
    {"pitchsd", TextColumn::SigmaPitch},
    {"pitchstd", TextColumn::SigmaPitch},
    {"pitchstddev", TextColumn::SigmaPitch},
    {"anglepitchstdev", TextColumn::SigmaPitch},
    {"hdngsd", TextColumn::SigmaHeading},
    {"headingsd", TextColumn::SigmaHeading},
    {"headingstd", TextColumn::SigmaHeading},
    {"yawstd", TextColumn::SigmaHeading},
    {"yawstddev", TextColumn::SigmaHeading},
    {"angleheadingstdev", TextColumn::SigmaHeading},
    {"q", TextColumn::Quality},
};

std::optional<TextColumn> column_named(std::string_view name) {
  const std::string plain = plain_name(name);
  const auto found = std::ranges::find(kNames, plain, &std::pair<std::string_view, TextColumn>::first);
  return found == std::end(kNames) ? std::nullopt : std::optional(found->second);
}

TextUnit unit_named(std::string_view name) {
  constexpr std::pair<std::string_view, TextUnit> kUnits[] = {
      {"deg", TextUnit::Degrees},
      {"degree", TextUnit::Degrees},
      {"degrees", TextUnit::Degrees},
      {"rad", TextUnit::Radians},
      {"radian", TextUnit::Radians},
      {"radians", TextUnit::Radians},
      {"dms", TextUnit::DegreesMinutesSeconds},
      {"m", TextUnit::Metres},
      {"meter", TextUnit::Metres},
      {"meters", TextUnit::Metres},
      {"metre", TextUnit::Metres},
      {"metres", TextUnit::Metres},
      {"hms", TextUnit::TimeOfDay},
      {"hhmmss", TextUnit::TimeOfDay},
      {"hhmmsssss", TextUnit::TimeOfDay},
      {"mdy", TextUnit::MonthDayYear},
      {"mmddyyyy", TextUnit::MonthDayYear},
      {"dmy", TextUnit::DayMonthYear},
      {"ddmmyyyy", TextUnit::DayMonthYear},
      {"ymd", TextUnit::YearMonthDay},
      {"yyyymmdd", TextUnit::YearMonthDay},
      {"d", TextUnit::Degrees},
      {"week", TextUnit::None},
      {"weeks", TextUnit::None},
      {"ho", TextUnit::None},
      {"mi", TextUnit::None},
      {"h", TextUnit::None},
      {"min", TextUnit::None},
      {"", TextUnit::None},
  };
  if (trim(name) == "\xc2\xb0") return TextUnit::Degrees;
  const std::optional<std::int64_t> time_unit_ns = time_unit_named_ns(lower_case(trim(name)));
  if (time_unit_ns && *time_unit_ns < 1'000'000) return TextUnit::Unknown;  // of "µs" an "s" would be left
  const std::string plain = plain_name(name);
  if (plain.starts_with("utc")) return TextUnit::None;  // "Time (UTC+1.00)": of which zone
  if (time_unit_named_ns(plain) == 1'000'000'000) return TextUnit::Seconds;
  if (time_unit_named_ns(plain) == 1'000'000) return TextUnit::Milliseconds;
  const auto found = std::ranges::find(kUnits, plain, &std::pair<std::string_view, TextUnit>::first);
  return found == std::end(kUnits) ? TextUnit::Unknown : found->second;
}

/// A word of a line, and where it ends in it.
struct Word {
  std::string_view text;
  std::size_t end = 0;
};

/// What stands in brackets is one word, whatever blanks it has.
std::vector<Word> words_of(std::string_view line) {
  std::vector<Word> words;
  bool closes = true;  // a ')' follows: where none does, each '(' would look for it to the end
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t begin = line.find_first_not_of(" \t", at);
    if (begin == std::string_view::npos) break;
    const std::size_t close = closes && line[begin] == '(' ? line.find(')', begin) : std::string_view::npos;
    if (line[begin] == '(') closes = close != std::string_view::npos;
    at = close != std::string_view::npos ? close + 1 : std::min(line.find_first_of(" \t", begin), line.size());
    words.push_back({line.substr(begin, at - begin), at});
  }
  return words;
}

std::string_view without_brackets(std::string_view text) {
  if (text.starts_with('(') && text.ends_with(')')) return text.substr(1, text.size() - 2);
  if (text.starts_with('[') && text.ends_with(']')) return text.substr(1, text.size() - 2);
  return text;
}

/// "PosLat (deg)": the name, and the unit behind it.
PlacedColumn column_of(std::string_view title) {
  PlacedColumn column;
  title = trim(title);
  const std::size_t open = title.find_last_of("([");
  if (open != std::string_view::npos && open > 0 && (title.ends_with(')') || title.ends_with(']'))) {
    column.unit_name = std::string(without_brackets(title.substr(open)));
    column.unit = unit_named(column.unit_name);
    title = trim(title.substr(0, open));
  }
  column.name = std::string(title.substr(0, 40));
  return column;
}

char separator_of(std::string_view line) {
  constexpr std::ptrdiff_t kLeast = 4;
  for (const char separator : {'\t', ',', ';'})
    if (std::ranges::count(line, separator) >= kLeast) return separator;
  return ' ';
}

/// The columns of a line of names, each with the place where its name ends.
std::vector<std::pair<PlacedColumn, std::size_t>> titles_of(std::string_view line, char separator) {
  std::vector<std::pair<PlacedColumn, std::size_t>> titles;
  if (separator == ' ') {
    for (const Word& word : words_of(line)) {
      if (!word.text.starts_with('(') || titles.empty()) {
        titles.emplace_back(column_of(word.text), word.end);
        continue;
      }
      titles.back().first.unit_name = std::string(without_brackets(word.text).substr(0, 40));
      titles.back().first.unit = unit_named(titles.back().first.unit_name);
    }
    return titles;
  }
  std::vector<std::string_view> fields;
  split_csv(line, fields, separator);
  for (const std::string_view field : fields) titles.emplace_back(column_of(field), titles.size());
  return titles;
}

/// Units of the line below: those of a table with separators by their number, others by where they end, for columns
/// without a unit have no word there.
void take_units(std::string_view line, char separator, std::vector<std::pair<PlacedColumn, std::size_t>>& titles) {
  const auto give = [](PlacedColumn& column, std::string_view unit) {
    column.unit_name = std::string(without_brackets(trim(unit)).substr(0, 40));
    column.unit = unit_named(column.unit_name);
  };
  if (separator != ' ') {
    std::vector<std::string_view> units;
    split_csv(line, units, separator);
    for (std::size_t i = 0; i < std::min(units.size(), titles.size()); ++i)
      if (!units[i].empty()) give(titles[i].first, units[i]);
    return;
  }
  std::size_t next = 0;
  for (const Word& unit : words_of(line)) {
    const auto apart = [&](std::size_t i) {
      return std::abs(static_cast<std::ptrdiff_t>(titles[i].second) - static_cast<std::ptrdiff_t>(unit.end));
    };
    if (next >= titles.size()) return;
    while (next + 1 < titles.size() && apart(next + 1) < apart(next)) ++next;
    give(titles[next].first, unit.text);
    ++next;
  }
}

bool is_line_of_units(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  split_row(line, separator, fields);
  const auto number = [](std::string_view field) { return parse_number(field).has_value(); };
  return !fields.empty() && std::ranges::none_of(fields, number);
}

bool names_enough(const TextLayout& layout) {
  const auto there = std::ranges::count_if(layout.columns, [](const auto& column) { return column.has_value(); });
  return layout.has(TextColumn::Latitude) && layout.has(TextColumn::Longitude) &&
         there >= static_cast<std::ptrdiff_t>(kLeastColumns);
}

/// Whether columns may be a latitude and a longitude, whose names have "lat" and "lon": of a line of numbers that is
/// known sooner than what its columns are called.
struct MayName {
  bool latitude = false, longitude = false;
};
constexpr MayName may_name(std::string_view line) {
  MayName may;
  char before_last = ' ', last = ' ';
  for (const char c : line) {
    const char small = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    if (!((small >= 'a' && small <= 'z') || (small >= '0' && small <= '9'))) continue;
    may.latitude = may.latitude || (before_last == 'l' && last == 'a' && small == 't');
    may.longitude = may.longitude || (before_last == 'l' && last == 'o' && small == 'n');
    before_last = last, last = small;
  }
  return may;
}
// Every name in the list passes; one that does not, such as "phi", needs another look above.
static_assert(std::ranges::all_of(kNames, [](const auto& name) {
  return (name.second != TextColumn::Latitude || may_name(name.first).latitude) &&
         (name.second != TextColumn::Longitude || may_name(name.first).longitude);
}));

/// "UTC+1.00", with whatever mark of decimals, and "UTC+5:30". UTC itself where no number follows; nothing where what
/// follows is no zone.
std::optional<std::int64_t> zone_ahead_ns(std::string_view name) {
  constexpr double kMost_h = 15.0;
  const std::size_t utc = lower_case(name).find("utc");
  const std::string_view zone = utc == std::string::npos ? std::string_view() : trim(name.substr(utc + 3));
  if (zone.find_first_of("0123456789") == std::string_view::npos) return 0;
  if (zone.front() != '+' && zone.front() != '-') return std::nullopt;
  const std::size_t colon = std::min(zone.find(':'), zone.size());
  std::string whole(trim(zone.substr(1, colon - 1)));
  std::ranges::replace(whole, ',', '.');
  const auto hours = parse_number(whole);
  const auto minutes = colon < zone.size() ? parse_integer(zone.substr(colon + 1)) : std::optional<std::int64_t>(0);
  if (!hours || !(*hours >= 0.0 && *hours <= kMost_h) || !minutes || *minutes < 0 || *minutes > 59) return std::nullopt;
  const std::int64_t ahead_s = std::llround(*hours * 3600.0) + *minutes * 60;
  return (zone.front() == '-' ? -1 : 1) * ahead_s * 1'000'000'000;
}

/// Of the time, else of the date: a table may have columns of another zone that are not used.
void take_zone(TextLayout& layout) {
  for (const TextColumn column : {TextColumn::UtcTime, TextColumn::UtcDate}) {
    const auto& placed = layout.of(column);
    if (!placed || !plain_name(placed->unit_name).starts_with("utc")) continue;
    layout.zone_ahead_ns = zone_ahead_ns(placed->unit_name).value_or(0);  // refused by its unit where it is none
    return;
  }
}

/// Places the columns that are known, each where it comes first.
void place_columns(std::vector<std::pair<PlacedColumn, std::size_t>>& titles, TextLayout& layout) {
  std::size_t times = 0;
  for (auto& [title, end] : titles) {
    std::optional<TextColumn> column = column_named(title.name);
    // "UT UT UTCTim" with the units "ho mi (sec)": a time of day in three columns.
    if (plain_name(title.name) == "ut") column = times++ == 0 ? TextColumn::UtcHours : TextColumn::UtcMinutes;
    if (plain_name(title.unit_name).starts_with("utc")) {
      if (column == TextColumn::GpsDate) column = TextColumn::UtcDate;
      if (plain_name(title.name) == "time") column = TextColumn::UtcTime, title.unit = TextUnit::TimeOfDay;
      if (!zone_ahead_ns(title.unit_name)) title.unit = TextUnit::UnknownZone;
    }
    title.at = layout.fields;
    layout.fields += layout.separator == ' ' && title.unit == TextUnit::DegreesMinutesSeconds ? 3 : 1;
    if (plain_name(title.name) == "hell" || plain_name(title.name) == "hdngsd") layout.inertial_explorer = true;
    if (column && !layout.has(*column)) layout.columns[index_of(*column)] = title;
  }
  take_zone(layout);
}

}  // namespace

void split_row(std::string_view line, char separator, std::vector<std::string_view>& fields) {
  if (separator == ' ')
    split_blanks(line, fields);
  else
    split_csv(line, fields, separator);
}

std::optional<TextLayout> find_text_layout(std::string_view text) {
  LineReader lines(text);
  bool inertial_explorer = false, qinertia = false;
  for (std::string_view line; lines.next(line) && lines.line_number() <= kMostHeadLines;) {
    inertial_explorer = inertial_explorer || line.find("Inertial Explorer") != std::string_view::npos;
    qinertia = qinertia || line.find("Qinertia") != std::string_view::npos;
    if (const MayName may = may_name(line); !may.latitude || !may.longitude) continue;
    std::string_view names = line;
    if (const std::size_t mark = names.find_first_of("#%"); mark == 0) names.remove_prefix(1);
    const char separator = separator_of(names);
    auto titles = titles_of(names, separator);
    if (titles.size() < kLeastColumns) continue;
    TextLayout layout;
    layout.separator = separator;
    layout.inertial_explorer = inertial_explorer;
    layout.names_program = inertial_explorer || qinertia;
    layout.rows_at = lines.offset(), layout.rows_line = lines.line_number();
    TextLayout by_names = layout;
    place_columns(titles, by_names);
    if (!names_enough(by_names)) continue;
    std::string_view below;
    if (lines.next(below) && is_line_of_units(below, separator)) {
      if (below.size() > names.size() || names.size() == line.size() || !below.starts_with(line.front()))
        take_units(below, separator, titles);
      else
        take_units(below.substr(1), separator, titles);
      layout.rows_at = lines.offset(), layout.rows_line = lines.line_number();
    }
    place_columns(titles, layout);
    return layout;
  }
  return std::nullopt;
}

}  // namespace remount::formats
