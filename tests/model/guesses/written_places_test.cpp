// Latitudes and longitudes as receivers write them: degrees and minutes side by side, small parts of a degree, letters
// for north and south.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <iostream>

#include "model/guesses/table_import.h"
#include "tests/model/guesses/described_rows.h"

namespace remount::guesses {
namespace {

/// 4807.0380000 of 48.1173 degrees, with eight digits of the minutes.
std::string minutes_text(double angle_rad) {
  const double degrees = std::abs(radians_to_degrees(angle_rad)), whole = std::floor(degrees);
  char text[40];
  std::snprintf(text, sizeof text, "%.8f", 100.0 * whole + 60.0 * (degrees - whole));
  return text;
}
std::string small_text(double angle_rad) { return std::to_string(std::llround(1e7 * radians_to_degrees(angle_rad))); }

class written_places : public DescribedRows {
 protected:
  void SetUp() override { write_scans(native_drive(), folder_.path(), ScanNames::Nanoseconds); }

  using Place = std::function<Fields(const WrittenSample&)>;

  Description described_as(const std::string& head, const Place& place, const std::vector<WrittenSample>& samples) {
    write_rows(
        folder_.path() / "motion.csv", "time_ns," + head + ",h,roll,pitch,heading\n",
        [&](std::size_t, const WrittenSample& sample) {
          Fields row = joined({std::to_string(sample.ins.stamp_ns)}, place(sample));
          row.push_back(number(sample.ins.height_m));
          return joined(row, angles(heading_angles(sample)));
        },
        samples);
    return described({folder_.path()});
  }

  /// The drive somewhere else on the earth: its metres stay nearly the same.
  static std::vector<WrittenSample> moved(double latitude_rad, double longitude_rad) {
    std::vector<WrittenSample> samples = *samples_;
    const motion::InsSample first = samples.front().ins;
    const double narrower = std::cos(first.latitude_rad) / std::cos(latitude_rad);
    for (WrittenSample& sample : samples) {
      sample.ins.latitude_rad += latitude_rad - first.latitude_rad;
      sample.ins.longitude_rad = longitude_rad + narrower * (sample.ins.longitude_rad - first.longitude_rad);
    }
    return samples;
  }

  /// Where samples are, at most, from where they were written, m.
  static double farthest_m(const drive::Session& session, const std::vector<WrittenSample>& samples) {
    EXPECT_EQ(session.ins.size(), samples.size());
    constexpr double kEarth_m = 6'371'000.0;
    double worst_m = 0.0;
    for (std::size_t i = 0; i < std::min(session.ins.size(), samples.size()); ++i)
      worst_m = std::max({worst_m, kEarth_m * std::abs(session.ins[i].latitude_rad - samples[i].ins.latitude_rad),
                          kEarth_m * std::abs(session.ins[i].longitude_rad - samples[i].ins.longitude_rad)});
    return worst_m;
  }

  formats::TemporaryFolder folder_;
};

TEST_F(written_places, in_degrees_and_minutes_are_told_by_their_size) {
  const Description found = described_as(
      "lat,lon",
      [](const auto& s) {
        return Fields{minutes_text(s.ins.latitude_rad), minutes_text(s.ins.longitude_rad)};
      },
      *samples_);
  ASSERT_TRUE(found.complete());
  const Guess* position = guess_of(found, GuessKind::Position);
  EXPECT_EQ(position->sureness, Sureness::Likely);
  EXPECT_TRUE(says(position->evidence, "guess-unit-is-minutes"));
  EXPECT_EQ(guess_of(found, GuessKind::Attitude)->sureness, Sureness::Checked);
  const drive::Session session = opened(found, folder_.path());
  const double off_m = farthest_m(session, *samples_);
  std::cout << "off by " << off_m << " m, motions by " << motions_apart(session, *session_) << "\n";
  EXPECT_LT(off_m, 1e-4);
  EXPECT_LT(motions_apart(session, *session_), 1e-4);
}

/// As a sentence of NMEA has them, south-west of zero.
TEST_F(written_places, with_letters_for_their_sides_lie_on_these) {
  const std::vector<WrittenSample> samples = moved(-0.41, -0.81);
  const Description found = described_as(
      "lat (ddmm.mmmm),N/S,lon (dddmm.mmmm),E/W",
      [](const auto& s) {
        return Fields{minutes_text(s.ins.latitude_rad), "S", minutes_text(s.ins.longitude_rad), "W"};
      },
      samples);
  ASSERT_TRUE(found.complete());
  EXPECT_EQ(guess_of(found, GuessKind::Position)->sureness, Sureness::Named);
  EXPECT_EQ(guess_of(found, GuessKind::Position)->columns.size(), 5U);
  EXPECT_EQ(guess_of(found, GuessKind::Attitude)->sureness, Sureness::Checked);
  // The import page keeps them.
  Progress progress;
  const ImportData data = look_for_import({folder_.path()}, progress);
  ASSERT_TRUE(data.table);
  std::vector<Message> lacks;
  const auto layout = layout_of(data.table->table, data.table->preset, lacks);
  ASSERT_TRUE(layout && layout->latitude_side && layout->longitude_side);
  EXPECT_EQ(layout->latitude_side->name, "N/S");
  EXPECT_EQ(layout->longitude_side->name, "E/W");
  EXPECT_EQ(layout->position_unit, formats::PlaceUnit::DegreesMinutes);
  const double off_m = farthest_m(opened(found, folder_.path()), samples);
  std::cout << "off by " << off_m << " m\n";
  EXPECT_LT(off_m, 1e-4);
}

/// South-west of zero, with the sides behind the numbers.
TEST_F(written_places, with_letters_and_degree_signs_behind_the_numbers_are_read) {
  const std::vector<WrittenSample> samples = moved(-0.41, -0.81);
  const auto written = [](double angle_rad, const char* label) {
    char text[60];
    std::snprintf(text, sizeof text, "%.9f%s", std::abs(radians_to_degrees(angle_rad)), label);
    return std::string(text);
  };
  const Description found = described_as(
      "lat,lon",
      [&](const auto& s) {
        return Fields{written(s.ins.latitude_rad, "S"), written(s.ins.longitude_rad, "\xc2\xb0 W")};
      },
      samples);
  ASSERT_TRUE(found.complete()) << (found.not_used.empty() ? "" : english(found.not_used.front().why));
  const double off_m = farthest_m(opened(found, folder_.path()), samples);
  std::cout << "off by " << off_m << " m\n";
  EXPECT_LT(off_m, 1e-3);
}

/// What stands behind the numbers is their unit, as what stands in a title is: angles as small are radians elsewhere.
TEST_F(written_places, a_unit_behind_the_numbers_is_that_of_the_column) {
  std::vector<WrittenSample> samples = *samples_;
  const auto write = [&](const std::string& label) {
    write_rows(
        folder_.path() / "motion.csv", "time_ns,lat,lon,h,roll,pitch,heading\n",
        [&](std::size_t, const WrittenSample& sample) {
          Fields row = joined({std::to_string(sample.ins.stamp_ns)}, place_deg(sample));
          row[3] += " m";
          for (std::string angle : angles(heading_angles(sample))) row.push_back(angle + label);
          return row;
        },
        samples);
  };
  write(" deg");
  const Description found = described({folder_.path()});
  ASSERT_TRUE(found.complete()) << (found.missing.empty() ? "" : english(found.missing.front()));
  const drive::Session session = opened(found, folder_.path());
  EXPECT_LT(farthest_m(session, samples), 1e-3);
  EXPECT_LT(motions_apart(session, *session_), 1e-4);
  // A manifest that says otherwise than the rows: nothing is read as what it is not.
  std::string manifest = formats::bytes_of(folder_.path() / "session.yaml");
  const std::size_t at = manifest.find("unit: deg", manifest.find("attitude"));
  ASSERT_NE(at, std::string::npos) << manifest;
  folder_.write("session.yaml", manifest.replace(at, 9, "unit: rad"));
  Progress progress;
  try {
    formats::open_session(folder_.path() / "session.yaml", progress);
    FAIL() << "degrees were read as radians";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("has another unit"), std::string::npos) << error.what();
  }
}

TEST_F(written_places, in_small_parts_of_a_degree_are_told_where_nothing_else_fits) {
  const auto place = [](const WrittenSample& s) {
    return Fields{small_text(s.ins.latitude_rad), small_text(s.ins.longitude_rad)};
  };
  const Description found = described_as("latitude,longitude", place, *samples_);
  ASSERT_TRUE(found.complete()) << (found.not_used.empty() ? "" : english(found.not_used.front().why));
  EXPECT_EQ(guess_of(found, GuessKind::Position)->sureness, Sureness::Likely);
  EXPECT_TRUE(says(guess_of(found, GuessKind::Position)->evidence, "guess-unit-is-small"));
  const double off_m = farthest_m(opened(found, folder_.path()), *samples_);
  std::cout << "off by " << off_m << " m\n";
  EXPECT_LT(off_m, 0.006) << "half of the last digit";
  std::filesystem::remove(folder_.path() / "session.yaml");
  // Millionths of a degree would be as large elsewhere.
  const Description near_zero = described_as("latitude,longitude", place, moved(0.09, 0.02));
  EXPECT_EQ(guess_of(near_zero, GuessKind::Position)->sureness, Sureness::Open);
  EXPECT_TRUE(near_zero.open());
  // A title says which it is.
  const Description named = described_as("latitude (1e-7 deg),longitude (1e-7 deg)", place, moved(0.09, 0.02));
  EXPECT_EQ(guess_of(named, GuessKind::Position)->sureness, Sureness::Named);
}

/// The way is mirrored then, and the heading would have to count against its name.
TEST_F(written_places, without_the_sign_of_west_or_south_are_open_and_read_with_it) {
  const std::vector<WrittenSample> south_west = moved(-0.58, -1.23);
  for (const std::size_t lost : {0U, 1U}) {
    const auto place = [&](const WrittenSample& s) {
      const double latitude_rad = s.ins.latitude_rad, longitude_rad = s.ins.longitude_rad;
      return Fields{degrees_text(lost == 0 ? std::abs(latitude_rad) : latitude_rad),
                    degrees_text(lost == 1 ? std::abs(longitude_rad) : longitude_rad)};
    };
    const Description found = described_as("lat,lon", place, south_west);
    ASSERT_TRUE(found.complete()) << lost;
    const Guess* position = guess_of(found, GuessKind::Position);
    EXPECT_EQ(position->sureness, Sureness::Open) << lost;
    EXPECT_TRUE(says(position->evidence, "guess-sign-lost")) << lost;
    ASSERT_EQ(position->other_layouts.size(), 1U) << lost;
    EXPECT_EQ(position->other_layouts[0].place_signs, (std::array{1.0, 1.0}));
    EXPECT_EQ(found.ins->layout.yaw_pitch_roll_signs[0], 1.0);
    // The import page keeps it.
    Progress progress;
    const ImportData data = look_for_import({folder_.path()}, progress);
    ASSERT_TRUE(data.table);
    EXPECT_TRUE(data.table->preset.place_negated[lost]);
    const drive::Session session = opened(found, folder_.path());
    const double off_m = farthest_m(session, south_west);
    std::cout << (lost == 0 ? "south" : "west") << " lost: off by " << off_m << " m\n";
    EXPECT_LT(off_m, 1e-4) << lost;
    std::filesystem::remove(folder_.path() / "session.yaml");
  }
}

TEST_F(written_places, with_all_their_signs_are_not_doubted_anywhere) {
  const auto place = [](const WrittenSample& s) {
    return Fields{degrees_text(s.ins.latitude_rad), degrees_text(s.ins.longitude_rad)};
  };
  for (const auto& [latitude_rad, longitude_rad] :
       {std::pair(-0.58, -1.23), {0.65, -2.13}, {-0.6, 2.6}, {0.84, 0.2}, {0.3, 3.0}}) {
    const Description found = described_as("lat,lon", place, moved(latitude_rad, longitude_rad));
    ASSERT_TRUE(found.complete());
    EXPECT_EQ(guess_of(found, GuessKind::Position)->sureness, Sureness::Named) << latitude_rad;
    EXPECT_EQ(guess_of(found, GuessKind::Attitude)->sureness, Sureness::Checked) << latitude_rad;
    EXPECT_EQ(found.ins->layout.place_signs, (std::array{1.0, 1.0}));
  }
}

/// Which may as well be a heading that is half a turn off: the numbers stay as they are.
TEST_F(written_places, without_both_signs_are_open_as_they_stand) {
  const auto place = [](const WrittenSample& s) {
    return Fields{degrees_text(std::abs(s.ins.latitude_rad)), degrees_text(std::abs(s.ins.longitude_rad))};
  };
  const Description found = described_as("lat,lon", place, moved(-0.58, -1.23));
  ASSERT_TRUE(found.complete());
  const Guess* position = guess_of(found, GuessKind::Position);
  EXPECT_EQ(position->sureness, Sureness::Open);
  EXPECT_TRUE(says(position->evidence, "guess-signs-lost"));
  EXPECT_EQ(found.ins->layout.place_signs, (std::array{1.0, 1.0}));
  ASSERT_EQ(position->other_layouts.size(), 1U);
  EXPECT_EQ(position->other_layouts[0].place_signs, (std::array{-1.0, -1.0}));
}

/// No quaternion turns with a mirrored way.
TEST_F(written_places, without_a_sign_beside_a_quaternion_are_read_with_it) {
  const std::vector<WrittenSample> west = moved(0.65, -2.13);
  write_rows(
      folder_.path() / "motion.csv", "time_ns,lat,lon,h,qx,qy,qz,qw\n",
      [&](std::size_t, const WrittenSample& s) {
        const Eigen::Quaterniond& q = s.ins.enu_from_ins;
        return Fields{std::to_string(s.ins.stamp_ns),
                      degrees_text(s.ins.latitude_rad),
                      degrees_text(std::abs(s.ins.longitude_rad)),
                      number(s.ins.height_m),
                      number(q.x()),
                      number(q.y()),
                      number(q.z()),
                      number(q.w())};
      },
      west);
  const Description found = described({folder_.path()});
  ASSERT_TRUE(found.complete());
  EXPECT_EQ(guess_of(found, GuessKind::Position)->sureness, Sureness::Open);
  EXPECT_EQ(found.ins->layout.place_signs, (std::array{1.0, -1.0}));
  const double off_m = farthest_m(opened(found, folder_.path()), west);
  std::cout << "off by " << off_m << " m\n";
  EXPECT_LT(off_m, 1e-4);
}

/// The same numbers as those of a mirrored way with a quaternion that counts otherwise; a level road tells nothing.
TEST_F(written_places, of_an_ins_across_with_a_quaternion_are_open_on_a_level_road) {
  std::vector<WrittenSample> across = circles(session_->scans->stamp_ns(0) - 1'000'000'000, 30.0);
  for (WrittenSample& sample : across)
    sample.ins.enu_from_ins = sample.ins.enu_from_ins * Eigen::AngleAxisd(kPi / 2.0, Eigen::Vector3d::UnitZ());
  folder_.write("motion.txt", table_text(layouts()[5], across));
  const Description found = described({folder_.path()});
  ASSERT_TRUE(found.ins);
  const Guess* position = guess_of(found, GuessKind::Position);
  EXPECT_EQ(position->sureness, Sureness::Open);
  EXPECT_TRUE(std::ranges::any_of(position->other_layouts, [](const formats::InsTableLayout& other) {
    return other.place_signs == std::array{1.0, 1.0} && other.quaternion == drive::QuaternionConvention::NedFromBody;
  })) << "as it is";
}

TEST_F(written_places, whose_minutes_reach_sixty_are_no_minutes) {
  folder_.write("motion.csv",
                "t,lat,lon,h,r,p,y\n1600000000,4860.0,1131.0,0,0,0,0\n1600000001,4807.0,1131.0,0,0,0,0\n");
  formats::InsTableLayout layout;
  layout.time.name = "t", layout.latitude.name = "lat", layout.longitude.name = "lon", layout.height.name = "h";
  layout.yaw_pitch_roll = {formats::ColumnRef{"y", 0}, {"p", 0}, {"r", 0}};
  layout.position_unit = formats::PlaceUnit::DegreesMinutes;
  std::vector<drive::Finding> findings;
  EXPECT_EQ(read_ins_table(folder_.path() / "motion.csv", layout, findings).size(), 1U);
  ASSERT_FALSE(findings.empty());
  EXPECT_NE(english(findings.front().explanation).find("60.000 minutes, expected less than 60"), std::string::npos)
      << english(findings.front().explanation);
  folder_.write("sides.csv", "t,lat,side,lon,h,r,p,y\n1600000000,48.0,N,11.0,0,0,0,0\n1600000001,48.0,up,11,0,0,0,0\n");
  layout.position_unit = formats::PlaceUnit::Degrees;
  layout.latitude_side = formats::ColumnRef{"side", 0};
  findings.clear();
  EXPECT_EQ(read_ins_table(folder_.path() / "sides.csv", layout, findings).size(), 1U);
  ASSERT_FALSE(findings.empty());
  EXPECT_NE(english(findings.front().explanation).find("holds 'up', expected N or S"), std::string::npos);
}

}  // namespace
}  // namespace remount::guesses
