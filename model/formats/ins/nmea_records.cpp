#include "model/formats/ins/nmea_records.h"

#include <algorithm>
#include <cmath>

#include "messages/general.h"
#include "messages/ins_logs.h"
#include "model/drive/attitude_convention.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/text_file.h"
#include "model/formats/files/time_stamp.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

std::optional<NmeaErrors> stated_errors(const NmeaSentence& sentence) {
  const auto north = parse_number(sentence.field(5)), east = parse_number(sentence.field(6)),
             up = parse_number(sentence.field(7));
  if (!north || !east || !up || !(*north > 0.0 && *east > 0.0 && *up > 0.0)) return std::nullopt;
  return NmeaErrors{*north, *east, *up};
}

std::size_t occurrences(std::string_view text, std::string_view word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + word.size())) ++count;
  return count;
}

bool tells_date(std::string_view type) { return type == "RMC" || type == "ZDA"; }

/// How good a position is by the quality that GGA states: fixed, float, corrected in another way, precise service,
/// alone, and what is estimated, entered or simulated.
int rank_of_quality(int quality) {
  switch (quality) {
    case 4:
      return 6;
    case 5:
      return 5;
    case 2:
    case 9:
      return 4;
    case 3:
      return 3;
    case 1:
      return 2;
    default:
      return 1;
  }
}

/// What a talker's fixes are like beside those that others give of the same times.
struct TalkerRecord {
  std::size_t wins = 0, fixes = 0;
  bool operator<(const TalkerRecord& other) const {
    return std::pair(wins, fixes) < std::pair(other.wins, other.fixes);
  }
};

NmeaTalker talker_of(const NmeaSentence& sentence) {
  return sentence.talker.size() == 2 ? NmeaTalker{sentence.talker[0], sentence.talker[1]} : NmeaTalker{};
}

/// Receivers that write into one log write of one time close together.
constexpr std::size_t kFixesOfOneTime = 32;

/// The fix of the same time among the last ones before place `end`; `end` where there is none.
std::size_t of_same_time(const std::vector<NmeaFix>& fixes, std::size_t end, std::int64_t time_ns) {
  const std::size_t first = end - std::min(end, kFixesOfOneTime);
  for (std::size_t i = end; i > first; --i)
    if (fixes[i - 1].time_ns == time_ns) return i - 1;
  return end;
}

}  // namespace

NmeaRecords NmeaRecords::read(const fs::path& path) { return parse(read_text_file(path), path); }

NmeaRecords NmeaRecords::parse(std::string_view text, const fs::path& path) {
  NmeaRecords records(path);
  records.reserve(text);
  records.take_lines(text);
  records.require_fixes_and_date();
  records.midnight_ns = *records.dated_;
  return records;
}

bool NmeaRecords::reads(std::string_view type) { return std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end(); }

// Growing by doubling would take several times as much. What a file only promises is bounded by the shortest sentence.
void NmeaRecords::reserve(std::string_view text) {
  constexpr std::size_t kShortestFix = 40, kShortestAttitude = 40, kShortestHeading = 24;  // with the line of its time
  fixes.reserve(std::min(occurrences(text, "GGA,"), text.size() / kShortestFix));
  for (std::size_t kind = 0; kind < attitudes.size(); ++kind) {
    const std::string mark = std::string(name(static_cast<NmeaAttitudeKind>(kind))) + ",";
    attitudes[kind].samples.reserve(std::min(occurrences(text, mark), text.size() / kShortestAttitude));
  }
  places.reserve(std::min(occurrences(text, "HDT,"), text.size() / kShortestHeading));
}

void NmeaRecords::take_lines(std::string_view text) {
  LineReader lines(text);
  for (std::string_view line; lines.next(line);) {
    line_number_ = lines.line_number();
    take_line(line, lines.offset() == text.size() && !text.ends_with('\n'));
  }
}

void NmeaRecords::take_line(std::string_view line, bool at_end) {
  NmeaSentence sentence;
  const NmeaLine kind = parse_nmea(line, sentence);
  Usual* const usual =
      std::find_if(usual_.begin(), usual_.end(), [&](const Usual& one) { return one.type == sentence.type; });
  if (kind == NmeaLine::WrongChecksum) {
    const bool cut = at_end && line.size() - line.rfind('*') < std::string_view("*00").size();
    if (cut)
      cut_line = line_number_;
    else
      add_bad(sentence.type, say::nmea_checksum_wrong());
    return;
  }
  // A sentence whose end is missing still has numbers, of which the last may have lost digits.
  const bool checksum = sentence.has_checksum;
  const bool known = kind == NmeaLine::Sentence && usual != usual_.end();
  // What is no sentence any more was cut; one of a kind that is not read, only where the others end in a checksum.
  const bool checksums = kind != NmeaLine::Sentence ||
                         std::any_of(usual_.begin(), usual_.end(), [](const Usual& one) { return one.checksum; });
  const bool cut = known ? !checksum && (usual->checksum || (at_end && sentence.fields.size() < usual->fields))
                         : at_end && !checksum && checksums && line.find('$') != std::string_view::npos;
  if (cut && at_end) {
    cut_line = line_number_;
  } else if (cut) {
    add_bad(sentence.type, say::nmea_checksum_missing(std::string(sentence.type)));
  } else if (kind == NmeaLine::Sentence) {
    if (known) usual->checksum = usual->checksum || checksum, usual->fields = sentence.fields.size();
    const std::string type(sentence.type);
    const bool taken = take(sentence);
    if (jumped_)
      add_bad(type, say::nmea_time_jumps(type));
    else if (!taken)
      add_bad(type, say::nmea_no_values(type));
  }
}

void NmeaRecords::add_bad(std::string_view type, Message why) {
  const Message what = say::of_file(at_line(path_, line_number_), std::move(why));
  bad.add(what);
  if (tells_date(type)) bad_dates_.add(what);
}

void NmeaRecords::require_fixes_and_date() const {
  if (fixes.empty()) throw Error(ErrorCode::Format, path_.string(), bad.after(say::nmea_no_fix()));
  if (dated_) return;
  if (bad_dates_.count() > 0)
    throw Error(ErrorCode::Format, path_.string(), bad_dates_.after(say::nmea_date_damaged()));
  throw Error(ErrorCode::Format, path_.string(), say::nmea_no_date());
}

// False where the sentence is of a kind that is read, and cannot be.
bool NmeaRecords::take(const NmeaSentence& sentence) {
  timed_ = jumped_ = false;
  const bool taken = take_kind(sentence);
  if (!timed_ && sentence.type != "HDT" && sentence.type != "THS") places.add_other();
  return taken;
}

bool NmeaRecords::take_kind(const NmeaSentence& sentence) {
  if (sentence.type == "GGA") return take_fix(sentence);
  if (sentence.type == "RMC") return take_date(sentence.field(0), sentence.field(8));
  if (sentence.type == "ZDA")
    return take_date(sentence.field(0),
                     std::string(sentence.field(1)) + std::string(sentence.field(2)) + std::string(sentence.field(3)));
  if (sentence.type == "GST") return take_error(sentence);
  if (sentence.type == "HDT" || sentence.type == "THS") return take_heading(sentence);
  if (sentence.type == "PASHR" && sentence.field(2) == "T") return take_pashr(sentence);
  if (sentence.type == "KSXT") return take_ksxt(sentence);
  if (sentence.type == "FPD" || sentence.type == "CHC") return take_gps_time_record(sentence);
  if (sentence.type.find(',') != std::string_view::npos) return take_two_antennas(sentence);
  return true;
}

std::optional<std::int64_t> NmeaRecords::running(std::optional<std::int64_t> time_of_day_ns) {
  const auto now = time_of_day_ns ? day_.running_ns(*time_of_day_ns) : std::nullopt;
  jumped_ = time_of_day_ns && !now;
  if (!now) return std::nullopt;
  places.add_time(*day_.latest_ns());
  timed_ = true;
  return now;
}

bool NmeaRecords::take_fix(const NmeaSentence& sentence) {
  places.add_position();
  const auto time = running(nmea_time_ns(sentence.field(0)));
  const auto quality = parse_integer(sentence.field(5));
  if (!time || !quality) return sentence.field(0).empty();  // before the first fix receivers leave all empty
  if (*quality <= 0 || *quality > 9) return true;
  const auto latitude = nmea_angle_rad(sentence.field(1), sentence.field(2));
  const auto longitude = nmea_angle_rad(sentence.field(3), sentence.field(4));
  const auto height = parse_number(sentence.field(8)), geoid = parse_number(sentence.field(10));
  if (!latitude || !longitude || !height ||
      !drive::plausible_geodetic(*latitude, *longitude, *height + geoid.value_or(0.0)))
    return false;
  without_geoid += !geoid;
  fixes.push_back({*time, *latitude, *longitude, *height + geoid.value_or(0.0),
                   static_cast<float>(parse_number(sentence.field(7)).value_or(1.0)),
                   static_cast<std::int8_t>(*quality), talker_of(sentence)});
  return true;
}

// ddmmyy or ddmmyyyy
bool NmeaRecords::take_date(std::string_view time_text, std::string_view date) {
  const auto time = running(nmea_time_ns(time_text));
  return !time || take_date(*time, date);
}

bool NmeaRecords::take_date(std::int64_t running_ns, std::string_view date) {
  if (dated_ || date.empty()) return true;
  if (date.size() != 6 && date.size() != 8) return false;
  const std::string year = (date.size() == 6 ? "20" : "") + std::string(date.substr(4));
  const auto midnight =
      parse_date_ns(year + "-" + std::string(date.substr(2, 2)) + "-" + std::string(date.substr(0, 2)) + " 00:00:00");
  if (!midnight) return false;
  const std::int64_t day =
      running_ns < 0 ? -1 : running_ns / kUtcDay_ns;  // a late sentence has the date of the day before
  dated_ = *midnight - day * kUtcDay_ns;
  return true;
}

bool NmeaRecords::take_error(const NmeaSentence& sentence) {
  const auto time = running(nmea_time_ns(sentence.field(0)));
  const auto error = stated_errors(sentence);
  if (time && error) errors[{*time, talker_of(sentence)}] = *error;
  return time.has_value();
}

bool NmeaRecords::take_heading(const NmeaSentence& sentence) {
  const auto heading = nmea_degrees_rad(sentence.field(0));
  const bool invalid = sentence.type == "THS" && sentence.field(1) == "V";
  if (heading && !invalid) places.add_heading(*heading);
  return heading || sentence.field(0).empty();
}

void NmeaRecords::keep_best_fixes() {
  std::map<NmeaTalker, TalkerRecord> talkers;
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    ++talkers[fixes[i].talker].fixes;
    const std::size_t other = of_same_time(fixes, i, fixes[i].time_ns);
    if (other == i || fixes[other].talker == fixes[i].talker) continue;
    const int better = rank_of_quality(fixes[i].quality) - rank_of_quality(fixes[other].quality);
    if (better != 0) ++talkers[fixes[better > 0 ? i : other].talker].wins;
  }
  if (talkers.size() < 2) return;  // what one writes twice is put in order with its stamps
  const auto is_better = [&](const NmeaFix& one, const NmeaFix& other) {
    const int by = rank_of_quality(one.quality) - rank_of_quality(other.quality);
    return by > 0 || (by == 0 && talkers[other.talker] < talkers[one.talker]);
  };
  std::size_t kept = 0;
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    const NmeaFix fix = fixes[i];
    const std::size_t same = of_same_time(fixes, kept, fix.time_ns);
    if (same == kept || fixes[same].talker == fix.talker) {
      fixes[kept++] = fix;
      continue;
    }
    ++of_one_time;
    if (is_better(fix, fixes[same])) fixes[same] = fix;
  }
  fixes.resize(kept);
}

const NmeaErrors* NmeaRecords::errors_of(const NmeaFix& fix) const {
  if (const auto own = errors.find({fix.time_ns, fix.talker}); own != errors.end()) return &own->second;
  const auto any = errors.lower_bound({fix.time_ns, NmeaTalker{}});
  return any != errors.end() && any->first.first == fix.time_ns ? &any->second : nullptr;
}

}  // namespace remount::formats
