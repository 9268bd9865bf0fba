#include "model/fleet/fleet_history.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "algorithms/messages/render.h"
#include "messages/rig.h"
#include "model/fleet/fleet_table.h"
#include "remount_version.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/built_vehicle.h"

namespace remount::fleet {
namespace {

using testing::as_built, testing::Mountings;

/// A vehicle with three LiDARs, whose jobs have results that the test writes.
class fleet_history : public ::testing::Test {
 protected:
  void SetUp() override { read("lidars: all, last: before.yaml"); }

  void read(const std::string& keys) {
    std::ofstream(folder_.path() / "fleet.yaml")
        << "format: remount-fleet/1\nvehicles: [{name: bus 12, sessions: [mon, tue, wed], " << keys << "}]\n";
    fleet_ = load_fleet(folder_.path() / "fleet.yaml");
  }
  static results::VehicleFile with(const Mountings& mountings) {
    results::VehicleFile file = testing::vehicle_with("", mountings).file;
    file.version = kVersion;
    for (results::LidarResult& lidar : file.lidars) lidar.file.version = kVersion;
    return file;
  }
  void make(std::size_t job, const results::VehicleFile& file) {
    make_job_folder(fleet_.jobs[job]);
    results::save_vehicle(file, fleet_.jobs[job].result);
  }
  void make_one(std::size_t job, const RigidTransform& ins_from_lidar) {
    make_job_folder(fleet_.jobs[job]);
    results::save_result(with({{"", ins_from_lidar}}).lidars.front().file, fleet_.jobs[job].result);
  }
  static const FleetRow& row_of(const std::vector<FleetRow>& rows, std::size_t job, const std::string& lidar) {
    for (const FleetRow& row : rows)
      if (row.job == job && row.lidar == lidar) return row;
    throw std::out_of_range(lidar);
  }
  std::string alarms(const std::vector<FleetRow>& rows) const {
    std::string text;
    for (const FleetAlarm& alarm : fleet_alarms(fleet_, rows)) text += alarm.title + ": " + english(alarm.words) + "\n";
    return text;
  }

  formats::TemporaryFolder folder_;
  Fleet fleet_;
};

/// All LiDARs as a vehicle has them whose INS was moved.
Mountings under_a_moved_ins(const RigidTransform& moved_from_ins) {
  Mountings mountings = as_built();
  for (auto& [name, ins_from_lidar] : mountings) ins_from_lidar = moved_from_ins * ins_from_lidar;
  return mountings;
}

TEST_F(fleet_history, each_lidar_is_compared_by_its_name) {
  results::save_vehicle(with(as_built()), folder_.path() / "before.yaml");
  Mountings later = as_built();
  later["rear"].translation().x() += 0.05;
  make(0, with(as_built()));
  make(1, with(later));
  const std::vector<FleetRow> rows = fleet_rows(fleet_);
  ASSERT_EQ(rows.size(), 7U) << "a row a LiDAR, and one for the job that waits";
  EXPECT_EQ(rows[0].lidar, "front");
  EXPECT_EQ(rows[0].last.since, "before.yaml");
  EXPECT_EQ(rows[6].lidar, "");
  EXPECT_EQ(rows[6].state, JobState::Waiting);
  const FleetRow& rear = row_of(rows, 1, "rear");
  EXPECT_EQ(rear.last.since, "mon");
  EXPECT_NEAR(rear.last.change.difference[calibration::Parameter::X], 0.05, 1e-12);
  EXPECT_EQ(rear.reference.since, "before.yaml");
  EXPECT_EQ(english(row_of(rows, 1, "front").drift()), "");
  EXPECT_TRUE(rear.together().empty());
  EXPECT_EQ(english(fleet_counts(rows)), "3 jobs: 2 solved, 1 waiting; drift in 1");
  const std::string said = alarms(rows);
  EXPECT_EQ(said.find("bus 12, tue, rear: x has changed by +0.0500 m"), 0U) << said;
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
}

TEST_F(fleet_history, what_all_lidars_have_in_common_is_said_to_be_the_ins) {
  const RigidTransform moved_from_ins = rigid_from_six({0.03, -0.04, 0.03, degrees_to_radians(0.5), 0.0, 0.0});
  make(0, with(as_built()));
  make(1, with(under_a_moved_ins(moved_from_ins)));
  Mountings both = under_a_moved_ins(moved_from_ins);
  for (auto& [name, ins_from_lidar] : both) ins_from_lidar = moved_from_ins * ins_from_lidar;
  both["roof"] = both["roof"] * rigid_from_six({0.0, 0.0, 0.0, 0.03, 0.0, 0.0});
  make(2, with(both));
  read("lidars: all");
  const std::vector<FleetRow> rows = fleet_rows(fleet_);
  const std::string said = alarms(rows);
  std::printf("%s", said.c_str());
  for (const char* lidar : {"front", "rear", "roof"}) {
    EXPECT_EQ(said.find(std::string("bus 12, tue, ") + lidar + ": "), std::string::npos)
        << "the alarm of the INS is theirs: " << said;
    EXPECT_NE(english(row_of(rows, 1, lidar).drift()), "") << "the table has it";
    EXPECT_EQ(english(row_of(rows, 1, lidar).last.words).find("the LiDAR was moved"), std::string::npos);
    EXPECT_NE(english(row_of(rows, 1, lidar).last.together).find("since mon: All LiDARs sit against each other"),
              std::string::npos);
  }
  EXPECT_NE(said.find("bus 12, tue: since mon: All LiDARs sit against each other as before"), std::string::npos)
      << said;
  EXPECT_NE(said.find("bus 12, wed: since tue: Most LiDARs sit against each other as before"), std::string::npos)
      << said;
  EXPECT_NE(said.find("and roof moved as well"), std::string::npos) << said;
  EXPECT_NE(said.find("bus 12, wed: since mon: Most LiDARs"), std::string::npos) << "since the reference: " << said;
  EXPECT_NE(said.find("bus 12, wed, roof: "), std::string::npos) << said;
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 4) << "each once: " << said;
  const std::string text = fleet_text(fleet_, rows), html = fleet_html(fleet_, rows, "now");
  EXPECT_NE(text.find("\n    since mon: All LiDARs"), std::string::npos) << text;
  EXPECT_NE(html.find("bus 12, tue: since mon: All LiDARs"), std::string::npos) << html;
}

TEST_F(fleet_history, what_a_result_warns_of_is_counted_and_its_problems_are_named) {
  results::VehicleFile file = with(as_built());
  file.lidars[0].file.findings = {{drive::Severity::Note, "a-note", std::string("x"), {}},
                                  {drive::Severity::Warning, "a-warning", std::string("x"), {}}};
  file.findings = {{drive::Severity::Problem, "lidars-contradict", std::string("front"),
                    say::rig_contradicts("rear", Length{0.012}, Angle{0.001}, 5.3)}};
  read("lidars: all");
  make(0, file);
  const std::vector<FleetRow> rows = fleet_rows(fleet_);
  EXPECT_EQ(row_of(rows, 0, "front").warnings.count, 2U);
  EXPECT_EQ(row_of(rows, 0, "rear").warnings.count, 0U);
  const JobWarnings all = warnings_in(file);
  EXPECT_EQ(all.count, 2U);
  ASSERT_EQ(all.problems.size(), 1U);
  EXPECT_EQ(name_of_problem(all.problems[0]), "front [lidars-contradict]");
  const std::string text = fleet_text(fleet_, rows), html = fleet_html(fleet_, rows, "now"),
                    csv = fleet_csv(fleet_, rows);
  EXPECT_NE(text.find("2 warnings\n"), std::string::npos) << text;
  EXPECT_NE(text.find("PROBLEM: front: what it and rear saw"), std::string::npos) << text;
  EXPECT_NE(text.find("1 of them with problems"), std::string::npos) << text;
  EXPECT_NE(html.find("<tr class=\"problem\">"), std::string::npos) << html;
  EXPECT_NE(html.find("[lidars-contradict]"), std::string::npos) << html;
  EXPECT_NE(csv.find(",warnings,problems\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find("[lidars-contradict]"), std::string::npos) << csv;
}

TEST_F(fleet_history, what_is_said_of_all_lidars_is_in_the_row_of_each) {
  results::VehicleFile file = with(as_built());
  file.findings = {{drive::Severity::Problem, "vehicle-drives-contradict", say::rig_all_lidars(),
                    say::rig_all_moved_between_drives()}};
  read("lidars: all");
  make(0, file);
  const std::vector<FleetRow> rows = fleet_rows(fleet_);
  for (const char* lidar : {"front", "rear"}) EXPECT_EQ(row_of(rows, 0, lidar).warnings.problems.size(), 1U) << lidar;
}

TEST_F(fleet_history, lidars_that_moved_on_their_own_or_too_little_are_not_the_ins) {
  Mountings later = as_built();
  for (auto& [name, ins_from_lidar] : later) ins_from_lidar = ins_from_lidar * rigid_from_six({0.1, 0, 0, 0, 0, 0});
  read("lidars: all");
  make(0, with(as_built()));
  make(1, with(later));
  EXPECT_EQ(alarms(fleet_rows(fleet_)).find("since mon: "), std::string::npos);
  // Certain, but less than is asked to be told of.
  make(1, with(under_a_moved_ins(rigid_from_six({0.019, -0.019, 0.019, 0.0, 0.0, 0.0}))));
  const std::vector<FleetRow> rows = fleet_rows(fleet_);
  EXPECT_EQ(alarms(rows), "");
  EXPECT_TRUE(rows[3].together().empty());
}

TEST_F(fleet_history, a_lidar_without_a_usable_result_is_passed_over_and_says_why) {
  results::VehicleFile without = with(as_built());
  without.lidars[1].joined = without.lidars[2].joined = false;
  without.lidars[1].file.result.status = calibration::Status::TooFewPairs;
  without.findings = {{drive::Severity::Warning, std::string(results::kLidarLeftOut), std::string("rear"),
                       say::rig_left_out(Message::verbatim("Too few pairs."))},
                      {drive::Severity::Problem, std::string(results::kLidarLeftOut), std::string("roof"),
                       say::rig_moved_between_drives(9.0)}};
  Mountings later = as_built();
  later["rear"].translation().y() += 0.1;
  read("lidars: [front, rear, roof]");
  make(0, with(as_built()));
  make(1, without);
  make(2, with(later));
  const std::vector<FleetRow> rows = fleet_rows(fleet_);
  ASSERT_EQ(rows.size(), 9U);
  EXPECT_NE(english(row_of(rows, 1, "rear").message).find("not usable: Too few pairs."), std::string::npos);
  EXPECT_NE(english(row_of(rows, 1, "roof").message).find("its drives contradict each other"), std::string::npos);
  EXPECT_EQ(row_of(rows, 2, "front").last.since, "tue");
  EXPECT_EQ(row_of(rows, 2, "rear").last.since, "mon") << "the one in between has nothing to use";
  EXPECT_NE(alarms(rows).find("bus 12, wed, rear: y has changed by +0.1000 m"), std::string::npos) << alarms(rows);
  EXPECT_EQ(english(fleet_counts(rows)),
            "3 jobs: 2 solved, 1 without a usable result, 1 of them with problems; drift in 1");

  const std::string csv = fleet_csv(fleet_, rows);
  EXPECT_NE(csv.find(",rear,no,"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",front,yes,no,no,0,\n"), std::string::npos) << csv;
  const std::string html = fleet_html(fleet_, rows, "now");
  EXPECT_NE(html.find("<th class=\"text\">LiDAR</th>"), std::string::npos);
  EXPECT_NE(html.find("<td class=\"text\">tue</td><td class=\"text\">rear</td><td class=\"text\">too_few_pairs</td>"),
            std::string::npos)
      << html;
}

TEST_F(fleet_history, results_from_before_that_do_not_hold_the_lidar_are_told) {
  Mountings fewer = as_built();
  fewer.erase("roof");
  results::save_vehicle(with(fewer), folder_.path() / "before.yaml");
  make(0, with(as_built()));
  make(1, with(as_built()));
  std::vector<FleetRow> rows = fleet_rows(fleet_);
  EXPECT_NE(english(row_of(rows, 0, "roof").last.words).find("no LiDAR called roof, but front, rear"),
            std::string::npos)
      << english(row_of(rows, 0, "roof").last.words);
  EXPECT_EQ(row_of(rows, 1, "roof").reference.since, "mon") << "the oldest that is known of this one";
  EXPECT_EQ(row_of(rows, 1, "rear").reference.since, "before.yaml");
  // A reference is named on purpose: no other takes its place.
  read("lidars: all, reference: before.yaml");
  rows = fleet_rows(fleet_);
  EXPECT_EQ(row_of(rows, 1, "roof").reference.since, "");
  EXPECT_NE(english(row_of(rows, 1, "roof").reference.words).find("no LiDAR called roof"), std::string::npos);

  results::save_result(with({{"", RigidTransform::Identity()}}).lidars.front().file, folder_.path() / "before.yaml");
  EXPECT_NE(english(fleet_rows(fleet_)[0].reference.words).find("is the result of one LiDAR, which has no name"),
            std::string::npos);
  results::save_vehicle(with(as_built()), folder_.path() / "before.yaml");
  read("last: before.yaml");
  make_one(0, as_built()["front"]);
  EXPECT_NE(english(fleet_rows(fleet_)[0].last.words).find("the job is of one without a name"), std::string::npos);
}

TEST_F(fleet_history, results_of_one_lidar_from_before_are_given_by_its_name) {
  const auto save = [&](const char* lidar, const RigidTransform& ins_from_lidar) {
    results::save_result(with({{"", ins_from_lidar}}).lidars.front().file,
                         folder_.path() / (std::string(lidar) + ".yaml"));
  };
  save("front", rigid_from_six({0.03, 0.0, 0.0, 0.0, 0.0, 0.0}) * as_built()["front"]);
  save("rear", as_built()["rear"]);
  Mountings built = as_built();
  make(0, with(built));
  built["rear"].translation().z() += 0.5;
  results::save_vehicle(with(built), folder_.path() / "fitted.yaml");
  read("lidars: all, last: {front: front.yaml, rear: rear.yaml}, reference: {rear: fitted.yaml}");
  const std::vector<FleetRow> rows = fleet_rows(fleet_);
  EXPECT_EQ(row_of(rows, 0, "front").last.since, "front.yaml");
  EXPECT_NEAR(row_of(rows, 0, "front").last.change.difference[calibration::Parameter::X], -0.03, 1e-9);
  EXPECT_EQ(row_of(rows, 0, "front").reference.since, "front.yaml") << "no reference of this one is named";
  EXPECT_EQ(row_of(rows, 0, "rear").last.since, "rear.yaml");
  EXPECT_EQ(row_of(rows, 0, "rear").reference.since, "fitted.yaml") << "of a vehicle's that of its name";
  EXPECT_NEAR(row_of(rows, 0, "rear").reference.change.difference[calibration::Parameter::Z], -0.5, 1e-9);
  EXPECT_EQ(row_of(rows, 0, "roof").last.since, "");
  EXPECT_TRUE(row_of(rows, 0, "roof").last.words.empty());
}

TEST_F(fleet_history, a_result_of_other_lidars_is_out_of_date) {
  make(0, with(as_built()));
  make_one(1, as_built()["front"]);
  const auto message = [&](std::size_t job) {
    for (const FleetRow& row : fleet_rows(fleet_))
      if (row.job == job) return std::string(to_string(row.state)) + ": " + english(row.message);
    return std::string();
  };
  EXPECT_EQ(message(0).find("done: "), 0U) << message(0);
  EXPECT_EQ(message(1), "out of date: LiDARs: all; before: one");
  read("lidars: [front, rear]");
  EXPECT_EQ(message(0), "out of date: LiDARs: front, rear; before: front, rear, roof");
  read("lidars: null");
  EXPECT_EQ(message(0), "out of date: LiDARs: one; before: front, rear, roof");
  EXPECT_EQ(message(1).find("done: "), 0U) << message(1);
  std::printf("%s\n", message(0).c_str());
}

TEST_F(fleet_history, a_table_of_vehicles_with_one_lidar_looks_as_before) {
  read("settings: {}");
  make_one(0, as_built()["front"]);
  const std::vector<FleetRow> rows = fleet_rows(fleet_);
  EXPECT_EQ(fleet_html(fleet_, rows, "now").find("LiDAR</th>"), std::string::npos);
  EXPECT_NE(fleet_csv(fleet_, rows).find(",,,,\n"), std::string::npos) << "columns for LiDARs are empty";
  EXPECT_EQ(fleet_text(fleet_, rows).find("1  bus 12, mon: ok"), 0U) << fleet_text(fleet_, rows);
}

}  // namespace
}  // namespace remount::fleet
