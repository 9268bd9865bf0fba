// What was taken for something else, with a comment that was sure of it.
#include <gtest/gtest.h>

#include <iostream>

#include "model/formats/files/running_period.h"
#include "model/formats/files/time_unit.h"
#include "tests/model/guesses/described_rows.h"

namespace remount::guesses {
namespace {

namespace fs = std::filesystem;

/// Its attitude in the metric world, as that is turned against true north.
drive::AttitudeAngles metric_angles(const WrittenSample& sample, drive::AttitudeConvention convention) {
  return drive::angles_from(Eigen::Quaterniond(sample.world_from_ins.linear()), convention);
}

class misleading_data : public DescribedRows {
 protected:
  static void rename_scans(const fs::path& scans, const std::function<std::string(std::size_t)>& name) {
    for (std::size_t i = 0; fs::exists(scans / (std::to_string(i) + ".pcd")); ++i)
      fs::rename(scans / (std::to_string(i) + ".pcd"), scans / name(i));
  }

  static void expect_stamps_of_the_drive(const ScansGuess& lidar) {
    ASSERT_EQ(lidar.stamps_ns.size(), session_->scans->size());
    for (std::size_t i = 0; i < lidar.stamps_ns.size(); ++i)
      EXPECT_LT(std::abs(lidar.stamps_ns[i] - session_->scans->stamp_ns(i)), 1000) << i;
  }
};

TEST_F(misleading_data, a_column_that_counts_rows_names_no_scans) {
  for (const char* counter : {"", "satellites"}) {
    const formats::TemporaryFolder folder;
    write_scans(native_drive(), folder.path(), ScanNames::RowsOfTimes);
    const bool rows = std::string_view(counter).empty();
    write_rows(folder.path() / "ins.csv", std::string(counter) + ",time" + kGeodeticHead,
               [&](std::size_t i, const WrittenSample& sample) {
                 return joined({std::to_string(rows ? i : 5 + i / 40 % 8), seconds_text(sample.ins.stamp_ns)},
                               geodetic(sample));
               });
    const Description found = described({folder.path()});
    ASSERT_EQ(found.lidars.size(), 1U);
    ASSERT_TRUE(found.lidars[0].table) << counter;
    EXPECT_EQ(found.lidars[0].table->table.filename(), "timestamps.txt") << counter;
    expect_stamps_of_the_drive(found.lidars[0]);
    ASSERT_TRUE(found.ins);
    EXPECT_EQ(found.ins->file.filename(), "ins.csv");
  }
}

TEST_F(misleading_data, x_to_the_north_is_not_read_mirrored) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  write_rows(
      folder.path() / "ins.csv", "time,x,y,z,roll,pitch,heading\n", [](std::size_t, const WrittenSample& sample) {
        const Fields east_north_up = place_m(sample);
        const drive::AttitudeAngles a = metric_angles(sample, drive::AttitudeConvention::Heading);
        return joined({std::to_string(sample.ins.stamp_ns), east_north_up[1], east_north_up[0], east_north_up[2]},
                      angles(a));
      });
  const Description found = described({folder.path()});
  const Guess *position = guess_of(found, GuessKind::Position), *attitude = guess_of(found, GuessKind::Attitude);
  ASSERT_TRUE(position && attitude);
  EXPECT_EQ(position->columns, (Fields{"y", "x", "z"}));
  EXPECT_TRUE(says(position->evidence, "guess-x-is-north"));
  EXPECT_EQ(attitude->sureness, Sureness::Open) << "somebody's heading may count from x";
  EXPECT_TRUE(says(attitude->evidence, "guess-axes-not-told"));
  const double apart = motions_apart(opened(found, folder.path()), *session_);
  std::cout << "motions " << apart << " apart\n";
  EXPECT_LT(apart, kTextPrecision);
}

TEST_F(misleading_data, yaw_beside_x_and_y_does_not_tell_which_is_north) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  write_rows(folder.path() / "ins.csv", "time,x,y,z,roll,pitch,yaw\n", [](std::size_t, const WrittenSample& sample) {
    return joined(joined({std::to_string(sample.ins.stamp_ns)}, place_m(sample)),
                  angles(metric_angles(sample, drive::AttitudeConvention::EnuYaw)));
  });
  const Description found = described({folder.path()});
  const Guess* attitude = guess_of(found, GuessKind::Attitude);
  ASSERT_TRUE(attitude);
  EXPECT_EQ(attitude->sureness, Sureness::Open);
  ASSERT_EQ(attitude->alternatives.size(), 1U) << "all else was refuted";
  EXPECT_TRUE(formats::contains(english(attitude->alternatives.front()), "position: {east: y, north: x"));
  EXPECT_LT(motions_apart(opened(found, folder.path()), *session_), kTextPrecision);
}

TEST_F(misleading_data, units_that_titles_state_are_obeyed_or_refused) {
  const std::int64_t first_ns = samples_->front().ins.stamp_ns;
  for (const auto& [title, unit] : {std::pair("time (milliseconds)", "ms"),
                                    {"time (msecs)", "ms"},
                                    {"time (microseconds)", "us"},
                                    {"time (\xce\xbcs)", "us"},
                                    {"time[nsecs]", "ns"}}) {
    const formats::TemporaryFolder folder;
    const std::int64_t unit_ns = *formats::time_unit_named_ns(unit);
    write_rows(folder.path() / "ins.csv", title + std::string(kGeodeticHead),
               [&](std::size_t, const WrittenSample& sample) {
                 return joined({std::to_string((sample.ins.stamp_ns - first_ns) / unit_ns)}, geodetic(sample));
               });
    const Description found = described({folder.path()});
    const Guess* time = guess_of(found, GuessKind::Time);
    ASSERT_TRUE(time) << title;
    EXPECT_EQ(time->unit, unit) << title;
    EXPECT_FALSE(says(time->evidence, "guess-unit-by-size")) << title;
  }
  for (const auto& [head, why] :
       {std::pair("time,X(mm),Y(mm),Z(mm),roll,pitch,heading\n", "unit \"mm\" of X(mm), Y(mm), Z(mm)"),
        {"time,lat,lon,Altitude (ft),roll,pitch,heading\n", "unit \"ft\" of Altitude (ft)"},
        {"time (h),lat,lon,alt,roll,pitch,heading\n", "unit \"h\" of time (h)"},
        {"time,lat,lon,alt,roll(rad),pitch(rad),heading(deg)\n", "are in different units"}}) {
    const formats::TemporaryFolder folder;
    write_rows(folder.path() / "ins.csv", head, [](std::size_t, const WrittenSample& sample) {
      return joined({seconds_text(sample.ins.stamp_ns)}, geodetic(sample));
    });
    const Description found = described({folder.path()});
    EXPECT_FALSE(found.ins) << head;
    EXPECT_TRUE(says_why(found, why)) << head;
  }
}

TEST_F(misleading_data, a_time_in_whole_steps_goes_before_an_odometer) {
  for (const std::size_t step : {1, 10}) {
    const formats::TemporaryFolder folder;
    double way_m = 0.0;
    write_rows(folder.path() / "ins.csv", "time,odometer" + std::string(kGeodeticHead),
               [&](std::size_t i, const WrittenSample& sample) {
                 return joined({std::to_string(step * i), number(way_m += 0.05)}, geodetic(sample));
               });
    const Description found = described({folder.path()});
    const Guess* time = guess_of(found, GuessKind::Time);
    ASSERT_TRUE(time) << step;
    EXPECT_EQ(time->columns, Fields{"time"}) << step;
    EXPECT_EQ(time->sureness, Sureness::Open) << "seconds or milliseconds?";
    EXPECT_TRUE(says(time->alternatives, "guess-unit-alternative")) << step;
  }
}

TEST_F(misleading_data, numbers_of_scans_with_gaps_are_no_seconds) {
  const auto every_fifth = [](std::size_t i) {
    const std::string number = std::to_string(5 * i);
    return std::string(6 - number.size(), '0') + number + ".pcd";
  };
  for (const bool with_table : {true, false}) {
    const formats::TemporaryFolder folder;
    write_scans(native_drive(), folder.path(), ScanNames::RowsOfTimes);
    rename_scans(folder.path() / "scans", every_fifth);
    if (!with_table) fs::remove(folder.path() / "timestamps.txt");
    const Description found = described({folder.path()});
    ASSERT_EQ(found.lidars.size(), 1U);
    const Guess* stamps = find_guess(found.lidars[0].guesses, GuessKind::Stamps);
    if (with_table) {
      ASSERT_TRUE(found.lidars[0].table);
      expect_stamps_of_the_drive(found.lidars[0]);
      EXPECT_NE(stamps, nullptr);
      continue;
    }
    ASSERT_TRUE(stamps) << "they may be seconds, as nothing else is there";
    EXPECT_EQ(stamps->sureness, Sureness::Open);
    EXPECT_TRUE(says(stamps->alternatives, "guess-stamps-may-be-numbers"));
    EXPECT_TRUE(found.open());
  }
}

TEST_F(misleading_data, seconds_of_a_week_that_do_not_meet_the_scans_are_told) {
  for (const int hours : {0, 8}) {
    const formats::TemporaryFolder folder;
    write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
    write_rows(folder.path() / "ins.csv", "TOW(s)" + std::string(kGeodeticHead),
               [&](std::size_t, const WrittenSample& sample) {
                 const std::int64_t gps_ns = formats::gps_ns_from_unix_ns(sample.ins.stamp_ns);
                 return joined({seconds_text((gps_ns - hours * 3600'000'000'000) % formats::kGpsWeek_ns)},
                               geodetic(sample));
               });
    const Description found = described({folder.path()});
    ASSERT_TRUE(found.ins && found.clock) << hours;
    EXPECT_TRUE(says(found.clock->evidence, "guess-clock-week"));
    const Guess* time = guess_of(found, GuessKind::Time);
    if (hours == 0) {
      EXPECT_EQ(found.clock->sureness, Sureness::Checked);
      EXPECT_EQ(time->sureness, Sureness::Checked);
      continue;
    }
    EXPECT_EQ(found.clock->sureness, Sureness::Open);
    EXPECT_TRUE(found.open());
    EXPECT_EQ(time->sureness, Sureness::Named) << "nothing was found to agree";
    ASSERT_EQ(found.clock->alternatives.size(), 1U);
    EXPECT_TRUE(formats::contains(english(found.clock->alternatives.front()), "+28800"))
        << "as it is added to the INS: " << english(found.clock->alternatives.front());
  }
}

TEST_F(misleading_data, seconds_of_a_week_go_on_over_its_end) {
  const std::int64_t first_ns = session_->scans->stamp_ns(0),
                     in_week_ns = formats::gps_ns_from_unix_ns(first_ns) % formats::kGpsWeek_ns;
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::RowsOfTimes);
  std::string times;  // of the same scans, with the end of the week in the middle of the drive
  const std::int64_t moved_ns = formats::kGpsWeek_ns - in_week_ns - 12'000'000'000;
  for (std::size_t i = 0; i < session_->scans->size(); ++i)
    times += formats::format_date_ns(session_->scans->stamp_ns(i) + moved_ns) + "\n";
  folder.write("timestamps.txt", times);
  for (const int hours : {0, 30}) {
    write_rows(folder.path() / "ins.csv", "TOW(s)" + std::string(kGeodeticHead),
               [&](std::size_t, const WrittenSample& sample) {
                 const std::int64_t gps_ns = formats::gps_ns_from_unix_ns(sample.ins.stamp_ns) + moved_ns;
                 return joined({seconds_text((gps_ns - hours * 3600'000'000'000) % formats::kGpsWeek_ns)},
                               geodetic(sample));
               });
    const Description found = described({folder.path()});
    const Guess* time = guess_of(found, GuessKind::Time);
    ASSERT_TRUE(time && found.clock);
    EXPECT_EQ(time->sureness, hours == 0 ? Sureness::Checked : Sureness::Named) << hours;
    EXPECT_EQ(found.clock->sureness, hours == 0 ? Sureness::Checked : Sureness::Open) << hours;
  }
}

TEST_F(misleading_data, a_long_log_does_not_tell_which_zone_it_is_in) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  const std::int64_t first_ns = session_->scans->stamp_ns(0) - 10LL * 3600 * 1'000'000'000;  // and ends 8 hours before
  std::vector<WrittenSample> hours = circles(first_ns, 720.0);
  for (WrittenSample& sample : hours) sample.ins.stamp_ns = first_ns + (sample.ins.stamp_ns - first_ns) * 10;
  write_rows(
      folder.path() / "ins.csv", "time" + std::string(kGeodeticHead),
      [](std::size_t, const WrittenSample& sample) {
        return joined({formats::format_date_ns(sample.ins.stamp_ns)}, geodetic(sample));
      },
      hours);
  const Description found = described({folder.path()});
  ASSERT_TRUE(found.clock);
  EXPECT_EQ(found.clock->sureness, Sureness::Open);
  EXPECT_TRUE(says(found.clock->alternatives, "guess-clock-together-by-several"));
  ASSERT_EQ(found.clock->alternatives.size(), 1U);
  std::cout << english(found.clock->alternatives.front()) << "\n";
}

TEST_F(misleading_data, a_broken_scan_at_the_beginning_does_not_lose_the_others) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  const std::string first = std::to_string(session_->scans->stamp_ns(0)) + ".pcd";
  folder.write("scans/" + first, "# .PCD v0.7\n");
  const Description found = described({folder.path()});
  ASSERT_EQ(found.lidars.size(), 1U);
  EXPECT_EQ(found.lidars[0].count, session_->scans->size());
}

TEST_F(misleading_data, of_two_logs_of_a_week_the_one_of_the_scans_is_taken) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  for (const int days : {1, 0})
    write_rows(folder.path() / (days == 1 ? "a.csv" : "b.csv"), "TOW(s)" + std::string(kGeodeticHead),
               [&](std::size_t, const WrittenSample& sample) {
                 const std::int64_t gps_ns = formats::gps_ns_from_unix_ns(sample.ins.stamp_ns);
                 return joined({seconds_text((gps_ns + days * 86'400'000'000'000) % formats::kGpsWeek_ns)},
                               geodetic(sample));
               });
  const Description found = described({folder.path()});
  ASSERT_TRUE(found.ins);
  EXPECT_EQ(found.ins->file.filename(), "b.csv");
}

TEST_F(misleading_data, dates_that_hold_the_scans_in_two_scales_are_not_checked) {
  const std::int64_t first_ns = session_->scans->stamp_ns(0);
  for (const double before_s : {60.0, 2.0}) {
    const formats::TemporaryFolder folder;
    write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
    const double scans_s =
        1e-9 * static_cast<double>(session_->scans->stamp_ns(session_->scans->size() - 1) - first_ns);
    write_rows(
        folder.path() / "ins.csv", "time" + std::string(kGeodeticHead),
        [](std::size_t, const WrittenSample& sample) {
          return joined({formats::format_date_ns(sample.ins.stamp_ns)}, geodetic(sample));
        },
        circles(first_ns - static_cast<std::int64_t>(1e9 * before_s), scans_s + 2.0 * before_s));
    const Description found = described({folder.path()});
    const Guess* time = guess_of(found, GuessKind::Time);
    ASSERT_TRUE(time && found.clock) << before_s;
    const bool wide = before_s > 18.0;
    EXPECT_EQ(time->sureness, wide ? Sureness::Named : Sureness::Checked) << before_s;
    EXPECT_EQ(time->alternatives.size(), wide ? 1U : 0U) << "in GPS time";
    EXPECT_EQ(says(found.clock->evidence, "guess-clock-not-to-seconds"), wide) << before_s;
    EXPECT_EQ(found.clock->sureness, wide ? Sureness::Named : Sureness::Checked) << before_s;
  }
}

TEST_F(misleading_data, a_manifest_that_cannot_be_opened_needs_another) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  folder.write(
      "session.yaml",
      "format: remount-session/1\nname: half\nscans: {directory: scans, type: pcd, stamps: from-names, timing: "
      "unknown}\n");
  write_rows(folder.path() / "ins.csv", "time" + std::string(kGeodeticHead),
             [](std::size_t, const WrittenSample& sample) {
               return joined({seconds_text(sample.ins.stamp_ns)}, geodetic(sample));
             });
  const Description found = described({folder.path()});
  EXPECT_FALSE(found.known);
  EXPECT_TRUE(found.complete());
  EXPECT_TRUE(says_why(found, "a manifest that cannot be opened"));
  EXPECT_FALSE(opened(found, folder.path()).ins.empty());
  const Description again = described({folder.path()});
  ASSERT_TRUE(again.known) << "now it can";
  EXPECT_EQ(again.known->format, "native");
}

TEST_F(misleading_data, a_known_format_that_cannot_be_opened_says_why) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  folder.write("2011_09_26_drive_0001_sync/oxts/timestamps.txt", "none\n");
  folder.write("2011_09_26_drive_0001_sync/oxts/data/0000000000.txt", "none\n");
  fs::create_directories(folder.path() / "2011_09_26_drive_0001_sync/velodyne_points/data");
  const fs::path log = folder.write("broken/inspvax.csv", "header.gps_week,azimuth,undulation\nnone,none,none\n");
  Progress progress;
  for (const auto& [path, format] : {std::pair(folder.path(), "KITTI"), {log.parent_path(), "NovAtel"}}) {
    ASSERT_NE(formats::recognise_session(path), nullptr) << path;
    EXPECT_THROW(formats::open_session(path, progress), Error) << path;
    const Description found = described({path});
    EXPECT_FALSE(found.known) << path;
    EXPECT_TRUE(says_why(found, "cannot be opened")) << path;
    EXPECT_TRUE(says_why(found, std::string("recognised (") + format)) << path;
  }
}

TEST_F(misleading_data, poses_of_which_no_name_tells_the_ins_are_not_read_as_they_are) {
  const formats::TemporaryFolder folder;
  for (const char* name : {"gt.txt", "odo.txt"}) {
    std::string text;
    for (const WrittenSample& sample : *samples_) {
      const Fields q = wxyz(Eigen::Quaterniond(sample.world_from_ins.linear())), p = place_m(sample);
      text += seconds_text(sample.ins.stamp_ns) + " " + p[0] + " " + p[1] + " " + p[2] + " " + q[1] + " " + q[2] + " " +
              q[3] + " " + q[0] + "\n";
    }
    folder.write(name, text);
  }
  Progress progress;
  EXPECT_THROW(formats::open_session(folder.path(), progress), Error);
  EXPECT_FALSE(described({folder.path()}).known);
}

TEST_F(misleading_data, nanoseconds_alone_are_the_whole_time) {
  for (const char* title : {"time_nsec", "stamp_nsec", "timestamp_nanosec"}) {
    const formats::TemporaryFolder folder;
    write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
    write_rows(folder.path() / "ins.csv", title + std::string(kGeodeticHead),
               [](std::size_t, const WrittenSample& sample) {
                 return joined({std::to_string(sample.ins.stamp_ns)}, geodetic(sample));
               });
    const Description found = described({folder.path()});
    ASSERT_TRUE(found.ins) << title;
    EXPECT_EQ(found.ins->span.first_ns, samples_->front().ins.stamp_ns) << title;
  }
}

TEST_F(misleading_data, nanoseconds_beside_whole_seconds_are_their_rest) {
  for (const char* titles : {"time,nsec", "sec,nanosec", "nsecs,secs"}) {
    const bool rest_first = std::string_view(titles).starts_with("nsecs");
    const formats::TemporaryFolder folder;
    write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
    write_rows(folder.path() / "ins.csv", titles + std::string(kGeodeticHead),
               [&](std::size_t, const WrittenSample& sample) {
                 Fields parts{std::to_string(sample.ins.stamp_ns / 1'000'000'000),
                              std::to_string(sample.ins.stamp_ns % 1'000'000'000)};
                 if (rest_first) std::swap(parts[0], parts[1]);
                 return joined(parts, geodetic(sample));
               });
    const Description found = described({folder.path()});
    ASSERT_TRUE(found.ins) << titles;
    EXPECT_EQ(found.ins->span.first_ns, samples_->front().ins.stamp_ns) << titles;
    EXPECT_TRUE(found.ins->layout.nanoseconds) << titles;
  }
}

TEST_F(misleading_data, a_line_of_chinese_units_holds_no_titles) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  write_rows(folder.path() / "ins.csv", "时间,纬度,经度,高程,横滚,俯仰,航向\n秒,度,度,米,度,度,度\n",
             [](std::size_t, const WrittenSample& sample) {
               return joined({seconds_text(sample.ins.stamp_ns)}, geodetic(sample));
             });
  const Description found = described({folder.path()});
  const Guess* position = guess_of(found, GuessKind::Position);
  ASSERT_TRUE(position);
  EXPECT_EQ(position->sureness, Sureness::Named);
  EXPECT_EQ(position->columns, (Fields{"纬度", "经度", "高程"}));
  EXPECT_LT(motions_apart(opened(found, folder.path()), *session_), kTextPrecision);
}

}  // namespace
}  // namespace remount::guesses
