// Logs of receivers read back what was written into them: random drives over what real ones hold (south of the equator,
// across the date line, over midnight and the end of a GPS week, at any rate), with as many digits as devices print.
#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/ins/nmea_log.h"
#include "model/formats/ins/novatel_frames.h"
#include "model/formats/ins/novatel_log.h"
#include "model/formats/poses/gpx_track.h"
#include "tests/model/formats/ins/nmea_text.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/model/formats/written_logs.h"

namespace remount::formats {
namespace {

/// East, north, up from x right, y forward, z up: about z by the azimuth clockwise, then pitch about x, roll about y.
Eigen::Quaterniond novatel_attitude(const InsLine& line) {
  return Eigen::AngleAxisd(degrees_to_radians(-line.heading_deg), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(degrees_to_radians(line.pitch_deg), Eigen::Vector3d::UnitX()) *
         Eigen::AngleAxisd(degrees_to_radians(line.roll_deg), Eigen::Vector3d::UnitY());
}

struct Digits {
  int place = 0, height = 0, angle = 0;
};

void compare(const std::vector<motion::InsSample>& read, const std::vector<InsLine>& written, const Digits& digits,
             double place_lost_deg, Worst& worst_place, Worst& worst_attitude, Worst& worst_height) {
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    ASSERT_EQ(read[i].stamp_ns, written[i].stamp_ns) << i;
    worst_place.add(apart_deg(read[i].latitude_rad, written[i].at.latitude_deg), place_lost_deg + 1e-13);
    worst_place.add(apart_deg(read[i].longitude_rad, written[i].at.longitude_deg), place_lost_deg + 1e-13);
    worst_height.add(std::abs(read[i].height_m - written[i].height_m - written[i].undulation_m),
                     2.0 * lost(digits.height) + 1e-12);
    // Three angles, each rounded by itself.
    const double off_rad = 2.0 * (read[i].enu_from_ins.conjugate() * novatel_attitude(written[i])).vec().norm();
    worst_attitude.add(radians_to_degrees(off_rad), 3.0 * lost(digits.angle) + 1e-12);
  }
}

std::string inspvaxa(const InsLine& line, const Digits& digits) {
  const std::int64_t gps_ns = line.stamp_ns - kGpsEpoch_ns + kLeap_ns;
  std::string body = "INSPVAXA,COM1,0,73.5,FINESTEERING," + std::to_string(gps_ns / kWeek_ns) + "," +
                     seconds_text(gps_ns % kWeek_ns, 9) + ",00000040,4e77,43562;INS_SOLUTION_GOOD,INS_RTKFIXED";
  for (const double angle_deg : {line.at.latitude_deg, line.at.longitude_deg})
    body += "," + fixed(angle_deg, digits.place);
  for (const double height_m : {line.height_m, line.undulation_m}) body += "," + fixed(height_m, digits.height);
  body += ",-0.1,0.2,0.0";
  for (const double angle_deg : {line.roll_deg, line.pitch_deg, line.heading_deg})
    body += "," + fixed(angle_deg, digits.angle);
  body += ",0.01,0.01,0.02,0.03,0.03,0.03,0.01,0.01,0.02,00000000,0";
  char end[16];
  std::snprintf(end, sizeof end, "*%08x\r\n", novatel_crc32(body));
  return "#" + body + end;
}

TEST(log_round_trip, inspvax_logs) {
  RandomValues random(31);
  const TemporaryFolder folder;
  Worst place("place, deg"), attitude("attitude, deg"), height("height, m");
  for (int draw = 0; draw < 150; ++draw) {
    SCOPED_TRACE("draw " + std::to_string(draw));
    const Digits digits{8 + static_cast<int>(random.below(5)), 3 + static_cast<int>(random.below(4)),
                        6 + static_cast<int>(random.below(5))};
    const std::vector<InsLine> written = ins_lines(random, stamps(random, moment(random), 1, 400.0));
    std::string text;
    for (const InsLine& line : written) text += inspvaxa(line, digits);
    std::vector<drive::Finding> findings;
    const NovatelLog log = read_novatel(folder.write("log.txt", text), NovatelFormat::Log, findings);
    EXPECT_TRUE(findings.empty()) << english(findings.front().explanation);
    compare(log.ins, written, digits, lost(digits.place), place, attitude, height);
  }
}

TEST(log_round_trip, inspvax_tables_with_their_time_in_any_unit) {
  RandomValues random(32);
  const TemporaryFolder folder;
  Worst place("place, deg"), attitude("attitude, deg"), height("height, m");
  for (int draw = 0; draw < 150; ++draw) {
    SCOPED_TRACE("draw " + std::to_string(draw));
    const Digits digits{8 + static_cast<int>(random.below(5)), 3 + static_cast<int>(random.below(4)),
                        6 + static_cast<int>(random.below(5))};
    enum Unit { NamedMilliseconds, Milliseconds, Seconds } unit = static_cast<Unit>(random.below(3));
    // In a column of another name, milliseconds in the first ten minutes of a week could be either.
    std::int64_t middle_ns = moment(random);
    if (unit == Milliseconds && (middle_ns - kGpsEpoch_ns + kLeap_ns) % kWeek_ns < 1000 * kSecond_ns)
      middle_ns += 2000 * kSecond_ns;
    const std::vector<InsLine> written = ins_lines(random, stamps(random, middle_ns, 1'000'000, 1000.0));
    std::string text = std::string("time,header.gps_week,header.gps_week_") +
                       (unit == NamedMilliseconds ? "milliseconds" : "seconds") +
                       ",ins_status,latitude,longitude,altitude,undulation,roll,pitch,azimuth,latitude_std,"
                       "longitude_std,altitude_std,roll_std,pitch_std,azimuth_std\n";
    for (const InsLine& line : written) {
      const std::int64_t gps_ns = line.stamp_ns - kGpsEpoch_ns + kLeap_ns, in_week_ns = gps_ns % kWeek_ns;
      text += std::to_string(line.stamp_ns) + "," + std::to_string(gps_ns / kWeek_ns) + "," +
              (unit == Seconds ? seconds_text(in_week_ns, 3) : std::to_string(in_week_ns / 1'000'000)) + ",3," +
              fixed(line.at.latitude_deg, digits.place) + "," + fixed(line.at.longitude_deg, digits.place) + "," +
              fixed(line.height_m, digits.height) + "," + fixed(line.undulation_m, digits.height) + "," +
              fixed(line.roll_deg, digits.angle) + "," + fixed(line.pitch_deg, digits.angle) + "," +
              fixed(line.heading_deg, digits.angle) + ",0.01,0.01,0.01,0.1,0.1,0.1\n";
    }
    std::vector<drive::Finding> findings;
    const NovatelLog log = read_novatel(folder.write("log.csv", text), NovatelFormat::BagCsv, findings);
    compare(log.ins, written, digits, lost(digits.place), place, attitude, height);
  }
}

/// "4807.0380000,N": a multiple of 1e-n minutes, so that nothing is rounded to 60.
std::string minutes_text(double angle_deg, int width, int decimals, const char* sides) {
  const double units = std::pow(10.0, decimals);
  const auto whole = std::llround(std::abs(angle_deg) * 60.0 * units);
  const auto degree = static_cast<long long>(60.0 * units), minute = static_cast<long long>(units);
  char text[64];
  std::snprintf(text, sizeof text, "%0*lld%02lld.%0*lld,%c", width, whole / degree, whole % degree / minute, decimals,
                whole % minute, sides[angle_deg < 0.0 ? 1 : 0]);
  return text;
}

std::string clock_text(std::int64_t stamp_ns, int decimals) {
  const std::string date = format_date_ns(stamp_ns);
  return date.substr(11, 2) + date.substr(14, 2) + date.substr(17, 3 + static_cast<std::size_t>(decimals));
}

std::string date_sentence(RandomValues& random, std::int64_t stamp_ns, int decimals) {
  const std::string date = format_date_ns(stamp_ns), day = date.substr(8, 2), month = date.substr(5, 2);
  const std::string time = clock_text(stamp_ns, decimals);
  if (random.flip()) return nmea_line("GNZDA," + time + "," + day + "," + month + "," + date.substr(0, 4) + ",00,00");
  return nmea_line("GNRMC," + time + ",A,,,,,0.1,10.0," + day + month + date.substr(2, 2) + ",,,A");
}

/// The sentences of each sample in any order, now and then one behind those of the next, and the date somewhere.
std::string nmea_text(RandomValues& random, const std::vector<InsLine>& lines, const Digits& digits,
                      int time_decimals) {
  std::vector<std::vector<std::string>> epochs;
  const std::size_t dated = random.below(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const InsLine& line = lines[i];
    const std::string time = clock_text(line.stamp_ns, time_decimals);
    std::vector<std::string>& epoch = epochs.emplace_back();
    epoch.push_back(nmea_line("GNGGA," + time + "," + minutes_text(line.at.latitude_deg, 2, digits.place, "NS") + "," +
                              minutes_text(line.at.longitude_deg, 3, digits.place, "EW") + ",4,12,0.8," +
                              fixed(line.height_m, digits.height) + ",M," + fixed(line.undulation_m, digits.height) +
                              ",M,,"));
    epoch.push_back(nmea_line("GNGST," + time + ",0.1,,,,0.01,0.01,0.02"));
    epoch.push_back(nmea_line("PASHR," + time + "," + fixed(line.heading_deg, digits.angle) + ",T," +
                              fixed(line.roll_deg, digits.angle) + "," + fixed(line.pitch_deg, digits.angle) +
                              ",0.00,0.1,0.1,0.1,2"));
    if (i == dated) epoch.push_back(date_sentence(random, line.stamp_ns, time_decimals));
    for (std::size_t k = epoch.size() - 1; k > 0; --k) std::swap(epoch[k], epoch[random.below(k + 1)]);
  }
  std::string text, late;
  for (std::vector<std::string>& epoch : epochs) {
    const std::string before = std::move(late);
    late.clear();
    if (random.below(3) == 0 && !epoch.back().starts_with("$GNGGA")) late = epoch.back(), epoch.pop_back();
    for (std::size_t k = 0; k < epoch.size(); ++k) text += epoch[k] + (k == 0 ? before : "");
  }
  return text + late;
}

TEST(log_round_trip, nmea_logs_over_midnight_with_sentences_in_any_order) {
  RandomValues random(33);
  const TemporaryFolder folder;
  Worst place("place, deg"), attitude("attitude, deg"), height("height, m");
  const Eigen::Quaterniond rfu_from_flu(Eigen::AngleAxisd(kPi / 2.0, Eigen::Vector3d::UnitZ()));
  for (int draw = 0; draw < 200; ++draw) {
    SCOPED_TRACE("draw " + std::to_string(draw));
    const Digits digits{5 + static_cast<int>(random.below(6)), 2 + static_cast<int>(random.below(4)),
                        2 + static_cast<int>(random.below(6))};
    const int time_decimals = 2 + static_cast<int>(random.below(8));
    const auto unit_ns = static_cast<std::int64_t>(std::llround(std::pow(10.0, 9 - time_decimals)));
    const std::vector<InsLine> written = ins_lines(random, stamps(random, moment(random), unit_ns, 100.0));
    const std::string text = nmea_text(random, written, digits, time_decimals);
    std::vector<drive::Finding> findings;
    NmeaLog log = read_nmea(folder.write("log.nmea", text), findings);
    EXPECT_TRUE(findings.empty()) << english(findings.front().explanation) << "\n" << text;
    ASSERT_EQ(log.fixes.size(), written.size());
    for (std::size_t i = 0; i < written.size(); ++i) {
      ASSERT_EQ(log.fixes[i].stamp_ns, written[i].stamp_ns) << i << " of\n" << text;
      EXPECT_NEAR(log.fixes[i].covariance_enu_m2(2, 2), 4e-4, 1e-12) << "its own errors";
    }
    for (motion::InsSample& sample : log.ins) sample.enu_from_ins = sample.enu_from_ins * rfu_from_flu.conjugate();
    compare(log.ins, written, digits, lost(digits.place) / 60.0, place, attitude, height);
  }
}

TEST(log_round_trip, gpx_tracks) {
  RandomValues random(34);
  const TemporaryFolder folder;
  Worst worst_place("place, deg"), worst_height("height, m");
  for (int draw = 0; draw < 150; ++draw) {
    SCOPED_TRACE("draw " + std::to_string(draw));
    const int decimals = 6 + static_cast<int>(random.below(7)), time_decimals = static_cast<int>(random.below(10));
    const auto unit_ns = static_cast<std::int64_t>(std::llround(std::pow(10.0, 9 - time_decimals)));
    const std::vector<InsLine> written = ins_lines(random, stamps(random, moment(random), unit_ns, 50.0));
    const int ahead_h = static_cast<int>(random.below(27)) - 12;
    std::string text = "<?xml version='1.0'?>\n<gpx version=\"1.1\"><trk><trkseg>\n";
    for (const InsLine& line : written) {
      std::string time = format_date_ns(line.stamp_ns + ahead_h * 3600 * kSecond_ns);
      time[10] = 'T';
      time.resize(time_decimals > 0 ? 20 + static_cast<std::size_t>(time_decimals) : 19);
      char zone[16];
      std::snprintf(zone, sizeof zone, "%c%02d:00", ahead_h < 0 ? '-' : '+', std::abs(ahead_h));
      const std::string latitude = "lat=\"" + fixed(line.at.latitude_deg, decimals) + "\"",
                        longitude = "lon='" + fixed(line.at.longitude_deg, decimals) + "'";
      text += "<trkpt " + (random.flip() ? latitude + " " + longitude : longitude + "\n" + latitude) + "><ele>" +
              fixed(line.height_m, 3) + "</ele><time>" + time + (ahead_h == 0 && random.flip() ? "Z" : zone) +
              "</time></trkpt>" + (random.flip() ? "\n" : "");
    }
    std::vector<drive::Finding> findings;
    const std::vector<motion::GnssFix> read =
        read_gpx(folder.write("t.gpx", text + "</trkseg></trk></gpx>\n"), findings);
    ASSERT_EQ(read.size(), written.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
      ASSERT_EQ(read[i].stamp_ns, written[i].stamp_ns) << i;
      worst_place.add(apart_deg(read[i].latitude_rad, written[i].at.latitude_deg), lost(decimals) + 1e-13);
      worst_place.add(apart_deg(read[i].longitude_rad, written[i].at.longitude_deg), lost(decimals) + 1e-13);
      worst_height.add(std::abs(read[i].height_m - written[i].height_m), lost(3) + 1e-12);
    }
  }
}

}  // namespace
}  // namespace remount::formats
