#include "model/guesses/table_import.h"

#include <gtest/gtest.h>

#include <iostream>

#include "algorithms/messages/render.h"
#include "tests/model/guesses/described_rows.h"

namespace remount::guesses {
namespace {

namespace fs = std::filesystem;

class table_import : public DescribedRows {
 protected:
  static ImportData look(const fs::path& folder) {
    Progress progress;
    return look_for_import({folder}, progress);
  }
  static std::string manifest(const Description& description, const fs::path& folder) {
    return formats::to_yaml(manifest_of(description, folder, Language::English));
  }
  static ImportChoice untouched(const ImportData& data) { return {data.table, data.table->preset, {}}; }
  static ImportChecks checked(const ImportData& data, const ImportChoice& choice) {
    return check_choice(data.description, choice, Progress());
  }
  static Verdict verdict(const ImportChecks& checks, CheckKind kind) {
    const ImportCheck* check = checks.find(kind);
    EXPECT_TRUE(check) << english(words(kind));
    return check ? check->verdict : Verdict::NotTold;
  }
  static std::string said(const ImportChecks& checks) {
    std::string text;
    for (const ImportCheck& check : checks.checks)
      for (const Message& evidence : check.evidence)
        text += english(words(check.kind)) + ": " + english(evidence) + "\n";
    return text;
  }
  static std::size_t column(const ImportData& data, const std::string& title) {
    const auto& columns = data.table->table.columns;
    const auto found = std::ranges::find(columns, title, &SampledColumn::title);
    EXPECT_NE(found, columns.end()) << title;
    return static_cast<std::size_t>(found - columns.begin());
  }
  /// Metric, with a yaw of which nobody says from where it counts.
  static void write_metric(const fs::path& file) {
    write_rows(file, "t,x,y,z,roll,pitch,yaw\n", [](std::size_t, const WrittenSample& sample) {
      const Eigen::Vector3d place = sample.world_from_ins.translation();
      const drive::AttitudeAngles angles = yaw_angles(sample);
      return Fields{seconds_text(sample.ins.stamp_ns),
                    number(place.x()),
                    number(place.y()),
                    number(place.z()),
                    degrees_text(angles.roll_rad),
                    degrees_text(angles.pitch_rad),
                    degrees_text(angles.yaw_rad)};
    });
  }
};

TEST_F(table_import, what_is_left_as_guessed_gives_the_manifest_of_describe) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  std::size_t layouts_told = 0;
  for (const WrittenLayout& layout : layouts()) {
    folder.write("motion.txt", table_text(layout, *samples_));
    SCOPED_TRACE(layout.name);
    const ImportData data = look(folder.path());
    const std::string expected = manifest(described({folder.path()}), folder.path());
    ASSERT_TRUE(data.table);
    if (data.table->guess->pose_format) continue;
    const ImportChoice choice = untouched(data);
    EXPECT_EQ(manifest(description_of(data.description, choice, checked(data, choice)), folder.path()), expected);
    // Not only because nothing was touched: what the choices say is the same as well.
    std::vector<Message> lacks;
    const auto layout_again = layout_of(data.table->table, choice.choices, lacks);
    ASSERT_TRUE(layout_again) << english(lacks.front());
    Description again = data.description;
    again.ins->layout = *layout_again;
    EXPECT_EQ(manifest(again, folder.path()), expected);
    ++layouts_told;
  }
  std::cout << layouts_told << " layouts\n";
  EXPECT_GE(layouts_told, 5U);
}

TEST_F(table_import, checks_of_the_guess_are_good) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  write_rows(folder.path() / "motion.csv", "time" + std::string(kGeodeticHead),
             [](std::size_t, const WrittenSample& sample) {
               return joined({seconds_text(sample.ins.stamp_ns)}, geodetic(sample));
             });
  const ImportData data = look(folder.path());
  ASSERT_TRUE(data.table);
  EXPECT_EQ(data.folder, folder.path());
  EXPECT_EQ(data.table->first_rows.front().size(), 7U);
  const ImportChecks checks = checked(data, untouched(data));
  std::cout << said(checks);
  for (const ImportCheck& check : checks.checks)
    EXPECT_TRUE(check.verdict == Verdict::Good || check.verdict == Verdict::NotTold) << english(words(check.kind));
  EXPECT_EQ(checks.samples, samples_->size());
  EXPECT_GT(checks.drive.track_m.size(), 100U);
}

TEST_F(table_import, a_choice_between_x_to_the_east_and_to_the_north_reaches_manifest_and_session) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  write_metric(folder.path() / "motion.csv");
  const ImportData data = look(folder.path());
  ASSERT_TRUE(data.table);
  const Guess* attitude = find_guess(data.table->guess->guesses, GuessKind::Attitude);
  ASSERT_EQ(attitude->sureness, Sureness::Open);
  ASSERT_EQ(attitude->other_layouts.size(), attitude->alternatives.size());
  EXPECT_EQ(data.table->preset.column(ColumnRole::East), column(data, "x"));

  ImportChoice choice = untouched(data);
  give_role(data.table->table, choice.choices, column(data, "x"), ColumnRole::North);
  EXPECT_EQ(choice.choices.column(ColumnRole::East), column(data, "y")) << "they are exchanged";
  const ImportChecks mirrored = checked(data, choice);
  EXPECT_EQ(verdict(mirrored, CheckKind::Heading), Verdict::Bad) << said(mirrored);

  take_motion(data.table->table, attitude->other_layouts.back(), choice.choices);
  const ImportChecks checks = checked(data, choice);
  std::cout << said(checks);
  EXPECT_EQ(choice.choices.attitude, AttitudeStyle::Heading);
  EXPECT_NE(verdict(checks, CheckKind::Heading), Verdict::Bad);
  const Description made = description_of(data.description, choice, checks);
  EXPECT_TRUE(made.complete());
  EXPECT_FALSE(made.open()) << "somebody said so";
  const std::string text = manifest(made, folder.path());
  EXPECT_TRUE(formats::contains(text, "position: {east: y, north: x, ")) << text;
  EXPECT_TRUE(formats::contains(text, "chosen by hand")) << text;
  const drive::Session session = opened(made, folder.path());
  ASSERT_EQ(session.world_from_ins.size(), samples_->size());
  const Eigen::Vector3d is = session.world_from_ins.back().pose.translation() -
                             session.world_from_ins.front().pose.translation(),
                        was = samples_->back().world_from_ins.translation() -
                              samples_->front().world_from_ins.translation();
  EXPECT_NEAR(is.x(), was.y(), 1e-6);
  EXPECT_NEAR(is.y(), was.x(), 1e-6);
}

TEST_F(table_import, wrong_choices_are_seen_in_the_check_of_what_they_are_about) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  write_rows(folder.path() / "motion.csv", "time,temp" + std::string(kGeodeticHead),
             [](std::size_t i, const WrittenSample& sample) {
               Fields row = joined({seconds_text(sample.ins.stamp_ns), "12000"}, geodetic(sample));
               if (i == 40) row[3] = "broken";
               return row;
             });
  const ImportData data = look(folder.path());
  ASSERT_TRUE(data.table);
  const auto with = [&](auto change) {
    ImportChoice choice = untouched(data);
    change(choice.choices);
    return checked(data, choice);
  };
  const ImportChecks as_is = with([](TableChoices&) {});
  EXPECT_EQ(verdict(as_is, CheckKind::Rows), Verdict::Doubtful);
  EXPECT_EQ(as_is.samples + 1, samples_->size());
  EXPECT_TRUE(formats::contains(said(as_is), "42")) << "the line is named: " << said(as_is);
  EXPECT_EQ(verdict(with([](TableChoices& c) { c.attitude = AttitudeStyle::EnuYaw; }), CheckKind::Heading),
            Verdict::Bad);
  EXPECT_EQ(verdict(with([](TableChoices& c) { c.negated[1] = true; }), CheckKind::Pitch), Verdict::Bad);
  EXPECT_EQ(verdict(with([](TableChoices& c) { c.attitude = AttitudeStyle::NovAtel; }), CheckKind::Heading),
            Verdict::Good)
      << "the same angles for other axes";
  EXPECT_EQ(
      verdict(with([&](TableChoices& c) { give_role(data.table->table, c, column(data, "temp"), ColumnRole::Height); }),
              CheckKind::Height),
      Verdict::Bad);
  EXPECT_EQ(verdict(with([](TableChoices& c) { c.time_unit_ns = 1'000'000; }), CheckKind::Rate), Verdict::Bad);
  const ImportChecks later = with([](TableChoices& c) { c.offset_ns = 18'000'000'000; });
  EXPECT_EQ(verdict(later, CheckKind::Clock), Verdict::Doubtful) << said(later);
  const ImportChecks gps = with([](TableChoices& c) { c.time_scale = formats::TimeScale::Gps; });
  EXPECT_EQ(verdict(gps, CheckKind::Clock), Verdict::Bad) << said(gps);
}

TEST_F(table_import, what_the_check_of_the_clocks_advises_makes_it_pass) {
  for (const double off_s : {18.0, -18.0, 3600.0, -7200.0}) {
    const formats::TemporaryFolder folder;
    write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
    write_rows(folder.path() / "motion.csv", "time" + std::string(kGeodeticHead),
               [off_s](std::size_t, const WrittenSample& sample) {
                 const std::int64_t off_ns = std::llround(off_s * 1e9);
                 return joined({seconds_text(sample.ins.stamp_ns + off_ns)}, geodetic(sample));
               });
    const ImportData data = look(folder.path());
    ASSERT_TRUE(data.table);
    ImportChoice choice = untouched(data);
    const ImportChecks before = checked(data, choice);
    EXPECT_NE(verdict(before, CheckKind::Clock), Verdict::Good) << off_s;
    const auto& evidence = before.find(CheckKind::Clock)->evidence;
    const auto advice = std::ranges::find(evidence, "guess-clock-together", &Message::code);
    ASSERT_NE(advice, evidence.end()) << said(before);
    std::cout << english(*advice) << "\n";
    const double added_s = std::get<remount::Quantity>(advice->argument("added")->value).value;
    EXPECT_EQ(added_s, -off_s);
    choice.choices.offset_ns = std::llround(added_s * 1e9);
    const ImportChecks after = checked(data, choice);
    EXPECT_EQ(verdict(after, CheckKind::Clock), Verdict::Good) << said(after);
  }
}

TEST_F(table_import, fixes_that_are_held_for_several_rows_are_no_faster) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  const auto write_held = [&](std::size_t rows_a_fix, const std::string& head) {
    write_rows(folder.path() / "motion.csv", head, [&](std::size_t i, const WrittenSample& sample) {
      const WrittenSample& held = (*samples_)[i / rows_a_fix * rows_a_fix];
      Fields row = joined({seconds_text(sample.ins.stamp_ns)}, geodetic(sample));
      for (std::size_t k = 1; k <= 3; ++k) row[k] = place_deg(held)[k - 1];
      return row;
    });
  };
  const auto fastest_mps = [](const ImportChecks& checks) {
    const Message& evidence = checks.find(CheckKind::Position)->evidence.front();
    return std::get<remount::Quantity>(evidence.argument("speed")->value).value;
  };
  double every_row_mps = 0.0;
  for (const std::size_t rows_a_fix : {1U, 20U, 100U}) {
    write_held(rows_a_fix, "time" + std::string(kGeodeticHead));
    const ImportData data = look(folder.path());
    const ImportChecks checks = checked(data, untouched(data));
    std::cout << rows_a_fix << " rows a fix: at most " << fastest_mps(checks) << " m/s\n";
    EXPECT_EQ(verdict(checks, CheckKind::Position), Verdict::Good) << said(checks);
    if (rows_a_fix == 1) every_row_mps = fastest_mps(checks);
    EXPECT_NEAR(fastest_mps(checks), every_row_mps, 0.1 * every_row_mps);
  }
  write_held(20, "");
  const ImportData nameless = look(folder.path());
  ASSERT_TRUE(nameless.description.ins) << "by how its columns move";
  EXPECT_FALSE(nameless.description.ins->layout.metric_position);
}

TEST_F(table_import, an_offset_of_the_clock_is_kept_in_the_manifest) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  write_metric(folder.path() / "motion.csv");
  const ImportData data = look(folder.path());
  ImportChoice choice = untouched(data);
  choice.choices.offset_ns = -250'000'000;
  const drive::Session session = opened(description_of(data.description, choice, checked(data, choice)), folder.path());
  EXPECT_EQ(session.world_from_ins.front().stamp_ns, samples_->front().ins.stamp_ns - 250'000'000);
}

TEST_F(table_import, roles_take_along_what_goes_with_them) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  write_metric(folder.path() / "motion.csv");
  const ImportData data = look(folder.path());
  TableChoices choices = data.table->preset;
  give_role(data.table->table, choices, column(data, "x"), ColumnRole::Latitude);
  EXPECT_FALSE(choices.metric());
  std::vector<Message> lacks;
  EXPECT_FALSE(layout_of(data.table->table, choices, lacks));
  ASSERT_EQ(lacks.size(), 1U);
  EXPECT_TRUE(formats::contains(english(lacks[0]), "longitude")) << english(lacks[0]);
  give_role(data.table->table, choices, column(data, "roll"), ColumnRole::Qx);
  EXPECT_EQ(choices.attitude, AttitudeStyle::QuaternionEnu);
  EXPECT_FALSE(choices.has(ColumnRole::Yaw));
  give_role(data.table->table, choices, column(data, "z"), ColumnRole::Week);
  EXPECT_EQ(choices.time_scale, formats::TimeScale::Gps);
  choices.time_scale = formats::TimeScale::Unix;
  lacks.clear();
  EXPECT_FALSE(layout_of(data.table->table, choices, lacks));
  EXPECT_TRUE(says(lacks, "import-week-needs-gps"));
}

TEST_F(table_import, columns_that_are_chosen_by_hand_are_read_in_the_units_of_their_titles) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  write_rows(folder.path() / "motion.csv", "when (ms),p [rad],q [rad],r (m),a(rad),b(rad),c(rad),speed (km/h)\n",
             [](std::size_t, const WrittenSample& sample) {
               const drive::AttitudeAngles angles = heading_angles(sample);
               return Fields{std::to_string(sample.ins.stamp_ns / 1'000'000),
                             number(sample.ins.latitude_rad),
                             number(sample.ins.longitude_rad),
                             number(sample.ins.height_m),
                             number(angles.roll_rad),
                             number(angles.pitch_rad),
                             number(angles.yaw_rad),
                             "21.5"};
             });
  const ImportData data = look(folder.path());
  ASSERT_TRUE(data.table);
  ImportChoice choice = untouched(data);
  choice.choices = {};  // degrees, seconds
  choice.choices.roles.assign(8, ColumnRole::Ignored);
  constexpr std::array kRoles{ColumnRole::Time, ColumnRole::Latitude, ColumnRole::Longitude, ColumnRole::Height,
                              ColumnRole::Roll, ColumnRole::Pitch,    ColumnRole::Yaw};
  for (std::size_t i = 0; i < kRoles.size(); ++i) give_role(data.table->table, choice.choices, i, kRoles[i]);
  EXPECT_EQ(choice.choices.time_unit_ns, 1'000'000);
  EXPECT_FALSE(choice.choices.position_in_deg);
  EXPECT_FALSE(choice.choices.attitude_in_deg);
  const ImportChecks checks = checked(data, choice);
  for (const ImportCheck& check : checks.checks)
    EXPECT_TRUE(check.verdict == Verdict::Good || check.verdict == Verdict::NotTold) << said(checks);

  choice.choices.position_in_deg = true;
  const ImportChecks degrees = checked(data, choice);
  EXPECT_TRUE(formats::contains(said(degrees), "the title of p [rad] states \"rad\", and it is read in \"deg\""))
      << said(degrees);
  EXPECT_EQ(verdict(degrees, CheckKind::Position), Verdict::Doubtful);
  choice.choices.position_in_deg = false;
  give_role(data.table->table, choice.choices, column(data, "speed (km/h)"), ColumnRole::Height);
  const ImportChecks speed = checked(data, choice);
  EXPECT_TRUE(formats::contains(said(speed), "states \"km/h\", and it is read in \"m\"")) << said(speed);
  EXPECT_EQ(verdict(speed, CheckKind::Height), Verdict::Doubtful);
}

TEST_F(table_import, a_time_that_is_a_text_is_read_as_a_date) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  write_rows(folder.path() / "motion.csv", "at,other" + std::string(kGeodeticHead),
             [](std::size_t, const WrittenSample& sample) {
               return joined({formats::format_date_ns(sample.ins.stamp_ns), seconds_text(sample.ins.stamp_ns)},
                             geodetic(sample));
             });
  const ImportData data = look(folder.path());
  ASSERT_TRUE(data.table);
  ImportChoice choice = untouched(data);
  for (const std::string title : {"other", "at", "other", "at"}) {
    give_role(data.table->table, choice.choices, column(data, title), ColumnRole::Time);
    EXPECT_EQ(choice.choices.time_unit_ns, title == "at" ? 0 : 1'000'000'000) << title;
    EXPECT_EQ(checked(data, choice).samples, samples_->size()) << said(checked(data, choice));
  }
}

TEST_F(table_import, scans_that_are_left_out_are_not_in_the_manifest) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  write_metric(folder.path() / "motion.csv");
  const ImportData data = look(folder.path());
  ImportChoice choice = untouched(data);
  choice.left_out = {0};
  const ImportChecks checks = checked(data, choice);
  EXPECT_EQ(verdict(checks, CheckKind::Clock), Verdict::NotTold);
  const Description made = description_of(data.description, choice, checks);
  EXPECT_TRUE(made.lidars.empty());
  EXPECT_TRUE(says(made.missing, "guess-needs-lidar"));
}

TEST_F(table_import, a_table_of_names_that_nobody_knows_is_imported_by_hand) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  write_rows(folder.path() / "motion.csv", "a,b,c,d,e,f,g\n", [](std::size_t, const WrittenSample& sample) {
    const drive::AttitudeAngles angles = heading_angles(sample);
    const Fields place = place_deg(sample);
    return Fields{degrees_text(angles.roll_rad),
                  place[2],
                  degrees_text(angles.yaw_rad),
                  place[0],
                  degrees_text(angles.pitch_rad),
                  seconds_text(sample.ins.stamp_ns),
                  place[1]};
  });
  const ImportData data = look(folder.path());
  ASSERT_TRUE(data.table);
  ImportChoice choice = untouched(data);
  choice.choices.roles.assign(choice.choices.roles.size(), ColumnRole::Ignored);  // whatever was guessed
  EXPECT_EQ(checked(data, choice).samples, 0U);
  constexpr std::array kRoles{ColumnRole::Roll,  ColumnRole::Height, ColumnRole::Yaw,      ColumnRole::Latitude,
                              ColumnRole::Pitch, ColumnRole::Time,   ColumnRole::Longitude};
  for (std::size_t i = 0; i < kRoles.size(); ++i) give_role(data.table->table, choice.choices, i, kRoles[i]);
  choice.choices.attitude = AttitudeStyle::Heading;
  choice.choices.attitude_in_deg = choice.choices.position_in_deg = true;
  const ImportChecks checks = checked(data, choice);
  EXPECT_EQ(verdict(checks, CheckKind::Heading), Verdict::Good) << said(checks);
  const drive::Session session = opened(description_of(data.description, choice, checks), folder.path());
  const double apart = motions_apart(session, *session_);
  std::cout << "motions " << apart << " apart\n";
  EXPECT_LT(apart, kTextPrecision);
}

TEST_F(table_import, no_manifest_is_made_of_a_table_that_gives_no_motion) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  write_metric(folder.path() / "motion.csv");
  const ImportData data = look(folder.path());
  ImportChoice choice = untouched(data);
  EXPECT_TRUE(description_to_save(data.description, choice, Progress())->ins);
  give_role(data.table->table, choice.choices, column(data, "t"), ColumnRole::Ignored);
  EXPECT_THROW((void)description_to_save(data.description, choice, Progress()), Error);
  folder.write("motion.csv", "only,a,head\n");
  EXPECT_THROW((void)description_to_save(data.description, untouched(data), Progress()), Error)
      << "it was changed since";
}

TEST_F(table_import, poses_of_a_lidar_that_are_chosen_as_those_of_the_ins_are_not_both) {
  const formats::TemporaryFolder folder;
  const auto write_poses = [&](const char* name, const std::vector<WrittenSample>& samples) {
    std::ofstream out(folder.path() / name);
    for (const WrittenSample& sample : samples) {
      const Eigen::Vector3d place = sample.world_from_ins.translation();
      const Eigen::Quaterniond turn(sample.world_from_ins.linear());
      out << seconds_text(sample.ins.stamp_ns);
      for (const double value : {place.x(), place.y(), place.z(), turn.x(), turn.y(), turn.z(), turn.w()})
        out << ' ' << number(value);
      out << "\n";
    }
  };
  write_poses("a.tum", *samples_);
  write_poses("b.tum", *samples_);
  const ImportData data = look(folder.path());
  ASSERT_EQ(data.description.lidars.size(), 1U);
  const fs::path lidar = data.description.lidars.front().directory;
  ASSERT_NE(std::ranges::find(data.tables, lidar), data.tables.end());
  ImportChoice choice;
  choice.table = import_table(lidar, data.description, Progress());
  choice.choices = choice.table->preset;
  const ImportChecks checks = check_choice(data.description, choice, Progress());
  EXPECT_EQ(verdict(checks, CheckKind::Clock), Verdict::NotTold) << "there are no others' times";
  const Description made = description_of(data.description, choice, checks);
  ASSERT_TRUE(made.ins);
  EXPECT_EQ(made.ins->file, lidar);
  EXPECT_TRUE(made.lidars.empty());
  EXPECT_TRUE(says(made.missing, "guess-needs-lidar"));
}

TEST_F(table_import, cancelled_checks_say_nothing) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  write_metric(folder.path() / "motion.csv");
  const ImportData data = look(folder.path());
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(checked(data, untouched(data)).samples, samples_->size());
  const ImportChecks checks = check_choice(data.description, untouched(data), Progress(stop.get_token()));
  EXPECT_EQ(checks.samples, 0U);
  EXPECT_TRUE(checks.checks.empty()) << said(checks);
  EXPECT_FALSE(description_to_save(data.description, untouched(data), Progress(stop.get_token())));
}

}  // namespace
}  // namespace remount::guesses
