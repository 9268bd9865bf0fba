#include "model/formats/ins/nmea_log.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "algorithms/messages/render.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/session_readers.h"
#include "model/formats/sessions/gnss_log_reader.h"
#include "tests/model/formats/ins/nmea_text.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/findings.h"

namespace remount::formats {
namespace {

std::string text_of(const char* pattern, auto... values) {
  char text[200];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

/// A turn to the right at 10 Hz that begins `seconds` after midnight, northern and western hemisphere.
std::string log_of(int samples, double seconds, bool attitude, bool heading, const std::string& quality = "4") {
  std::string log = nmea_line("GPRMC,235958.00,A,,,,,,,211126,,,A");
  for (int i = 0; i < samples; ++i) {
    const double now = std::fmod(seconds + 0.1 * i, 86400.0);
    const std::string time =
        text_of("%02d%02d%05.2f", static_cast<int>(now / 3600), static_cast<int>(now / 60) % 60, std::fmod(now, 60.0));
    log += nmea_line("GNGGA," + time + text_of(",4846.%05d,N,00911.50000,W,", 10000 + 10 * i) + quality +
                     ",12,0.8,250.0,M,48.0,M,,");
    log += nmea_line("GNGST," + time + ",,,,,0.011,0.012,0.023");
    if (attitude)
      log += nmea_line("PASHR," + time + text_of(",%06.2f,T,+02.00,-01.00,+0.00,0.10,0.11,0.20,2,1", 350.0 + 0.5 * i));
    if (heading) log += nmea_line("GNHDT," + text_of("%.2f", 350.0 + 0.5 * i) + ",T");
  }
  return log;
}

class nmea_log : public ::testing::Test {
 protected:
  NmeaLog read(const std::string& text) {
    findings_.clear();
    return read_nmea(folder_.write("log.nmea", text), findings_);
  }
  bool told(const std::string& code) const { return testing::has_code(findings_, code); }
  TemporaryFolder folder_;
  std::vector<drive::Finding> findings_;
};

TEST_F(nmea_log, positions_over_midnight_with_their_stated_errors) {
  const NmeaLog log = read(log_of(20, 86399.0, false, false));
  ASSERT_EQ(log.fixes.size(), 20U);
  EXPECT_EQ(log.fixes[0].stamp_ns, *parse_date_ns("2026-11-21 23:59:59.0"));
  EXPECT_EQ(log.fixes[10].stamp_ns, *parse_date_ns("2026-11-22 00:00:00.0"));
  EXPECT_NEAR(radians_to_degrees(log.fixes[0].latitude_rad), 48.0 + 46.1 / 60.0, 1e-9);
  EXPECT_NEAR(radians_to_degrees(log.fixes[0].longitude_rad), -(9.0 + 11.5 / 60.0), 1e-9);
  EXPECT_DOUBLE_EQ(log.fixes[0].height_m, 298.0) << "above the ellipsoid";
  EXPECT_NEAR(log.fixes[0].covariance_enu_m2(0, 0), 0.012 * 0.012, 1e-12) << "east";
  EXPECT_NEAR(log.fixes[0].covariance_enu_m2(1, 1), 0.011 * 0.011, 1e-12) << "north";
  EXPECT_TRUE(log.ins.empty());
  EXPECT_TRUE(findings_.empty()) << english(findings_[0].explanation);
}

TEST_F(nmea_log, pashr_gives_the_attitude_and_hdt_a_heading_with_a_warning) {
  const NmeaLog full = read(log_of(20, 100.0, true, true));
  ASSERT_EQ(full.ins.size(), 20U);
  const drive::AttitudeAngles angles = drive::angles_from(full.ins[4].enu_from_ins, drive::AttitudeConvention::Heading);
  EXPECT_NEAR(radians_to_degrees(angles.yaw_rad), 352.0, 1e-6);
  EXPECT_NEAR(radians_to_degrees(angles.pitch_rad), -1.0, 1e-6);
  EXPECT_NEAR(radians_to_degrees(angles.roll_rad), 2.0, 1e-6);
  EXPECT_NEAR(radians_to_degrees(full.ins[4].sigma.attitude_rad.z()), 0.2, 1e-9);
  EXPECT_EQ(full.ins[4].quality, motion::InsQuality::Good);
  EXPECT_FALSE(told("heading-alone"));
  const NmeaLog heading = read(log_of(20, 100.0, false, true));
  ASSERT_GE(heading.ins.size(), 19U);
  EXPECT_TRUE(told("heading-alone"));
  EXPECT_GT(heading.ins[3].sigma.attitude_rad.x(), degrees_to_radians(1.0)) << "roll is not known";
  EXPECT_EQ(read(log_of(20, 100.0, true, false, "5")).ins[0].quality, motion::InsQuality::Degraded);
}

/// A turn at 30 deg/s, positions at 10 Hz from 12:00:00 on, headings in every `headings_each`th epoch.
std::vector<std::vector<std::string>> turning_epochs(int samples, int headings_each, bool leads,
                                                     const std::vector<std::string>& more) {
  std::vector<std::vector<std::string>> epochs;
  for (int i = 0; i < samples; ++i) {
    const std::string time = text_of("1200%05.2f", 0.1 * i);
    const std::string heading = nmea_line("GNHDT," + text_of("%.2f", 10.0 + 3.0 * i) + ",T");
    const bool has_heading = i % headings_each == 0;
    std::vector<std::string> epoch;
    if (leads && has_heading) epoch.push_back(heading);
    epoch.push_back(nmea_line("GNGGA," + time + ",4846.10000,N,00911.50000,E,4,12,0.8,250.0,M,48.0,M,,"));
    for (const std::string& type : more)
      epoch.push_back(nmea_line(type == "GNGST" ? "GNGST," + time + ",,,,,0.011,0.012,0.023" : type + ",1,2,3"));
    if (!leads && has_heading) epoch.push_back(heading);
    epochs.push_back(epoch);
  }
  return epochs;
}

std::string joined(const std::vector<std::vector<std::string>>& epochs) {
  std::string text;
  for (const auto& epoch : epochs)
    for (const std::string& line : epoch) text += line;
  return text;
}

/// The largest error of a heading, deg.
double worst_heading_deg(const NmeaLog& log) {
  double worst_deg = 0.0;
  const std::int64_t start_ns = *parse_date_ns("2026-11-21 12:00:00");
  for (const motion::InsSample& sample : log.ins) {
    const double heading_deg =
        radians_to_degrees(drive::angles_from(sample.enu_from_ins, drive::AttitudeConvention::Heading).yaw_rad);
    const double true_deg = 10.0 + 30.0 * 1e-9 * static_cast<double>(sample.stamp_ns - start_ns);
    worst_deg = std::max(worst_deg, std::abs(std::remainder(heading_deg - true_deg, 360.0)));
  }
  return worst_deg;
}

TEST_F(nmea_log, headings_belong_to_the_epoch_that_they_are_written_with) {
  const std::string date = nmea_line("GPRMC,115959.90,A,,,,,,,211126,,,A");
  for (const bool leads : {false, true})
    for (const int each : {1, 2, 10})
      for (const std::vector<std::string>& more :
           {std::vector<std::string>{}, {"GNGST"}, {"GNVTG"}, {"GNGSA", "GNVTG", "GNGST"}, {"GNGST", "GNGSV"}}) {
        const NmeaLog log = read(date + joined(turning_epochs(101, each, leads, more)));
        const double worst_deg = worst_heading_deg(log);
        EXPECT_LT(worst_deg, 0.01) << (leads ? "before" : "behind") << ", " << more.size() << " more, each " << each;
        EXPECT_GE(log.ins.size(), each == 10 ? 10u : 99u);
        EXPECT_FALSE(told("heading-order"));
        EXPECT_EQ(told("attitude-sparse"), each == 10) << "0.2 s apart are interpolated, 1 s are not";
        std::printf("heading %s its position, 1 of %d, %zu sentences more: %zu samples, worst error %.4f deg\n",
                    leads ? "before" : "behind", each, more.size(), log.ins.size(), worst_deg);
      }
}

TEST_F(nmea_log, a_log_that_does_not_show_where_its_headings_belong_says_so) {
  const std::string date = nmea_line("GPRMC,115959.90,A,,,,,,,211126,,,A");
  std::vector<std::vector<std::string>> epochs = turning_epochs(50, 1, true, {"GNGST"});
  epochs.back().resize(1);  // cut behind a heading
  EXPECT_FALSE(read(date + joined(epochs)).ins.empty());
  EXPECT_TRUE(told("heading-order"));
}

TEST_F(nmea_log, attitudes_too_far_apart_say_why_no_ins_comes_out) {
  std::string text = nmea_line("GPRMC,115959.90,A,,,,,,,211126,,,A");
  for (int i = 0; i < 50; ++i) {
    text +=
        nmea_line("GNGGA," + text_of("1200%05.2f", 0.1 * i) + ",4846.10000,N,00911.50000,E,4,12,0.8,250.0,M,48.0,M,,");
    if (i % 10 == 0)  // between two positions
      text += nmea_line("PASHR," + text_of("1200%05.2f", 0.1 * i + 0.05) +
                        ",010.00,T,+02.00,-01.00,+0.00,0.10,0.11,0.20,2,1");
  }
  EXPECT_TRUE(read(text).ins.empty());
  ASSERT_TRUE(told("attitude-sparse"));
  for (const drive::Finding& finding : findings_)
    if (finding.code == "attitude-sparse") {
      EXPECT_TRUE(contains(english(finding.explanation), "50 of 50 positions have no attitude near them"))
          << english(finding.explanation);
      EXPECT_TRUE(contains(english(finding.explanation), "5 attitudes, up to 1.00 s apart"))
          << english(finding.explanation);
    }
}

TEST_F(nmea_log, damage_is_named_and_the_rest_is_read) {
  std::string text = log_of(20, 100.0, true, false);
  text[text.find("4846.1005") + 5] = '7';
  EXPECT_EQ(read(text).fixes.size(), 19U);
  ASSERT_TRUE(told("bad-nmea"));
  EXPECT_TRUE(contains(english(findings_[0].explanation), "log.nmea:")) << english(findings_[0].explanation);
  EXPECT_TRUE(contains(english(findings_[0].explanation), "the checksum is wrong"))
      << english(findings_[0].explanation);
  std::string undated = log_of(20, 100.0, true, false);
  undated.erase(0, undated.find('\n') + 1);
  EXPECT_ERROR(read(undated), "holds no date: GGA tells the time of day alone");
  EXPECT_ERROR(read(nmea_line("GPRMC,000000.00,A,,,,,,,221126,,,A")), "holds no GGA sentence with a fix");
  EXPECT_ERROR(read(nmea_line("GPGGA,000000.00,4860.0,N,00911.0,E,4,12,0.8,250.0,M,48.0,M,,")), "GGA without usable");
}

TEST_F(nmea_log, a_log_of_which_nothing_can_be_used_is_recognised_and_refused_with_the_reason) {
  std::string text = log_of(20, 100.0, true, false);
  for (std::size_t at = text.find('*'); at != std::string::npos; at = text.find('*', at + 1))
    text[at + 1] = text[at + 1] == '0' ? '1' : '0';
  const std::filesystem::path path = folder_.write("log.nmea", text);
  folder_.write("poses.txt", "100 0 0 0 0 0 0 1\n100.1 1 0 0 0 0 0 1\n");
  EXPECT_TRUE(recognise_nmea(path));
  Progress progress;
  EXPECT_ERROR(GnssLogReader().open(folder_.path(), progress), "holds no GGA sentence with a fix");
  EXPECT_ERROR(GnssLogReader().open(path, progress), "log.nmea:1: the checksum is wrong");
  const std::string unfixed = log_of(20, 100.0, true, false, "0");
  EXPECT_TRUE(recognise_nmea(folder_.write("log.nmea", unfixed)));
  EXPECT_ERROR(read(unfixed), "holds no GGA sentence with a fix");
}

// "250" of a height that lost its last digit is a height, too: a sentence without its end says nothing.
TEST_F(nmea_log, a_log_that_ends_within_a_sentence_says_so_and_takes_nothing_of_it) {
  const std::string whole = log_of(20, 100.0, false, true);
  ASSERT_EQ(read(whole).ins.size(), 20U);
  EXPECT_FALSE(told("log-cut"));
  EXPECT_FALSE(read(whole.substr(0, whole.size() - 2)).ins.empty());
  EXPECT_FALSE(told("log-cut")) << "all of it but the end of the last line";
  const std::size_t last = whole.rfind('$'), last_fix = whole.rfind("$GNGGA");
  for (const std::size_t length :
       {last + 1, last + 4, last + 9, whole.size() - 5, whole.size() - 4, whole.size() - 3}) {
    const NmeaLog log = read(whole.substr(0, length));
    EXPECT_TRUE(told("log-cut")) << whole.substr(last, length - last);
    EXPECT_FALSE(told("bad-nmea")) << whole.substr(last, length - last);
    EXPECT_EQ(log.fixes.size(), 20U);
    EXPECT_EQ(log.ins.size(), 19U) << "without the heading of the last position";
  }
  for (std::size_t length = last_fix + 1; length < whole.find('*', last_fix); ++length)
    EXPECT_EQ(read(whole.substr(0, length)).fixes.size(), 19U) << whole.substr(last_fix, length - last_fix);
}

std::string without_checksums(std::string log) {
  for (std::size_t star = log.find('*'); star != std::string::npos; star = log.find('*')) log.erase(star, 3);
  return log;
}

TEST_F(nmea_log, logs_without_checksums_are_read_to_their_end) {
  std::string bare = without_checksums(log_of(20, 100.0, false, true));
  EXPECT_EQ(read(bare).ins.size(), 20U);
  EXPECT_TRUE(findings_.size() == 1 && told("heading-alone"));
  bare.resize(bare.size() - 2);
  EXPECT_EQ(read(bare).ins.size(), 20U);
  EXPECT_FALSE(told("log-cut"));
  bare.resize(bare.size() - 3);
  read(bare);
  EXPECT_TRUE(told("log-cut")) << "a field is missing";
  const std::string other =
      without_checksums(log_of(20, 100.0, false, true)) + "$GPVTG,054.7,T,034.4,M,005.5,N,010.2,K";
  EXPECT_EQ(read(other).ins.size(), 20U);
  EXPECT_FALSE(told("log-cut")) << "a kind that is not read, and whole";
  read(log_of(20, 100.0, false, true) + "$GPVTG,054.7,T,034.4");
  EXPECT_TRUE(told("log-cut")) << "the others have a checksum";
  // Of a log that has them, a sentence without one was cut where the recorder lost bytes.
  std::string broken = log_of(20, 100.0, false, true);
  const std::size_t at = broken.find("*", broken.find("$GNGGA", broken.size() / 2));
  broken.erase(at - 12, 15);
  EXPECT_EQ(read(broken).fixes.size(), 19U);
  EXPECT_TRUE(told("bad-nmea"));
}

TEST_F(nmea_log, a_damaged_date_is_named) {
  std::string text = log_of(20, 100.0, true, false);
  text[text.find("211126")] = '1';
  EXPECT_ERROR(read(text), "the sentences that tell it (RMC, ZDA) are damaged");
  EXPECT_ERROR(read(text), "log.nmea:1: the checksum is wrong");
  EXPECT_EQ(read(text + nmea_line("GPZDA,000200.00,21,11,2026,00,00")).fixes.size(), 20U) << "another one is there";
}

// The same day is the 22nd of November. Broken times: a later one, an earlier one, and one that looks like the next
// day.
TEST_F(nmea_log, one_broken_time_takes_no_sentence_to_another_day) {
  const auto fix_at = [](const std::string& time) {
    return nmea_line("GNGGA," + time + ",4846.10000,N,00911.50000,W,4,12,0.8,250.0,M,48.0,M,,");
  };
  const std::pair<double, std::string> cases[] = {
      {1000.0, "235000.00"}, {80000.0, "050000.00"}, {80000.0, "000100.00"}, {86395.0, "000100.00"}};
  for (const auto& [first_s, broken] : cases) {
    const double begin_s = first_s;
    const auto time_of = [&](int i) {
      const double now = begin_s + 0.1 * i;
      return text_of("%02d%02d%05.2f", static_cast<int>(now / 3600), static_cast<int>(now / 60) % 60,
                     std::fmod(now, 60.0));
    };
    std::string text = nmea_line("GPRMC," + time_of(0) + ",A,,,,,,,221126,,,A");
    for (int i = 0; i < 20; ++i) text += fix_at(time_of(i)) + (i == 9 ? fix_at(broken) : "");
    const NmeaLog log = read(text);
    std::printf("%s among times from %.0f s: %zu fixes\n", broken.c_str(), begin_s, log.fixes.size());
    ASSERT_EQ(log.fixes.size(), 20U) << broken;
    if (broken != "000100.00")
      testing::expect_told(findings_, "bad-nmea", "GGA at a time that is most of a day away from the one before");
    const std::int64_t first_ns = *parse_date_ns("2026-11-22 00:00:00") + std::llround(begin_s * 1e9);
    EXPECT_EQ(log.fixes.front().stamp_ns, first_ns) << broken;
    EXPECT_EQ(log.fixes.back().stamp_ns, first_ns + 1'900'000'000) << broken;
  }
}

TEST_F(nmea_log, a_log_that_pauses_over_midnight_goes_on_with_the_next_day) {
  std::string text = nmea_line("GPRMC,235958.00,A,,,,,,,211126,,,A");
  for (const char* time : {"235959.00", "050000.00", "050001.00", "050002.00"})
    text += nmea_line("GNGGA," + std::string(time) + ",4846.10000,N,00911.50000,W,4,12,0.8,250.0,M,48.0,M,,") +
            nmea_line("GNGST," + std::string(time) + ",,,,,0.011,0.012,0.023");
  const NmeaLog log = read(text);
  ASSERT_EQ(log.fixes.size(), 3U) << "of the first behind the pause nobody knows that its time is right";
  EXPECT_EQ(log.fixes[1].stamp_ns, *parse_date_ns("2026-11-22 05:00:01.0"));
  testing::expect_told(findings_, "bad-nmea", "GGA at a time that is most of a day away from the one before");
}

TEST_F(nmea_log, opens_as_a_session_alone_with_poses_and_from_a_manifest) {
  Progress progress;
  std::string poses;
  const double start_s = 1e-9 * static_cast<double>(*parse_date_ns("2026-11-22 00:01:40"));
  for (int i = 0; i < 40; ++i) poses += text_of("%.3f %d 0 0 0 0 0 1\n", start_s + 0.05 * i, i);
  folder_.write("drive/odometry.txt", poses);
  std::string text = log_of(40, 100.0, true, false);
  text.replace(0, text.find('\n') + 1, nmea_line("GPRMC,000100.00,A,,,,,,,221126,,,A"));
  const auto log = folder_.write("drive/gnss.log", text);
  const drive::Session alone = open_session(log, progress);
  EXPECT_EQ(alone.format, "gnss-log");
  EXPECT_EQ(alone.gnss.size(), 40U);
  const drive::Session both = open_session(folder_.path() / "drive", progress);
  EXPECT_EQ(both.format, "gnss-log");
  EXPECT_EQ(both.ins.size(), 40U);
  EXPECT_EQ(both.odometry_from_lidar.size(), 40U);
  EXPECT_EQ(both.files.size(), 2U);
  const std::string manifest = "format: remount-session/1\nname: d\nlidar_poses: {file: odometry.txt, format: tum}\n";
  folder_.write("drive/session.yaml", manifest + "ins: {file: gnss.log}\ngnss: {file: gnss.log}\n");
  const drive::Session declared = open_session(folder_.path() / "drive", progress);
  EXPECT_EQ(declared.format, "native");
  EXPECT_EQ(declared.ins.size(), 40U);
  EXPECT_EQ(declared.gnss.size(), 40U);
  std::string damaged = text;
  damaged[damaged.find("4846.1005") + 5] = '7';
  folder_.write("drive/gnss.log", damaged);
  const drive::Session told_once = open_session(folder_.path() / "drive", progress);
  EXPECT_EQ(told_once.gnss.size(), 39U);
  EXPECT_EQ(std::count_if(told_once.findings.begin(), told_once.findings.end(),
                          [](const drive::Finding& finding) { return finding.code == "bad-nmea"; }),
            1)
      << "one log that is two streams";
  EXPECT_EQ(std::count(told_once.files.begin(), told_once.files.end(), log), 1);
  folder_.write("drive/plain.log", log_of(40, 100.0, false, false));
  folder_.write("drive/session.yaml", manifest + "ins: {file: plain.log}\n");
  EXPECT_ERROR(open_session(folder_.path() / "drive", progress), "has no attitude (PASHR or HDT;");
}

}  // namespace
}  // namespace remount::formats
