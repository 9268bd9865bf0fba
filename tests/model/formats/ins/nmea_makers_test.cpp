// NMEA logs with the sentences of makers, and with several receivers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/conventions/assumed_tilt.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/ins/nmea_log.h"
#include "model/formats/sessions/gnss_log_reader.h"
#include "tests/model/formats/ins/nmea_text.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {

using motion::InsQuality;

namespace {

std::string formatted(const char* pattern, auto... values) {
  char text[300];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

constexpr double kHeading_deg = 350.0, kStep_deg = 0.5, kPitch_deg = -1.5, kRoll_deg = 2.25;

std::string time_of(int i) { return formatted("1200%05.2f", 0.1 * i); }
double heading_of(int i) { return std::fmod(kHeading_deg + kStep_deg * i, 360.0); }

/// A fix at a tenth of a second; `off` moves it north by as many ten-thousandths of a minute.
std::string gga(const std::string& talker, int i, int quality, int off = 0) {
  return nmea_line(talker + "GGA," + time_of(i) +
                   formatted(",4846.%05d,N,00911.50000,E,%d,12,0.8,250.0,M,48.0,M,,", 10000 + 10 * i + off, quality));
}

class nmea_makers : public ::testing::Test {
 protected:
  NmeaLog read(const std::string& text) {
    findings_.clear();
    const auto path = folder_.write("log.nmea", kDate + text);
    EXPECT_TRUE(recognise_nmea(path));
    return read_nmea(path, findings_);
  }
  bool told(const std::string& code) const {
    return std::any_of(findings_.begin(), findings_.end(), [&](const drive::Finding& f) { return f.code == code; });
  }
  /// The attitude of 20 epochs is the one that was written.
  static void expect_attitudes(const NmeaLog& log, double pitch_deg, double roll_deg) {
    ASSERT_EQ(log.ins.size(), 20U);
    for (int i = 0; i < 20; ++i) {
      const drive::AttitudeAngles angles =
          drive::angles_from(log.ins[static_cast<std::size_t>(i)].enu_from_ins, drive::AttitudeConvention::Heading);
      EXPECT_NEAR(std::remainder(radians_to_degrees(angles.yaw_rad) - heading_of(i), 360.0), 0.0, 0.01) << i;
      EXPECT_NEAR(radians_to_degrees(angles.pitch_rad), pitch_deg, 0.01) << i;
      EXPECT_NEAR(radians_to_degrees(angles.roll_rad), roll_deg, 0.01) << i;
    }
  }
  static const std::string kDate;
  TemporaryFolder folder_;
  std::vector<drive::Finding> findings_;
};
const std::string nmea_makers::kDate = nmea_line("GNRMC,115959.90,A,,,,,,,211126,,,A");

TEST_F(nmea_makers, of_two_receivers_the_better_fix_of_a_time_counts_in_any_order) {
  for (const char* order : {"worse first", "better first", "in turns", "one epoch late"}) {
    SCOPED_TRACE(order);
    std::string text;
    for (int i = 0; i < 40; ++i) {
      const std::string worse = gga("GP", i, 1, 500), better = gga("GN", i, i % 10 == 9 ? 5 : 4);
      const std::string attitude =
          nmea_line("PASHR," + time_of(i) + formatted(",%07.3f,T,+0.00,+0.00,+0.00,0.1,0.1,0.1,2,1", heading_of(i)));
      const std::string late = i > 0 ? gga("GP", i - 1, 1, 500) : "";
      if (std::string(order) == "worse first" || (std::string(order) == "in turns" && i % 2 == 0))
        text += worse + better + attitude;
      else if (std::string(order) == "one epoch late")
        text += better + attitude + late;
      else
        text += better + worse + attitude;
    }
    const NmeaLog log = read(text);
    ASSERT_EQ(log.fixes.size(), 40U);
    ASSERT_EQ(log.ins.size(), 40U);
    for (std::size_t i = 0; i < 40; ++i) {
      const double minutes = (radians_to_degrees(log.fixes[i].latitude_rad) - 48.0) * 60.0;
      EXPECT_NEAR(minutes, 46.1 + 1e-4 * static_cast<double>(i), 2e-6) << i;
      EXPECT_EQ(log.fixes[i].latitude_rad, log.ins[i].latitude_rad);
      EXPECT_EQ(log.ins[i].quality, i % 10 == 9 ? InsQuality::Degraded : InsQuality::Good);
    }
    EXPECT_TRUE(told("gnss-duplicate-stamps"));
    EXPECT_FALSE(told("gnss-reversed-stamps"));
  }
}

TEST_F(nmea_makers, two_receivers_that_are_as_good_are_not_mixed) {
  std::string text;
  for (int i = 0; i < 40; ++i) {
    const std::string one = gga("GP", i, 4, 500), other = i == 3 ? gga("GN", i, 5) : gga("GN", i, 4);
    text += i % 2 == 0 ? one + other : other + one;
  }
  const NmeaLog log = read(text);
  ASSERT_EQ(log.fixes.size(), 40U);
  for (std::size_t i = 0; i < 40; ++i)
    EXPECT_NEAR((radians_to_degrees(log.fixes[i].latitude_rad) - 48.0) * 60.0,
                46.1 + 1e-4 * static_cast<double>(i) + 0.005, 2e-6)
        << i;
}

TEST_F(nmea_makers, errors_are_those_of_the_receiver_whose_fix_counts) {
  std::string text;
  for (int i = 0; i < 20; ++i)
    text += gga("GP", i, 1, 500) + nmea_line("GPGST," + time_of(i) + ",,,,,2.0,2.0,4.0") + gga("GN", i, 4) +
            nmea_line("GNGST," + time_of(i) + ",,,,,0.011,0.012,0.023") +
            nmea_line("GPGST," + time_of(i) + ",,,,,2.0,2.0,4.0");
  for (const motion::GnssFix& fix : read(text).fixes) EXPECT_NEAR(fix.covariance_enu_m2(1, 1), 0.011 * 0.011, 1e-12);
}

TEST_F(nmea_makers, sentences_that_are_not_read_do_not_make_a_log_unknown) {
  std::string text;
  for (int i = 0; i < 20; ++i) {
    for (int k = 0; k < 5; ++k)
      text += nmea_line("PGRME,15.0,M,45.0,M,25.0,M") + nmea_line("PUBX,00," + time_of(i) + ",4717.11,N,00833.91,E") +
              nmea_line("PTNL,GGK," + time_of(i) + ",102604,3723.4,N,12200.3,W,3,06,1.7,EHT-6.777,M") +
              nmea_line("PSTI,030,1,2") + nmea_line("PQTMVER,MODULE") + nmea_line("PGRMZ,93,f,3");
    text += gga("GN", i, 4);
  }
  const NmeaLog log = read(text);
  EXPECT_EQ(log.fixes.size(), 20U);
  EXPECT_FALSE(told("bad-nmea"));
  EXPECT_FALSE(recognise_nmea(folder_.write("none.txt", nmea_line("PGRME,15.0,M,45.0,M,25.0,M"))));
  EXPECT_FALSE(recognise_nmea(folder_.write("prose.txt", "A log begins with $GPGGA,\nand so on.\nIt is read.\n")));
}

TEST_F(nmea_makers, hpr_hrp_and_avr_give_attitudes_at_their_times) {
  for (const char* maker : {"PSAT", "PSSN", "PTNL"}) {
    SCOPED_TRACE(maker);
    std::string text;
    for (int i = 0; i < 20; ++i) {
      text += gga("GN", i, 4);
      if (std::string(maker) == "PSAT")
        text +=
            nmea_line("PSAT,HPR," + time_of(i) + formatted(",%.3f,%.3f,%.3f,N", heading_of(i), kPitch_deg, kRoll_deg));
      else if (std::string(maker) == "PSSN")
        text += nmea_line("PSSN,HRP," + time_of(i) +
                          formatted(",211126,%.3f,%.3f,%.3f,0.2,0.2,0.2,12,2", heading_of(i), kRoll_deg, kPitch_deg));
      else
        text += nmea_line(
            "PTNL,AVR," + time_of(i) +
            formatted(",%+.4f,Yaw,%+.4f,Tilt,%+.4f,Roll,1.19,3,2.5,12", heading_of(i), kPitch_deg, kRoll_deg));
    }
    const NmeaLog log = read(text);
    expect_attitudes(log, kPitch_deg, kRoll_deg);
    EXPECT_FALSE(told("roll-assumed"));
    EXPECT_EQ(conventions::assumed_tilt_sigma_rad(log.ins), 0.0);
  }
}

TEST_F(nmea_makers, two_antennas_leave_roll_open_and_that_is_said) {
  std::string text;
  for (int i = 0; i < 20; ++i)
    text += gga("GN", i, 4) + nmea_line("PTNL,AVR," + time_of(i) +
                                        formatted(",%+.4f,Yaw,%+.4f,Tilt,,,60.191,3,2.5,6", heading_of(i), kPitch_deg));
  const NmeaLog log = read(text);
  expect_attitudes(log, kPitch_deg, 0.0);
  EXPECT_TRUE(told("roll-assumed"));
  EXPECT_NEAR(log.ins[0].sigma.attitude_rad.x(), conventions::kAssumedTilt_rad, 1e-12);
  EXPECT_LT(log.ins[0].sigma.attitude_rad.z(), conventions::kAssumedTilt_rad / 2.0);
  EXPECT_GT(conventions::assumed_tilt_sigma_rad(log.ins), 0.0) << "it lasts over the drive";
  // Headings that come ten times as often are better than that.
  std::string rare;
  for (int i = 0; i < 20; ++i) {
    rare += gga("GN", i, 4);
    if (i % 10 == 0) rare += nmea_line("PTNL,AVR," + time_of(i) + ",+1.0,Yaw,+1.0,Tilt,,,60.191,3,2.5,6");
    rare += nmea_line(formatted("GNTHS,%.2f,A", heading_of(i)));
  }
  EXPECT_EQ(read(rare).ins.size(), 20U);
  EXPECT_TRUE(told("heading-alone"));
}

TEST_F(nmea_makers, antennas_without_a_solution_give_nothing) {
  std::string text;
  for (int i = 0; i < 20; ++i)
    text += gga("GN", i, 4) + nmea_line("PTNL,AVR," + time_of(i) + ",+0.0000,Yaw,+0.0000,Tilt,,,0.000,0,0.0,0") +
            nmea_line("PSAT,HPR," + time_of(i) + ",,,,N") + nmea_line("PSSN,HRP," + time_of(i) + ",211126,,,,,,,0,0");
  EXPECT_TRUE(read(text).ins.empty());
  EXPECT_FALSE(told("bad-nmea"));
}

TEST_F(nmea_makers, ksxt_is_a_log_of_its_own) {
  std::string text;
  for (int i = 0; i < 20; ++i)
    text += nmea_line("KSXT,20261121" + time_of(i) +
                      formatted(",9.19166667,%.8f,298.0,%.2f,%.2f,350.0,36.0,%.2f,3,3,20,18,,,,0,0,0",
                                48.0 + (46.1 + 1e-4 * i) / 60.0, heading_of(i), kPitch_deg, kRoll_deg));
  const auto path = folder_.write("a.nmea", text);
  EXPECT_TRUE(recognise_nmea(path));
  const NmeaLog log = read_nmea(path, findings_);
  expect_attitudes(log, kPitch_deg, kRoll_deg);
  EXPECT_EQ(log.fixes.size(), 20U);
  EXPECT_EQ(log.ins[0].stamp_ns, *parse_date_ns("2026-11-21 12:00:00"));
  EXPECT_EQ(log.ins[0].quality, InsQuality::Good);
  EXPECT_DOUBLE_EQ(log.ins[0].height_m, 298.0);
}

/// GPCHC of 20 epochs that all have one status.
std::string chc_of_status(const std::string& status) {
  std::string text;
  for (int i = 0; i < 20; ++i)
    text += nmea_line(formatted(
        "GPCHC,2445,%.2f,%.3f,%.3f,%.3f,0,0,0,0,0,1,%.8f,9.19166667,298.0,1,2,0,2.2,20,18,%s,1.0,0", 561618.0 + 0.1 * i,
        heading_of(i), kPitch_deg, kRoll_deg, 48.0 + (46.1 + 1e-4 * i) / 60.0, status.c_str()));
  return text;
}

TEST_F(nmea_makers, status_of_chc_is_that_of_its_ins_and_of_its_satellites) {
  struct Meaning {
    const char* status;
    InsQuality quality;
    double sigma_m;
  };
  for (const auto& [status, quality, sigma_m] :
       {Meaning{"42", InsQuality::Good, 0.02}, Meaning{"82", InsQuality::Good, 0.02},
        Meaning{"52", InsQuality::Degraded, 0.3}, Meaning{"92", InsQuality::Degraded, 0.3},
        Meaning{"22", InsQuality::Degraded, 0.8}, Meaning{"72", InsQuality::Degraded, 0.8},
        Meaning{"12", InsQuality::Degraded, 2.0}, Meaning{"62", InsQuality::Degraded, 2.0},
        Meaning{"02", InsQuality::Degraded, 2.0}, Meaning{"32", InsQuality::Degraded, 2.0},
        Meaning{"43", InsQuality::Degraded, 2.0}, Meaning{"03", InsQuality::Degraded, 2.0},
        Meaning{"41", InsQuality::Degraded, 0.3}, Meaning{"11", InsQuality::Degraded, 2.0}}) {
    SCOPED_TRACE(status);
    const NmeaLog log = read(chc_of_status(status));
    expect_attitudes(log, kPitch_deg, kRoll_deg);
    for (const motion::InsSample& sample : log.ins) {
      EXPECT_EQ(sample.quality, quality);
      EXPECT_DOUBLE_EQ(sample.sigma.position_enu_m.x(), sigma_m);
      EXPECT_DOUBLE_EQ(sample.sigma.position_enu_m.z(), 1.5 * sigma_m);
    }
  }
  for (const char* status : {"", "4F", "A2"}) {
    SCOPED_TRACE(status);
    const NmeaLog log = read(chc_of_status(status));
    ASSERT_EQ(log.ins.size(), 20U);
    EXPECT_EQ(log.ins[7].quality, InsQuality::Unknown);
    EXPECT_TRUE(std::isnan(log.ins[7].sigma.position_enu_m.x()));
  }
  for (const char* status : {"00", "40", "01", "0"})
    EXPECT_TRUE(read(chc_of_status(status) + gga("GN", 3, 4)).ins.empty()) << status;
  // What the INS has while it begins is left out alone.
  const NmeaLog begun = read(chc_of_status("00").substr(0, 5 * chc_of_status("00").size() / 20) + chc_of_status("42"));
  EXPECT_EQ(begun.ins.size(), 20U);
  EXPECT_EQ(begun.ins.front().quality, InsQuality::Good);
}

TEST_F(nmea_makers, fpd_and_chc_are_the_ins_with_their_own_position) {
  // 21 November 2026, 12:00:00 UTC, is 561618 s of GPS week 2445.
  const std::int64_t noon_ns = *parse_date_ns("2026-11-21 12:00:00");
  for (const bool fpd : {true, false}) {
    SCOPED_TRACE(fpd ? "FPD" : "CHC");
    std::string text;
    for (int i = 0; i < 20; ++i) {
      const std::string attitude = formatted("2445,%.2f,%.3f,%.3f,%.3f", 561618.0 + 0.1 * i, heading_of(i), kPitch_deg,
                                             kRoll_deg),
                        place = formatted("%.8f,9.19166667,298.0", 48.0 + (46.1 + 1e-4 * i) / 60.0);
      if (fpd)
        text += nmea_line("GPFPD," + attitude + "," + place + ",1,2,0,1.2,20,18,4B");
      else
        text += nmea_line("GPCHC," + attitude + ",0,0,0,0,0,1," + place + ",1,2,0,2.2,20,18,42,1.0,0");
      // The antenna's, which is another place, and better by what it says.
      text += gga("GN", i, 4, 500);
    }
    const NmeaLog log = read(text);
    expect_attitudes(log, kPitch_deg, kRoll_deg);
    for (std::size_t i = 0; i < 20; ++i) {
      EXPECT_EQ(log.ins[i].quality, fpd ? InsQuality::Unknown : InsQuality::Good);
      EXPECT_EQ(log.ins[i].stamp_ns, noon_ns + static_cast<std::int64_t>(i) * 100'000'000);
      EXPECT_NEAR((radians_to_degrees(log.ins[i].latitude_rad) - 48.0) * 60.0, 46.1 + 1e-4 * static_cast<double>(i),
                  2e-6);
    }
    EXPECT_TRUE(told("attitude-chosen"));
    std::string aligning = text;
    for (std::size_t at = 0; (at = aligning.find(fpd ? "4B*" : ",42,", at)) != std::string::npos; ++at)
      aligning[at + (fpd ? 1 : 2)] = '0';
    for (std::size_t at = 0; (at = aligning.find('*', at)) != std::string::npos;) aligning.erase(at, 3);
    EXPECT_TRUE(read(aligning).ins.empty()) << "the INS has not begun to align";
  }
}

}  // namespace
}  // namespace remount::formats
