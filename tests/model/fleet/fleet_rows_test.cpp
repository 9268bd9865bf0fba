#include "model/fleet/fleet_rows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "algorithms/messages/render.h"
#include "messages/general.h"
#include "messages/sessions.h"
#include "model/fleet/failed_job.h"
#include "model/fleet/fleet_table.h"
#include "model/formats/files/csv_table.h"
#include "model/formats/files/input_file.h"
#include "model/results/result_file.h"
#include "remount_version.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::fleet {
namespace {

/// A vehicle whose jobs have results that the test writes.
class fleet_rows_of : public ::testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_.path() / "fleet.yaml")
        << "format: remount-fleet/1\ndrift: {sigmas: 3.5, translation_m: 0.02, rotation_deg: 0.2}\nvehicles:\n"
           "  - {name: \"bus, 12\", last: before.yaml, sessions: [mon, tue, wed]}\n"
           "  - {name: bus 13, sessions: [mon]}\n";
    fleet_ = load_fleet(folder_.path() / "fleet.yaml");
  }

  static results::ResultFile result(double x_m, double yaw_deg, double sigma) {
    results::ResultFile file;
    file.version = kVersion;
    file.ins_axes = drive::InsAxes::ForwardLeftUp;
    file.result.status = calibration::Status::Ok;
    file.result.mounting.reference_from_sensor =
        rigid_from_six({x_m, -0.2, 0.7, degrees_to_radians(yaw_deg), 0.0, 0.0});
    file.result.set_observed(calibration::ParameterSet::all(), {});
    file.result.covariance = sigma * sigma * Matrix6d::Identity();
    return file;
  }
  void make(std::size_t job, const results::ResultFile& file) {
    make_job_folder(fleet_.jobs[job]);
    results::save_result(file, fleet_.jobs[job].result);
  }

  formats::TemporaryFolder folder_;
  Fleet fleet_;
};

TEST_F(fleet_rows_of, a_change_is_drift_where_it_exceeds_both_the_combined_sigma_and_the_threshold) {
  results::save_result(result(1.0, 10.0, 0.001), folder_.path() / "before.yaml");
  make(0, result(1.015, 10.1, 0.001));  // 10.6 sigma, but below both thresholds
  make(1, result(1.115, 10.1, 0.05));   // 0.1 m, but 2 sigma
  make(2, result(1.215, 179.9, 0.001));
  const std::vector<FleetRow> rows = fleet_rows(fleet_);
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0].last.since, "before.yaml");
  EXPECT_NEAR(rows[0].last.change.difference[calibration::Parameter::X], 0.015, 1e-12);
  EXPECT_NEAR(rows[0].last.change.sigma[calibration::Parameter::X], 0.001 * std::sqrt(2.0), 1e-12);
  EXPECT_EQ(english(rows[0].last.drift), "") << "less than the threshold";
  EXPECT_EQ(rows[1].last.since, "mon");
  EXPECT_EQ(english(rows[1].last.drift), "") << "less than the sigmas allow";
  EXPECT_NE(english(rows[2].last.drift).find("yaw has changed by +169.8"), std::string::npos) << rows[2].last.drift;
  EXPECT_NE(english(rows[2].last.drift).find("since tue"), std::string::npos) << rows[2].last.drift;
  EXPECT_EQ(english(rows[2].last.drift).find("x has"), std::string::npos)
      << "0.1 m at a combined sigma of 0.05 m: " << rows[2].last.drift;
  EXPECT_EQ(rows[3].state, JobState::Waiting);
  EXPECT_EQ(rows[3].last.since, "") << "the vehicles are not compared with each other";
  std::printf("drift: %s\n", english(rows[2].last.drift).c_str());
}

TEST_F(fleet_rows_of, a_result_of_other_topics_is_out_of_date) {
  results::ResultFile front = result(1.0, 10.0, 0.001);
  front.topics = {{"mon", {{"lidar", "/front/points"}, {"ins", "/ins/imu"}}, {}}};
  make(0, front);
  make(1, result(1.0, 10.0, 0.001));
  const auto message = [&](std::size_t job, const drive::TopicChoice& topics) {
    fleet_.vehicles[0].topics = topics;
    const FleetRow row = fleet_rows(fleet_)[job];
    EXPECT_EQ(row.state == JobState::Done, english(row.message).empty()) << english(row.message);
    return english(row.message);
  };
  EXPECT_EQ(message(0, {}), "") << "suggested ones are known to the bag alone";
  EXPECT_EQ(message(0, {{"lidar", "/front/points"}, {"gnss", "none"}}), "");
  EXPECT_EQ(message(0, {{"lidar", "/rear/points"}}), "topics: lidar is /rear/points, it was /front/points");
  EXPECT_EQ(message(0, {{"gnss", "/fix"}}), "topics: gnss is /fix, it was none");
  EXPECT_EQ(message(0, {{"ins", "none"}}), "topics: ins is none, it was /ins/imu");
  EXPECT_EQ(message(1, {{"ins", "/ins/imu"}}), "the result does not say which topics it is of");
}

TEST_F(fleet_rows_of, what_is_not_usable_or_not_observed_is_passed_over) {
  make(0, result(1.0, 10.0, 0.001));
  results::ResultFile failed = result(9.0, 90.0, 0.001), flat = result(1.001, 70.0, 0.001);
  failed.result.status = calibration::Status::NotConverged;
  failed.result.message = Message::verbatim("It went in circles.");
  flat.result.status = calibration::Status::Degenerate;
  flat.result.withdraw(calibration::Parameter::Yaw, Message::verbatim("not shown by this drive"));
  flat.result.covariance.row(3).setConstant(std::nan(""));
  flat.result.covariance.col(3).setConstant(std::nan(""));
  make(1, failed);
  make(2, flat);
  std::ofstream(folder_.path() / "before.yaml") << "format: something else\n";
  const std::vector<FleetRow> rows = fleet_rows(fleet_);
  EXPECT_NE(english(rows[0].last.words).find("before.yaml:1"), std::string::npos) << rows[0].last.words;
  EXPECT_EQ(rows[1].state, JobState::Done);
  EXPECT_EQ(english(rows[1].message), "It went in circles.");
  EXPECT_EQ(english(rows[1].last.drift), "");
  EXPECT_EQ(rows[2].last.since, "mon") << "the one in between has nothing to use";
  EXPECT_NEAR(rows[2].last.change.difference[calibration::Parameter::X], 0.001, 1e-12);
  EXPECT_TRUE(std::isnan(rows[2].last.change.difference[calibration::Parameter::Yaw]));
  EXPECT_EQ(english(rows[2].last.drift), "") << "yaw is not observed";
}

TEST_F(fleet_rows_of, failures_damaged_results_and_other_settings_are_told_apart) {
  make(0, result(1.0, 10.0, 0.001));
  std::ofstream(fleet_.jobs[0].failure) << "tue/ins.csv: does not exist\n";
  make(1, result(1.0, 10.0, 0.001));
  std::filesystem::resize_file(fleet_.jobs[1].result, 300);
  results::ResultFile other = result(1.0, 10.0, 0.001), old = other;
  other.settings.pairing.max_gap_s = 7.0;
  make(2, other);
  old.version = "0.0.1";
  make(3, old);
  const std::vector<FleetRow> rows = fleet_rows(fleet_);
  EXPECT_EQ(rows[0].state, JobState::Failed);
  EXPECT_EQ(english(rows[0].message), "tue/ins.csv: does not exist");
  EXPECT_FALSE(rows[0].result) << "it is of what is no longer there";
  EXPECT_EQ(rows[1].state, JobState::Failed);
  EXPECT_NE(english(rows[1].message).find(fleet_.jobs[1].result.string()), std::string::npos)
      << english(rows[1].message);
  EXPECT_EQ(rows[2].state, JobState::OutOfDate);
  EXPECT_NE(english(rows[2].message).find("pairing.max_gap_s 7, now"), std::string::npos) << english(rows[2].message);
  EXPECT_EQ(rows[3].state, JobState::OutOfDate);
  EXPECT_NE(english(rows[3].message).find("0.0.1"), std::string::npos) << english(rows[3].message);
  EXPECT_EQ(english(fleet_counts(rows)), "4 jobs: 0 solved, 2 failed, 2 out of date; no drift");
}

// A failure belongs to what was asked for then: topics that were put right leave nothing of it.
TEST_F(fleet_rows_of, a_failure_from_before_a_change_counts_no_more) {
  const FleetJob& job = fleet_.jobs[3];
  FleetVehicle& vehicle = fleet_.vehicles[job.vehicle];
  vehicle.topics = {{"lidar", "/a"}};
  make_job_folder(job);
  note_failure(fleet_, job, Message::verbatim("/a: cannot serve as lidar\nsecond line"));
  ASSERT_TRUE(formats::is_file(job.failure));
  const auto row = [&] { return fleet_rows(fleet_)[3]; };
  EXPECT_EQ(row().state, JobState::Failed);
  EXPECT_EQ(english(row().message), "/a: cannot serve as lidar\nsecond line")
      << "what it was asked for is not part of it";
  EXPECT_EQ(failure_message(job), row().message);

  const auto expect_waits = [&](const std::string& why) {
    EXPECT_EQ(row().state, JobState::Waiting);
    EXPECT_EQ(english(row().message).find(why), 0U) << english(row().message);
    EXPECT_NE(english(row().message).find("before that it failed: /a: cannot serve as lidar"), std::string::npos);
    EXPECT_NE(fleet_text(fleet_, {row()}).find("waiting, " + why), std::string::npos) << fleet_text(fleet_, {row()});
  };
  vehicle.topics["lidar"] = "/b";
  expect_waits("topics: lidar is /b, it was /a");
  vehicle.topics.clear();
  expect_waits("topics: lidar is left to be suggested, it was /a");
  vehicle.topics = {{"lidar", "/a"}, {"gnss", "none"}};
  expect_waits("topics: gnss is none, it was left to be suggested");
  vehicle.topics = {{"lidar", "/a"}};
  vehicle.settings.pairing.max_gap_s = 7.0;
  expect_waits("pairing.max_gap_s ");
  vehicle.settings = {};
  vehicle.nominal = "1,0,2,0,0,0";
  expect_waits("the nominal is 1,0,2,0,0,0, it was left to the sessions");
  vehicle.nominal.clear();
  EXPECT_EQ(row().state, JobState::Failed) << "as it was";
  // Where a result is there from before, that is what counts.
  make(3, result(1.0, 10.0, 0.001));
  EXPECT_EQ(row().state, JobState::Failed);
  vehicle.topics.clear();
  EXPECT_EQ(row().state, JobState::Done);
}

TEST_F(fleet_rows_of, a_failure_is_kept_as_a_message_beside_its_words) {
  const FleetJob& job = fleet_.jobs[3];
  make_job_folder(job);
  const Message reason = say::of_file("mon", say::session_missing());
  note_failure(fleet_, job, reason);
  EXPECT_EQ(failure_message(job), reason);
  EXPECT_EQ(fleet_rows(fleet_)[3].message, reason);
  const std::string text = formats::read_regular_file(job.failure, 1 << 20);
  EXPECT_EQ(text.find(english(reason) + "\n---\n"), 0U) << text;
  EXPECT_NE(fleet_text(fleet_, fleet_rows(fleet_), Language::Chinese).find(render(reason, Language::Chinese)),
            std::string::npos);
}

TEST_F(fleet_rows_of, failures_of_earlier_versions_and_damaged_ones_are_told_by_their_words) {
  const FleetJob& job = fleet_.jobs[3];
  make_job_folder(job);
  for (const char* below : {"", "\n---\nversion: 0.0.1\n", "\n---\nmessage: {code: [\n", "\n---\nmessage: [1]\n"}) {
    std::ofstream(job.failure) << "mon: does not exist\nsecond line" << below;
    EXPECT_EQ(failure_message(job), Message::verbatim("mon: does not exist\nsecond line")) << below;
  }
}

TEST_F(fleet_rows_of, a_failure_is_old_where_a_session_was_written_since) {
  const FleetJob& job = fleet_.jobs[3];
  make_job_folder(job);
  note_failure(fleet_, job, Message::verbatim("mon: does not exist"));
  ASSERT_TRUE(formats::is_file(job.failure));
  EXPECT_EQ(fleet_rows(fleet_)[3].state, JobState::Failed) << "still not there";
  std::filesystem::create_directories(job.sessions[0]);
  std::ofstream(job.sessions[0] / "ins.csv") << "time\n";
  const FleetRow row = fleet_rows(fleet_)[3];
  EXPECT_EQ(row.state, JobState::Waiting);
  EXPECT_NE(english(row.message).find("mon has changed; before that it failed: mon: does not exist"), std::string::npos)
      << english(row.message);
}

TEST_F(fleet_rows_of, the_table_names_result_files_that_are_there) {
  make(0, result(1.0, 10.0, 0.001));
  make(1, result(1.0, 10.0, 0.001));
  note_failure(fleet_, fleet_.jobs[1], Message::verbatim("tue: does not exist"));
  ASSERT_TRUE(formats::is_file(fleet_.jobs[1].failure));
  const std::string csv = fleet_csv(fleet_, fleet_rows(fleet_));
  EXPECT_NE(csv.find(fleet_.jobs[0].result.string()), std::string::npos);
  for (const std::size_t job : {1U, 2U, 3U})
    EXPECT_EQ(csv.find(fleet_.jobs[job].result.string()), std::string::npos) << "job " << job << " has none";
}

// Every step is below the limit for one, and all together are not.
TEST_F(fleet_rows_of, a_slow_creep_is_drift_from_the_oldest_calibration) {
  results::save_result(result(1.0, 10.0, 0.001), folder_.path() / "before.yaml");
  make(0, result(1.008, 10.0, 0.001));
  make(1, result(1.016, 10.0, 0.001));
  make(2, result(1.024, 10.0, 0.001));
  std::vector<FleetRow> rows = fleet_rows(fleet_);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(english(rows[i].last.drift), "") << "a step of 8 mm";
    EXPECT_EQ(rows[i].reference.since, "before.yaml") << "no reference is named: the oldest";
    EXPECT_NEAR(rows[i].reference.change.difference[calibration::Parameter::X], 0.008 * static_cast<double>(i + 1),
                1e-12);
    EXPECT_NEAR(rows[i].reference.change.sigma[calibration::Parameter::X], 0.001 * std::sqrt(2.0), 1e-12) << "of both";
  }
  EXPECT_EQ(english(rows[1].drift()), "");
  EXPECT_NE(english(rows[2].drift()).find("x has changed by +0.0240 m"), std::string::npos) << rows[2].drift();
  EXPECT_NE(english(rows[2].drift()).find("since before.yaml, the reference"), std::string::npos) << rows[2].drift();
  EXPECT_EQ(english(fleet_counts(rows)), "4 jobs: 3 solved, 1 waiting; drift in 1");
  EXPECT_NE(fleet_text(fleet_, rows).find("By the reference: "), std::string::npos);
  EXPECT_NE(fleet_html(fleet_, rows, "now").find("ref. +0.0240 ± 0.0014 (17.0 σ)"), std::string::npos);

  // Without one from before, the first of its jobs is the oldest, and is not compared with itself.
  fleet_.vehicles[0].last.file.clear();
  rows = fleet_rows(fleet_);
  EXPECT_EQ(rows[0].reference.since, "");
  EXPECT_FALSE(rows[1].has_reference_of_its_own) << "the last one is the reference";
  EXPECT_EQ(rows[2].reference.since, "mon");
  EXPECT_EQ(english(rows[2].drift()), "") << "16 mm";
  std::printf("creep: %s\n", english(rows[2].reference.words).c_str());
}

TEST_F(fleet_rows_of, a_reference_that_is_named_stands_before_the_oldest) {
  results::save_result(result(1.0, 10.0, 0.001), folder_.path() / "before.yaml");
  results::save_result(result(1.1, 10.0, 0.001), folder_.path() / "refitted.yaml");
  fleet_.vehicles[0].reference.file = folder_.path() / "refitted.yaml";
  make(0, result(1.1, 10.0, 0.001));
  make(1, result(1.19, 10.0, 0.001));
  std::vector<FleetRow> rows = fleet_rows(fleet_);
  EXPECT_NE(english(rows[0].last.drift), "") << "it was refitted";
  EXPECT_EQ(english(rows[0].reference.drift), "") << "and is as it was then";
  EXPECT_NE(english(rows[1].last.drift).find("since mon"), std::string::npos);
  EXPECT_NE(english(rows[1].reference.drift).find("since refitted.yaml"), std::string::npos);
  // One that cannot be read is said, and no other is taken in its place.
  std::filesystem::remove(folder_.path() / "refitted.yaml");
  rows = fleet_rows(fleet_);
  EXPECT_NE(english(rows[1].reference.words).find("refitted.yaml"), std::string::npos) << rows[1].reference.words;
  EXPECT_EQ(rows[1].reference.since, "");
}

TEST_F(fleet_rows_of, a_reference_of_the_same_name_as_the_last_one_is_another) {
  for (const char* folder : {"fitted", "checked"}) std::filesystem::create_directories(folder_.path() / folder);
  fleet_.vehicles[0].reference.file = folder_.path() / "fitted" / "result.yaml";
  fleet_.vehicles[0].last.file = folder_.path() / "checked" / "result.yaml";
  results::save_result(result(1.0, 10.0, 0.001), fleet_.vehicles[0].reference.file);
  results::save_result(result(1.03, 10.0, 0.001), fleet_.vehicles[0].last.file);
  make(0, result(1.03, 10.0, 0.001));
  std::vector<FleetRow> rows = fleet_rows(fleet_);
  EXPECT_EQ(english(rows[0].last.drift), "");
  EXPECT_NE(english(rows[0].drift()).find("x has changed by +0.0300 m"), std::string::npos) << rows[0].drift();
  // So is one that cannot be read, where nothing else is known yet.
  std::filesystem::remove(fleet_.vehicles[0].reference.file);
  fleet_.vehicles[0].last.file.clear();
  rows = fleet_rows(fleet_);
  EXPECT_NE(fleet_text(fleet_, rows).find("By the reference: Not compared: "), std::string::npos);
}

TEST_F(fleet_rows_of, what_has_changed_beside_the_result_is_asked_and_named) {
  make(0, result(1.0, 10.0, 0.001));
  make(1, result(1.0, 10.0, 0.001));
  const std::vector<FleetRow> rows = fleet_rows(fleet_, [&](const FleetJob& job, const results::VehicleFile&) {
    return job.name == "tue" ? Message::verbatim("tue/ins.csv has changed") : Message();
  });
  EXPECT_EQ(rows[0].state, JobState::Done);
  EXPECT_EQ(rows[1].state, JobState::OutOfDate);
  EXPECT_EQ(english(rows[1].message), "tue/ins.csv has changed");
  EXPECT_TRUE(rows[1].result) << "it is shown, as what it is";
}

TEST_F(fleet_rows_of, the_table_holds_what_the_rows_hold) {
  results::save_result(result(1.0, 10.0, 0.001), folder_.path() / "before.yaml");
  make(0, result(1.1, 10.0, 0.001));
  results::ResultFile flat = result(1.1, 10.0, 0.001);
  flat.result.status = calibration::Status::Degenerate;
  flat.result.withdraw(calibration::Parameter::Z, Message::verbatim("not shown by this drive"));
  make(1, flat);
  make_job_folder(fleet_.jobs[2]);
  std::ofstream(fleet_.jobs[2].failure) << "a \"bad\" file,\nwith two lines & <tags>\n";
  const std::vector<FleetRow> rows = fleet_rows(fleet_);

  const std::string csv = fleet_csv(fleet_, rows);
  EXPECT_EQ(csv.rfind(kFleetCsvMark, 0), 0U);
  formats::LineReader lines(csv);
  std::string_view line;
  ASSERT_TRUE(lines.next(line));
  const formats::CsvHeader header(line);
  std::vector<std::string_view> cells;
  ASSERT_TRUE(lines.next(line));
  formats::split_csv(line, cells);
  ASSERT_EQ(cells.size(), header.size()) << line;
  const auto cell = [&](const char* name) { return std::string(cells.at(header.require(name, "fleet.csv"))); };
  EXPECT_EQ(cell("vehicle"), "bus, 12");
  EXPECT_EQ(cell("status"), "ok");
  EXPECT_NEAR(std::stod(cell("x_m")), 1.1, 1e-12);
  EXPECT_NEAR(std::stod(cell("yaw_sigma_deg")), radians_to_degrees(0.001), 1e-9);
  EXPECT_NEAR(std::stod(cell("change_x_m")), 0.1, 1e-12);
  EXPECT_EQ(cell("drift"), "yes");
  EXPECT_EQ(cell("reference"), "before.yaml");
  EXPECT_NEAR(std::stod(cell("since_reference_x_m")), 0.1, 1e-12);
  EXPECT_NEAR(std::stod(cell("since_reference_yaw_sigma_deg")), radians_to_degrees(0.001 * std::sqrt(2.0)), 1e-9);
  EXPECT_EQ(cell("reference_drift"), "yes");
  ASSERT_TRUE(lines.next(line));
  formats::split_csv(line, cells);
  EXPECT_EQ(cell("z_m"), "") << "not observed";
  EXPECT_EQ(cell("drift"), "no");
  EXPECT_NE(csv.find("\"a \"\"bad\"\" file,\nwith two lines & <tags>\""), std::string::npos) << csv;

  const std::string html = fleet_html(fleet_, rows, "2026-11-22 05:00:00 UTC");
  EXPECT_EQ(html.rfind("<!DOCTYPE html>", 0), 0U);
  for (const char* expected : {"<tr class=\"drift\">", "<tr class=\"failed\">", "1.1000 ± 0.0010", "not observed",
                               "two lines &amp; &lt;tags&gt;", "4 jobs: 2 solved, 1 failed, 1 waiting; drift in 2"})
    EXPECT_NE(html.find(expected), std::string::npos) << expected << "\n" << html;
  EXPECT_EQ(html.find("<tags>"), std::string::npos);
  EXPECT_NE(fleet_text(fleet_, rows).find("DRIFT: x has changed by +0.1000 m"), std::string::npos);
}

}  // namespace
}  // namespace remount::fleet
