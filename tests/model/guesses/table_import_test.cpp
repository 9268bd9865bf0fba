#include "model/guesses/table_import.h"

#include <gtest/gtest.h>

#include <iostream>

#include "tests/model/guesses/imported_table.h"

namespace remount::guesses {
namespace {

namespace fs = std::filesystem;

using table_import = ImportedTable;

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
  choice.choices.attitude_in_deg = true;
  choice.choices.position_unit = formats::PlaceUnit::Degrees;
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

TEST_F(table_import, poses_of_a_lidar_are_offered_only_to_whoever_asks_for_them) {
  const formats::TemporaryFolder folder;
  std::ofstream out(folder.path() / "odometry.tum");
  for (int i = 0; i < 300; ++i)  // keeps to no direction of travel
    out << number(1'700'000'000.0 + 0.1 * i) << ' ' << number(0.5 * i) << ' ' << number(3.0 * std::sin(0.1 * i))
        << " 0 " << number(std::sin(0.37 * i)) << " 0 0 " << number(std::cos(0.37 * i)) << "\n";
  out.close();
  const ImportData data = look(folder.path());
  ASSERT_FALSE(data.description.ins);
  ASSERT_EQ(data.description.lidars.size(), 1U);
  EXPECT_TRUE(is_of_lidar(data.description, folder.path() / "odometry.tum"));
  ASSERT_EQ(data.tables.size(), 1U);
  EXPECT_FALSE(data.table) << "nobody asked for it";
  Progress progress;
  const ImportData meant = look_for_import({folder.path()}, progress, folder.path() / "odometry.tum");
  ASSERT_TRUE(meant.table);
  EXPECT_EQ(meant.table->file, folder.path() / "odometry.tum");
  const ImportChoice choice = untouched(meant);
  EXPECT_EQ(choice.choices.column(ColumnRole::Qw), 7U) << "as the format has it";
  EXPECT_EQ(checked(meant, choice).samples, 300U) << said(checked(meant, choice));
  const auto made = description_to_save(meant.description, choice, Progress());
  ASSERT_TRUE(made && made->ins);
  EXPECT_TRUE(formats::contains(manifest(*made, folder.path()), "format: tum")) << manifest(*made, folder.path());
}

}  // namespace
}  // namespace remount::guesses
