// What the data do not tell, or tell otherwise than one would think.
#include <gtest/gtest.h>

#include <iostream>
#include <limits>

#include "algorithms/messages/render.h"
#include "model/formats/files/running_period.h"
#include "tests/model/guesses/described_drive.h"
#include "tests/model/guesses/described_rows.h"

namespace remount::guesses {
namespace {

namespace fs = std::filesystem;

class doubtful_data : public DescribedRows {
 protected:
  /// How far motions lie off the drive's where its samples are written so; infinite where the description lacks
  /// something.
  static double apart_as_described(const WrittenLayout& layout) {
    const formats::TemporaryFolder folder;
    write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
    folder.write("motion.csv", table_text(layout, *samples_));
    const Description found = described({folder.path()});
    if (!found.complete()) return std::numeric_limits<double>::infinity();
    const double apart = motions_apart(opened(found, folder.path()), *session_);
    std::cout << "motions " << apart << " apart\n";
    return apart;
  }
};

TEST_F(doubtful_data, a_vehicle_that_stands_does_not_tell_how_its_heading_counts) {
  std::vector<WrittenSample> standing = *samples_;
  for (WrittenSample& sample : standing) {
    const std::int64_t stamp_ns = sample.ins.stamp_ns;
    sample = samples_->front();
    sample.ins.stamp_ns = stamp_ns;
  }
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  folder.write("motion.txt", table_text(layouts()[9], standing));  // "yaw", which may be either
  const Description found = described({folder.path()});
  ASSERT_TRUE(found.ins);
  const Guess* attitude = find_guess(found.ins->guesses, GuessKind::Attitude);
  ASSERT_NE(attitude, nullptr);
  EXPECT_EQ(attitude->sureness, Sureness::Open);
  EXPECT_TRUE(says(attitude->evidence, "guess-hardly-moves"));
  EXPECT_GE(attitude->alternatives.size(), 3U) << "the other ways to count it";
  EXPECT_TRUE(found.open());
  const formats::TemporaryFolder unnamed;
  write_scans(native_drive(), unnamed.path(), ScanNames::Nanoseconds);
  unnamed.write("motion.txt", table_text(layouts()[4], standing));
  const Description nothing = described({unnamed.path()});
  EXPECT_FALSE(nothing.ins) << "numbers that nobody names and nothing moves";
  EXPECT_FALSE(nothing.complete());
}

/// Half a minute straight on at 10 m/s, with a compass heading. @param hills_m how high they are
std::vector<WrittenSample> straight_drive(double heading_rad, std::int64_t first_ns, double hills_m = 0.0) {
  constexpr double kHill_m = 30.0;
  std::vector<WrittenSample> samples;
  for (int i = 0; i < 600; ++i) {
    WrittenSample sample;
    const double way_m = 0.5 * i;
    sample.ins.stamp_ns = first_ns + i * 50'000'000LL;
    sample.ins.latitude_rad = 0.85 + way_m * std::cos(heading_rad) / 6'371'000.0;
    sample.ins.longitude_rad = 0.15 + way_m * std::sin(heading_rad) / 6'371'000.0 / std::cos(0.85);
    sample.ins.height_m = 250.0 + hills_m * std::sin(way_m / kHill_m);
    const double slope_rad = std::atan(hills_m / kHill_m * std::cos(way_m / kHill_m));
    sample.ins.enu_from_ins = drive::enu_from_ins({heading_rad, slope_rad, 0.0}, drive::AttitudeConvention::Heading);
    samples.push_back(sample);
  }
  return samples;
}

TEST_F(doubtful_data, a_straight_drive_tells_by_the_angle_alone_and_says_so) {
  const std::int64_t first_ns = session_->scans->stamp_ns(0) - 1'000'000'000;
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  folder.write("motion.txt", table_text(layouts()[1], straight_drive(degrees_to_radians(30.0), first_ns)));
  const Description found = described({folder.path()});
  ASSERT_TRUE(found.ins);
  const Guess* attitude = find_guess(found.ins->guesses, GuessKind::Attitude);
  EXPECT_EQ(attitude->sureness, Sureness::Likely);
  EXPECT_TRUE(says(attitude->evidence, "guess-straight"));
  EXPECT_FALSE(attitude->alternatives.empty()) << "the box may be built in across";
  EXPECT_EQ(found.ins->layout.attitude, drive::AttitudeConvention::Heading);
  // "yaw" at 45 degrees is the same from north and from east.
  const formats::TemporaryFolder both;
  write_scans(native_drive(), both.path(), ScanNames::Nanoseconds);
  both.write("motion.txt", table_text(layouts()[9], straight_drive(degrees_to_radians(45.0), first_ns)));
  const Description open = described({both.path()});
  ASSERT_TRUE(open.ins);
  const Guess* either = find_guess(open.ins->guesses, GuessKind::Attitude);
  std::cout << english(words(either->sureness)) << ", alternatives " << either->alternatives.size() << "\n";
  EXPECT_EQ(either->sureness, Sureness::Open);
  EXPECT_GE(either->alternatives.size(), 2U);
}

TEST_F(doubtful_data, a_pitch_that_the_road_refutes_is_no_alternative) {
  const std::int64_t first_ns = session_->scans->stamp_ns(0) - 1'000'000'000;
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  folder.write("motion.txt", table_text(layouts()[9], straight_drive(degrees_to_radians(30.0), first_ns, 3.0)));
  const Description found = described({folder.path()});
  ASSERT_TRUE(found.ins);
  const Guess* attitude = find_guess(found.ins->guesses, GuessKind::Attitude);
  EXPECT_EQ(found.ins->layout.yaw_pitch_roll_signs[1], -1.0);
  EXPECT_TRUE(std::ranges::none_of(attitude->alternatives, [](const Message& one) {
    return english(one) == "convention: enu-yaw, unit: deg";
  })) << "the road goes the other way";
  EXPECT_EQ(attitude->alternatives.size(), 1U) << "across, and counted the other way";
  EXPECT_EQ(attitude->sureness, Sureness::Likely);
}

TEST_F(doubtful_data, an_ins_across_its_vehicle_is_told_with_the_angle) {
  std::vector<WrittenSample> across = *samples_;
  for (WrittenSample& sample : across)
    sample.ins.enu_from_ins = sample.ins.enu_from_ins * Eigen::AngleAxisd(kPi / 2.0, Eigen::Vector3d::UnitZ());
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  folder.write("motion.txt", table_text(layouts()[5], across));  // a quaternion, which begins nowhere else
  const Description found = described({folder.path()});
  ASSERT_TRUE(found.ins);
  const Guess* attitude = find_guess(found.ins->guesses, GuessKind::Attitude);
  EXPECT_EQ(attitude->sureness, Sureness::Likely);
  EXPECT_TRUE(says(attitude->evidence, "guess-heading-offset"));
  EXPECT_EQ(found.ins->layout.quaternion, drive::QuaternionConvention::NedFromBody);
}

TEST_F(doubtful_data, quaternions_without_names_are_told_by_their_length_and_by_travel) {
  WrittenLayout layout = layouts()[5];
  layout.head.clear();
  for (const bool w_first : {false, true}) {
    const auto w_last = layouts()[5].row;
    layout.row = [&](const WrittenSample& sample) {
      std::vector<std::string> fields = w_last(sample);
      fields[0] = seconds_text(sample.ins.stamp_ns);
      if (w_first) std::rotate(fields.begin() + 4, fields.end() - 1, fields.end());
      return fields;
    };
    EXPECT_LT(apart_as_described(layout), kTextPrecision) << w_first;
  }
}

TEST_F(doubtful_data, folders_of_clouds_are_lidars_and_single_clouds_are_none) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path() / "front", ScanNames::Nanoseconds);
  write_scans(native_drive(), folder.path() / "rear side", ScanNames::RowsOfTimes);
  fs::copy_file(native_drive() / "scans" / "0000000000.pcd", folder.path() / "map.pcd");
  folder.write("motion.txt", table_text(layouts()[2], *samples_));
  const Description found = described({folder.path()});
  ASSERT_EQ(found.lidars.size(), 2U);
  EXPECT_TRUE(found.complete());
  EXPECT_EQ(found.not_used.size(), 1U);
  const drive::Session session = opened(found, folder.path());
  EXPECT_EQ(session.topics.size(), 2U);
  EXPECT_EQ(session.scans->size(), session_->scans->size());
}

TEST_F(doubtful_data, poses_that_keep_to_no_direction_are_read_as_a_file_of_poses) {
  std::string text;
  for (int i = 0; i < 400; ++i) {
    const double angle = 0.05 * i;
    const Eigen::Quaterniond q(Eigen::AngleAxisd(angle, Eigen::Vector3d(1.0, 0.5, 0.25).normalized()));
    text += seconds_text(session_->scans->stamp_ns(0) + i * 50'000'000LL) + " " + number(std::sin(angle)) + " " +
            number(std::cos(2.0 * angle)) + " " + number(0.1 * std::sin(3.0 * angle)) + " " + number(q.x()) + " " +
            number(q.y()) + " " + number(q.z()) + " " + number(q.w()) + "\n";
  }
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  folder.write("hand.txt", text);
  const Description found = described({folder.path()});
  ASSERT_TRUE(found.complete());
  EXPECT_EQ(found.ins->pose_format, "tum");
  EXPECT_TRUE(found.open()) << "nothing of it was compared";
  EXPECT_EQ(opened(found, folder.path()).world_from_ins.size(), 400U);
}

TEST_F(doubtful_data, of_two_motions_the_one_of_the_scans_is_taken) {
  std::vector<WrittenSample> other_day = *samples_;
  for (WrittenSample& sample : other_day) sample.ins.stamp_ns += 40LL * 3600 * 1'000'000'000;
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  folder.write("a.csv", table_text(layouts()[2], other_day));  // by what it says of itself the surer one
  folder.write("b.csv", table_text(layouts()[4], *samples_));
  const Description found = described({folder.path()});
  ASSERT_TRUE(found.complete());
  EXPECT_EQ(found.ins->file.filename(), "b.csv");
  EXPECT_EQ(found.clock->sureness, Sureness::Checked);
}

TEST_F(doubtful_data, garbage_is_no_motion_and_no_scan) {
  const formats::TemporaryFolder folder;
  std::string noise;
  for (unsigned i = 0; i < 5000; ++i) noise += static_cast<char>((i * 2654435761U) >> 13);
  folder.write("a.txt", noise);
  folder.write("b.csv", "once,upon,a,time\nthere,was,a,table\nthat,held,no,numbers\n,,,\n\n");
  folder.write("c.pcd", "no cloud at all");
  folder.write("d.csv", "");
  const Description found = described({folder.path()});
  EXPECT_FALSE(found.ins);
  EXPECT_TRUE(found.lidars.empty());
  EXPECT_TRUE(says(found.missing, "guess-needs-ins"));
  EXPECT_TRUE(says(found.missing, "guess-needs-lidar"));
  EXPECT_FALSE(found.complete());
}

TEST_F(doubtful_data, numbers_that_move_and_have_no_attitude_are_said_to_lack_it) {
  std::string text = "time,latitude,longitude,height,speed,satellites\n";
  for (const WrittenSample& sample : *samples_)
    text += seconds_text(sample.ins.stamp_ns) + "," + degrees_text(sample.ins.latitude_rad) + "," +
            degrees_text(sample.ins.longitude_rad) + "," + number(sample.ins.height_m) + ",3.5,12\n";
  const formats::TemporaryFolder folder;
  folder.write("fixes.csv", text);
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  const Description found = described({folder.path()});
  EXPECT_FALSE(found.ins);
  ASSERT_EQ(found.not_used.size(), 1U);
  EXPECT_TRUE(formats::contains(english(found.not_used.front().why), "attitude")) << found.not_used.front().why;
}

TEST_F(doubtful_data, of_two_times_the_other_is_named_with_the_difference) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  folder.write("motion.txt", table_text(layouts()[9], *samples_));
  const Description found = described({folder.path()});
  ASSERT_TRUE(found.ins);
  const Guess* time = find_guess(found.ins->guesses, GuessKind::Time);
  EXPECT_EQ(time->columns, std::vector<std::string>{"timestamp (s)"});
  ASSERT_EQ(time->alternatives.size(), 1U);
  EXPECT_TRUE(formats::contains(english(time->alternatives.front()), "0.037 s")) << time->alternatives.front();
}

TEST_F(doubtful_data, clocks_that_do_not_meet_are_told_with_what_would_bring_them_together) {
  for (const auto& [shift_s, code] :
       {std::pair(315'964'782LL, "guess-offset-epoch"), {8LL * 3600, "guess-offset-zone"}}) {
    std::vector<WrittenSample> shifted = *samples_;
    for (WrittenSample& sample : shifted) sample.ins.stamp_ns -= shift_s * 1'000'000'000;
    const formats::TemporaryFolder folder;
    write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
    folder.write("motion.txt", table_text(layouts()[5], shifted));  // dates: no other epoch is meant
    const Description found = described({folder.path()});
    ASSERT_TRUE(found.ins && found.clock);
    EXPECT_EQ(found.clock->sureness, Sureness::Open);
    ASSERT_EQ(found.clock->alternatives.size(), 1U) << shift_s;
    const Argument* cause = found.clock->alternatives.front().argument("cause");
    ASSERT_NE(cause, nullptr);
    EXPECT_EQ(std::get<Message>(cause->value).code(), code) << found.clock->alternatives.front();
  }
}

TEST_F(doubtful_data, seconds_of_a_week_that_nothing_names_take_the_week_of_the_scans) {
  WrittenLayout layout = layouts()[0];
  layout.head = "TOW(s),Latitude(deg),Longitude(deg),Height(m),Roll(deg),Pitch(deg),Heading(deg),Course(deg)\n";
  const auto with_week = layout.row;
  layout.row = [&](const WrittenSample& sample) {
    std::vector<std::string> fields = with_week(sample);
    fields.erase(fields.begin());
    return fields;
  };
  EXPECT_LT(apart_as_described(layout), kTextPrecision);
}

TEST_F(doubtful_data, a_column_that_names_another_week_than_the_scans_leaves_the_time_open) {
  for (const int weeks : {0, 1, 1024}) {
    const formats::TemporaryFolder folder;
    write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
    write_rows(folder.path() / "ins.csv", "Week,TOW(s)" + std::string(kGeodeticHead),
               [&](std::size_t, const WrittenSample& sample) {
                 const std::int64_t gps_ns = formats::gps_ns_from_unix_ns(sample.ins.stamp_ns);
                 return joined({std::to_string(gps_ns / formats::kGpsWeek_ns - weeks),
                                seconds_text(gps_ns % formats::kGpsWeek_ns)},
                               geodetic(sample));
               });
    const Description found = described({folder.path()});
    const Guess* time = guess_of(found, GuessKind::Time);
    ASSERT_NE(time, nullptr) << weeks;
    EXPECT_EQ(says(time->evidence, "guess-time-of-week"), weeks == 0) << english(time->evidence.front());
    EXPECT_EQ(says(time->evidence, "guess-week-contradicts"), weeks == 1) << english(time->evidence.front());
    EXPECT_EQ(says(time->evidence, "guess-week-began-anew"), weeks == 1024) << english(time->evidence.front());
    EXPECT_EQ(time->sureness, weeks == 0   ? Sureness::Checked
                              : weeks == 1 ? Sureness::Open
                                           : Sureness::Likely)
        << weeks << english(time->evidence.front());
    EXPECT_EQ(found.open(), weeks == 1) << weeks;
  }
}

}  // namespace
}  // namespace remount::guesses
