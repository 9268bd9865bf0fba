// Attitudes of an NMEA log that have a time of their own, as makers write them.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "algorithms/core/index.h"
#include "model/conventions/assumed_tilt.h"
#include "model/drive/attitude_convention.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/ins/nmea_records.h"

namespace remount::formats {

namespace {

constexpr std::array<std::string_view, kNmeaAttitudeKinds> kAttitudeKinds{"PASHR",    "FPD",  "CHC",     "PSAT,HPR",
                                                                          "PSSN,HRP", "KSXT", "PTNL,AVR"};
constexpr NmeaTalker kFpdTalker{'F', 'D'}, kChcTalker{'C', 'H'}, kKsxtTalker{'K', 'S'};

/// The quality that GGA would state for the numbers that makers give a solution of single, float and fixed.
int gga_quality(std::int64_t solution) { return solution == 3 ? 4 : solution == 2 ? 5 : 1; }

constexpr int kUnknownQuality = 0, kDeadReckoning = 6;

/// GPFPD: the last digit is the state of the INS, 0 before it has begun to align, 1 and 2 while it does, 8 on its
/// inertial sensors alone. Nothing where there is no solution yet.
std::optional<int> fpd_quality(std::string_view status) {
  const char state = status.empty() ? ' ' : status.back();
  if (state == '0') return std::nullopt;
  return state == '1' || state == '2' || state == '8' ? kDeadReckoning : kUnknownQuality;
}

/// GPCHC, two hexadecimal digits: the last is the state of the INS, 0 before it has begun, 1 by satellites alone,
/// 2 by both, which is the best, 3 by its inertial sensors alone; the first the position by satellites, 0 none,
/// 1 single, 2 differential, 3 extrapolated, 4 RTK fixed, 5 RTK float; 6 to 9 are 1, 2, 4 and 5 without a heading.
std::optional<int> chc_quality(std::string_view status) {
  constexpr std::array<int, 10> kPositions{kDeadReckoning, 1, 2, kDeadReckoning, 4, 5, 1, 2, 4, 5};
  if (status.empty()) return kUnknownQuality;
  const char state = status.back(), position = status.size() > 1 ? status[status.size() - 2] : '0';
  const bool by_satellites = state == '1';
  if (state == '0' || (by_satellites && position == '0')) return std::nullopt;
  if (state == '3') return kDeadReckoning;
  if ((state != '2' && !by_satellites) || position < '0' || position > '9') return kUnknownQuality;
  const int quality = kPositions[index_at(position - '0')];
  return by_satellites && quality == 4 ? 5 : quality;  // its attitude is not that of an INS: no good sample
}

}  // namespace

std::string_view NmeaRecords::name(NmeaAttitudeKind kind) { return kAttitudeKinds[index_of(kind)]; }

bool NmeaRecords::has_position(NmeaAttitudeKind kind) {
  return kind == NmeaAttitudeKind::Fpd || kind == NmeaAttitudeKind::Chc;
}

std::optional<NmeaAttitudeKind> NmeaRecords::best_attitudes() const {
  // A roll that is guessed makes up for no more than four times as many samples.
  const auto worth = [](const NmeaAttitudes& one) { return one.samples.size() * (one.rolls ? 4 : 1); };
  const auto best =
      std::max_element(attitudes.begin(), attitudes.end(),
                       [&](const NmeaAttitudes& a, const NmeaAttitudes& b) { return worth(a) < worth(b); });
  if (best->samples.empty()) return std::nullopt;
  return static_cast<NmeaAttitudeKind>(best - attitudes.begin());
}

std::size_t NmeaRecords::keep_fixes_of(NmeaAttitudeKind kind) {
  const auto of_ins = [](const NmeaFix& fix) { return fix.talker == kFpdTalker || fix.talker == kChcTalker; };
  const NmeaTalker own = kind == NmeaAttitudeKind::Fpd ? kFpdTalker : kChcTalker;
  const bool others = std::any_of(fixes.begin(), fixes.end(), [&](const NmeaFix& fix) { return !of_ins(fix); });
  return std::erase_if(
      fixes, [&](const NmeaFix& fix) { return has_position(kind) ? fix.talker != own : others && of_ins(fix); });
}

bool NmeaRecords::add_attitude(NmeaAttitudeKind kind, std::int64_t time_ns, const NmeaSentence& sentence,
                               const std::array<std::size_t, 3>& fields) {
  const auto heading = nmea_degrees_rad(sentence.field(fields[0])), pitch = nmea_degrees_rad(sentence.field(fields[1])),
             roll = nmea_degrees_rad(sentence.field(fields[2]));
  const auto usable = [&](const std::optional<double>& angle, std::size_t i) {
    return angle || sentence.field(fields[i]).empty();
  };
  if (sentence.field(fields[0]).empty()) return true;  // before the antennas have found it
  if (!heading || !usable(pitch, 1) || !usable(roll, 2)) return false;
  NmeaAttitudes& all = of(kind);
  all.rolls = all.rolls || has_position(kind) || (roll && *roll != 0.0);
  const double unknown = std::nan("");
  all.samples.push_back(
      {time_ns,
       drive::enu_from_ins({*heading, pitch.value_or(0.0), roll.value_or(0.0)}, drive::AttitudeConvention::Heading),
       {roll ? unknown : conventions::kAssumedTilt_rad, pitch ? unknown : conventions::kAssumedTilt_rad, unknown}});
  return true;
}

bool NmeaRecords::take_pashr(const NmeaSentence& sentence) {
  const auto time = running(nmea_time_ns(sentence.field(0)));
  const auto heading = nmea_degrees_rad(sentence.field(1)), roll = nmea_degrees_rad(sentence.field(3)),
             pitch = nmea_degrees_rad(sentence.field(4));
  if (!time || !heading || !roll || !pitch) return false;
  const auto sigma = [&](std::size_t field) {
    const auto value = nmea_degrees_rad(sentence.field(field));
    return value && *value > 0.0 ? *value : std::nan("");
  };
  of(NmeaAttitudeKind::Pashr).rolls = true;
  of(NmeaAttitudeKind::Pashr)
      .samples.push_back({*time, drive::enu_from_ins({*heading, *pitch, *roll}, drive::AttitudeConvention::Heading),
                          drive::axis_sigma_rad({sigma(8), sigma(7), sigma(6)}, drive::AttitudeConvention::Heading)});
  return true;
}

// $PTNL,AVR,time,yaw,Yaw,tilt,Tilt,roll,Roll,range,quality,...; $PSAT,HPR,time,heading,pitch,roll,type;
// $PSSN,HRP,time,date,heading,roll,pitch,...
bool NmeaRecords::take_two_antennas(const NmeaSentence& sentence) {
  const auto kind = static_cast<NmeaAttitudeKind>(
      std::find(kAttitudeKinds.begin(), kAttitudeKinds.end(), sentence.type) - kAttitudeKinds.begin());
  if (index_of(kind) == kNmeaAttitudeKinds) return true;  // one that is not read
  const auto time = running(nmea_time_ns(sentence.field(0)));
  if (!time) return sentence.field(0).empty();
  if (kind == NmeaAttitudeKind::Hpr) return add_attitude(kind, *time, sentence, {1, 2, 3});
  if (kind == NmeaAttitudeKind::Hrp) return add_attitude(kind, *time, sentence, {2, 4, 3});
  if (parse_integer(sentence.field(8)) == 0) return true;  // no fix of the second antenna
  return add_attitude(kind, *time, sentence, {1, 3, 5});
}

bool NmeaRecords::add_place(std::int64_t time_ns, const NmeaSentence& sentence, std::size_t latitude,
                            std::size_t longitude, std::size_t height, int quality, NmeaTalker talker) {
  const auto latitude_deg = parse_number(sentence.field(latitude)),
             longitude_deg = parse_number(sentence.field(longitude)), height_m = parse_number(sentence.field(height));
  if (!latitude_deg || !longitude_deg || !height_m) return false;
  const double latitude_rad = degrees_to_radians(*latitude_deg), longitude_rad = degrees_to_radians(*longitude_deg);
  if (!drive::plausible_geodetic(latitude_rad, longitude_rad, *height_m)) return false;
  if (latitude_rad == 0.0 && longitude_rad == 0.0) return true;  // what is written before there is a position
  fixes.push_back({time_ns, latitude_rad, longitude_rad, *height_m, 1.0F, static_cast<std::int8_t>(quality), talker});
  return true;
}

// $KSXT,yyyymmddhhmmss.ss,longitude,latitude,height,heading,pitch,track,speed,roll,position,heading solved,...
bool NmeaRecords::take_ksxt(const NmeaSentence& sentence) {
  const std::string_view moment = sentence.field(0);
  if (moment.size() < 14) return moment.empty();
  const std::string date =
      std::string(moment.substr(6, 2)) + std::string(moment.substr(4, 2)) + std::string(moment.substr(0, 4));
  places.add_position();
  const auto now = running(nmea_time_ns(moment.substr(8)));
  const auto solved = parse_integer(sentence.field(9));
  if (!now || !take_date(*now, date) || !solved) return false;
  if (*solved > 0 && !add_place(*now, sentence, 2, 1, 3, gga_quality(*solved), kKsxtTalker)) return false;
  if (parse_integer(sentence.field(10)).value_or(0) == 0) return true;
  return add_attitude(NmeaAttitudeKind::Ksxt, *now, sentence, {4, 5, 8});
}

// $GPFPD,week,time of week,heading,pitch,roll,latitude,longitude,height,3 speeds,baseline,2 counts,status;
// $GPCHC,week,time of week,heading,pitch,roll,3 rates,3 forces,latitude,longitude,height,4 speeds,2 counts,status,...
bool NmeaRecords::take_gps_time_record(const NmeaSentence& sentence) {
  const bool fpd = sentence.type == "FPD";
  const auto kind = fpd ? NmeaAttitudeKind::Fpd : NmeaAttitudeKind::Chc;
  const auto week = parse_integer(sentence.field(0)), in_week_ns = parse_seconds_ns(sentence.field(1));
  const auto stamp_ns = week && in_week_ns ? unix_ns_from_gps_week(*week, *in_week_ns) : std::nullopt;
  if (!stamp_ns) return false;
  const std::string_view status = sentence.field(fpd ? 14 : 20);
  places.add_position();
  const auto now = running(*stamp_ns % kUtcDay_ns);
  if (!now) return false;
  if (!dated_) dated_ = *stamp_ns - *now;
  const std::optional<int> quality = fpd ? fpd_quality(status) : chc_quality(status);
  if (!quality) return true;
  const std::size_t place = fpd ? 5 : 11;
  return add_place(*now, sentence, place, place + 1, place + 2, *quality, fpd ? kFpdTalker : kChcTalker) &&
         add_attitude(kind, *now, sentence, {2, 3, 4});
}

}  // namespace remount::formats
