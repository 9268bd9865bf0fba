#include "model/guesses/import_checks.h"

#include <gtest/gtest.h>

#include <iostream>

#include "tests/model/guesses/imported_table.h"

namespace remount::guesses {
namespace {

using import_checks = ImportedTable;

TEST_F(import_checks, checks_of_the_guess_are_good) {
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

TEST_F(import_checks, wrong_choices_are_seen_in_the_check_of_what_they_are_about) {
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

TEST_F(import_checks, what_the_check_of_the_clocks_advises_makes_it_pass) {
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
    ASSERT_TRUE(before.find(CheckKind::Clock)->added_ns);
    EXPECT_EQ(*before.find(CheckKind::Clock)->added_ns, std::llround(added_s * 1e9));
    choice.choices.offset_ns = *before.find(CheckKind::Clock)->added_ns;
    const ImportChecks after = checked(data, choice);
    EXPECT_EQ(verdict(after, CheckKind::Clock), Verdict::Good) << said(after);
  }
}

TEST_F(import_checks, fixes_that_are_held_for_several_rows_are_no_faster) {
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

TEST_F(import_checks, columns_that_are_chosen_by_hand_are_read_in_the_units_of_their_titles) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  write_rows(folder.path() / "motion.csv", "when (ms),p [rad],q [rad],r [local],a(rad),b(rad),c(rad),speed (km/h)\n",
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
  EXPECT_EQ(choice.choices.position_unit, formats::PlaceUnit::Radians);
  EXPECT_FALSE(choice.choices.attitude_in_deg);
  const ImportChecks checks = checked(data, choice);
  for (const ImportCheck& check : checks.checks)
    EXPECT_TRUE(check.verdict == Verdict::Good || check.verdict == Verdict::NotTold) << said(checks);

  choice.choices.position_unit = formats::PlaceUnit::Degrees;
  const ImportChecks degrees = checked(data, choice);
  EXPECT_TRUE(formats::contains(said(degrees), "the title of p [rad] states \"rad\", and it is read in \"deg\""))
      << said(degrees);
  EXPECT_EQ(verdict(degrees, CheckKind::Position), Verdict::Doubtful);
  choice.choices.position_unit = formats::PlaceUnit::Radians;
  give_role(data.table->table, choice.choices, column(data, "speed (km/h)"), ColumnRole::Height);
  const ImportChecks speed = checked(data, choice);
  EXPECT_TRUE(formats::contains(said(speed), "states \"km/h\", and it is read in \"m\"")) << said(speed);
  EXPECT_EQ(verdict(speed, CheckKind::Height), Verdict::Doubtful);
}

TEST_F(import_checks, a_time_that_is_a_text_is_read_as_a_date) {
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

TEST_F(import_checks, cancelled_checks_say_nothing) {
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
