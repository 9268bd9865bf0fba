// Logs of headings alone, on roads that climb: the INS is taken to be level, and X is told as far as that allows.
#include "model/conventions/assumed_tilt.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "algorithms/messages/render.h"
#include "model/checks/data_check.h"
#include "model/formats/files/input_file.h"
#include "model/method_registry/calibration_method.h"
#include "model/methods/trajectory/trajectory_feed.h"
#include "model/overview/motion_outlook.h"
#include "model/pipeline/pipeline.h"
#include "tests/model/formats/ins/nmea_text.h"
#include "tests/model/simulator/written_drive.h"
#include "tests/support/calibration_checks.h"

namespace remount::conventions {
namespace {

constexpr std::size_t kZ = 2, kYaw = 3, kPitch = 4, kRoll = 5;

/// Each PASHR as the HDT of the same heading.
void keep_headings_alone(const std::filesystem::path& log) {
  std::istringstream lines(formats::read_regular_file(log));
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("$PASHR")) {
      text += line + "\n";
      continue;
    }
    std::vector<std::string_view> fields;
    formats::split_csv(line, fields);
    text += formats::nmea_line("GPHDT," + std::string(fields[2].substr(0, 8)) + ",T");
  }
  std::ofstream(log, std::ios::binary) << text;
}

simulator::SimulationOptions hilly(simulator::ScenarioKind scenario, unsigned seed) {
  simulator::SimulationOptions options;
  options.scenario = scenario;
  options.seed = seed;
  options.duration_s = 24.0;
  options.beams = 8;
  options.azimuth_steps = 90;
  options.ins_rate_hz = 20.0;
  return options;
}

struct TiltedDrive {
  std::shared_ptr<const drive::Session> session;
  RigidTransform truth;
};

TiltedDrive drive_of(const simulator::SimulationOptions& options, bool headings_alone) {
  const formats::TemporaryFolder folder;
  Progress progress;
  simulator::write_drive(simulator::simulate_drive(options), simulator::drive_in(folder), "nmea", 1, progress);
  if (headings_alone) keep_headings_alone(simulator::drive_in(folder) / "receiver.nmea");
  return {std::make_shared<drive::Session>(formats::open_session(simulator::drive_in(folder), progress)),
          simulator::true_mounting(folder)};
}

calibration::CalibrationResult calibrated(const std::vector<TiltedDrive>& drives, const std::string& method,
                                          bool nominal, const settings::Settings& settings = {}) {
  pipeline::PipelineInput input;
  input.settings = settings;
  input.settings.run.map_check = false;
  for (const TiltedDrive& drive : drives) input.sessions.push_back(drive.session);
  // A mounting that is known as well as people know it.
  if (nominal)
    input.nominal_ins_from_lidar = drives.front().truth * rigid_from_six({0.2, -0.2, -0.3, 0.03, -0.03, 0.02});
  Progress progress;
  return method_registry::calibration_method(method).run(input, progress).result;
}

bool has_text(const std::vector<std::string>& texts, const std::string& part) {
  return std::any_of(texts.begin(), texts.end(),
                     [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

std::vector<std::string> words_of(const calibration::CalibrationResult& result) {
  std::vector<std::string> words;
  for (const calibration::ObservabilityDirection& direction : result.directions)
    words.push_back(english(direction.words));
  return words;
}

TEST(assumed_tilt, of_headings_alone_leaves_pitch_and_roll_open_and_covers_the_rest) {
  for (const simulator::ScenarioKind scenario : {simulator::ScenarioKind::Hill, simulator::ScenarioKind::ParkingRamp})
    for (const std::string method : {"pairwise", "trajectory"})
      for (const bool nominal : {true, false}) {
        SCOPED_TRACE(method + (nominal ? ", with a nominal" : ", without") + ", scenario " +
                     std::to_string(static_cast<int>(scenario)));
        const TiltedDrive drive = drive_of(hilly(scenario, 3), true);
        const calibration::CalibrationResult result = calibrated({drive}, method, nominal);
        testing::error_of(result, drive.truth);
        EXPECT_TRUE(calibration::is_usable(result)) << english(result.message);
        for (const std::size_t tilt : {kPitch, kRoll})
          EXPECT_FALSE(result.known[calibration::kParameters[tilt]].observed)
              << to_string(calibration::kParameters[tilt]);
        // Turns on a slope, all of the odometry's, show z of this drive to a quarter of a metre: just within what
        // counts as observed. Others show pitch and roll to 0.9 degrees: see below.
        if (scenario == simulator::ScenarioKind::ParkingRamp && method == "trajectory")
          EXPECT_GT(result.estimate(calibration::kParameters[kZ]).sigma.value_or(1.0), 0.2);
        else
          EXPECT_FALSE(result.known[calibration::kParameters[kZ]].observed);
        if (nominal) {
          EXPECT_TRUE(result.known[calibration::kParameters[kYaw]].observed);
        }
        testing::expect_within_sigma(result, drive.truth, 3.5);
        EXPECT_TRUE(has_text(words_of(result), "roll and pitch of the INS are assumed, not measured"));
        EXPECT_TRUE(has_text(english(result.advice), "The log has a heading and neither roll nor pitch"));
        EXPECT_FALSE(has_text(english(result.advice), "Roll needs turns")) << "no drive would show it";
      }
}

TEST(assumed_tilt, that_many_slopes_average_gives_wide_sigmas_and_says_why) {
  const TiltedDrive drive = drive_of(hilly(simulator::ScenarioKind::ParkingRamp, 4), true);
  const calibration::CalibrationResult result = calibrated({drive}, "trajectory", false);
  testing::error_of(result, drive.truth);
  EXPECT_TRUE(calibration::is_usable(result)) << english(result.message);
  for (const std::size_t tilt : {kPitch, kRoll})
    EXPECT_GT(result.estimate(calibration::kParameters[tilt]).sigma.value_or(1.0), degrees_to_radians(0.5))
        << to_string(calibration::kParameters[tilt]);
  testing::expect_within_sigma(result, drive.truth, 3.5);
  EXPECT_TRUE(has_text(english(result.advice), "The log has a heading and neither roll nor pitch"));
}

TEST(assumed_tilt, is_told_before_anything_is_calibrated) {
  const TiltedDrive drive = drive_of(hilly(simulator::ScenarioKind::ParkingRamp, 1), true);
  const overview::MotionOutlook outlook = overview::motion_outlook(*drive.session, {}, {});
  EXPECT_TRUE(outlook.determinable.contains(calibration::kParameters[kYaw]));
  for (const std::size_t open : {kZ, kPitch, kRoll})
    EXPECT_FALSE(outlook.determinable.contains(calibration::kParameters[open]))
        << to_string(calibration::kParameters[open]);
  EXPECT_TRUE(has_text(english(outlook.advice), "The log has a heading and neither roll nor pitch"));
  for (const drive::Finding& finding : checks::drive_findings(*drive.session))
    EXPECT_NE(finding.code, "flat-driving") << "a ramp would not show";
}

TEST(assumed_tilt, does_not_spoil_a_drive_that_measured_it) {
  const TiltedDrive measured = drive_of(hilly(simulator::ScenarioKind::ParkingRamp, 5), false);
  const TiltedDrive headings = drive_of(hilly(simulator::ScenarioKind::ParkingRamp, 6), true);
  for (const std::string method : {"pairwise", "trajectory"}) {
    SCOPED_TRACE(method);
    const calibration::CalibrationResult alone = calibrated({measured}, method, true);
    EXPECT_FALSE(has_text(english(alone.advice), "The log has a heading and neither roll nor pitch"));
    const calibration::CalibrationResult both = calibrated({measured, headings}, method, true);
    testing::error_of(both, measured.truth);
    for (const std::size_t i : {kPitch, kRoll}) {
      ASSERT_TRUE(alone.known[calibration::kParameters[i]].observed) << to_string(calibration::kParameters[i]);
      EXPECT_TRUE(both.known[calibration::kParameters[i]].observed) << to_string(calibration::kParameters[i]);
    }
    testing::expect_within_sigma(both, measured.truth, 3.5);
  }
}

TEST(assumed_tilt, that_was_measured_by_hand_is_known) {
  const TiltedDrive drive = drive_of(hilly(simulator::ScenarioKind::ParkingRamp, 2), true);
  const SixParameters truth = six_from_rigid(drive.truth);
  settings::Settings settings;
  settings.measured.pitch_deg = radians_to_degrees(truth.pitch_rad);
  settings.measured.roll_deg = radians_to_degrees(truth.roll_rad);
  settings.measured.z_m = truth.z_m;
  settings.measured.pitch_sigma_deg = settings.measured.roll_sigma_deg = 0.2;
  settings.measured.z_sigma_m = 0.02;
  for (const std::string method : {"pairwise", "trajectory"}) {
    SCOPED_TRACE(method);
    const calibration::CalibrationResult result = calibrated({drive}, method, true, settings);
    testing::error_of(result, drive.truth);
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_TRUE(result.known[calibration::kParameters[i]].observed) << to_string(calibration::kParameters[i]);
    testing::expect_within_sigma(result, drive.truth, 3.5);
    EXPECT_FALSE(has_text(english(result.advice), "contradicts")) << "the guess is no measurement";
  }
}

TEST(assumed_tilt, is_only_that_of_logs_that_are_level_throughout_and_say_how_little_that_means) {
  const TiltedDrive headings = drive_of(hilly(simulator::ScenarioKind::Hill, 1), true),
                    measured = drive_of(hilly(simulator::ScenarioKind::Hill, 1), false);
  EXPECT_DOUBLE_EQ(assumed_tilt_sigma_rad(headings.session->ins), kAssumedTilt_rad);
  EXPECT_EQ(assumed_tilt_sigma_rad(measured.session->ins), 0.0);
  EXPECT_EQ(assumed_tilt_sigma_rad(std::vector<motion::InsSample>{}), 0.0);
  std::vector<motion::InsSample> ins = headings.session->ins;
  ins.back().sigma.attitude_rad.x() = std::nan("");
  ins.back().sigma.attitude_rad.y() = std::nan("");
  EXPECT_EQ(assumed_tilt_sigma_rad(ins), 0.0) << "not stated";
  ins = headings.session->ins;
  ins.back().enu_from_ins =
      ins.back().enu_from_ins * Eigen::Quaterniond(Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitX()));
  EXPECT_EQ(assumed_tilt_sigma_rad(ins), 0.0) << "somebody measured";
}

// Every answer on the way has more poses of the same assumption; the last is about as sure as the batch.
TEST(assumed_tilt, is_not_believed_more_by_answers_on_the_way_that_have_seen_it_longer) {
  const TiltedDrive drive = drive_of(hilly(simulator::ScenarioKind::ParkingRamp, 2), true);
  settings::Settings settings;
  settings.solve.max_rotation_sigma_deg = 44.0;  // so that a sigma is shown
  methods::TrajectoryFeed feed(settings, drive.truth, 1);
  Progress progress;
  int answers = 0;
  feed.begin(*drive.session);
  feed.offer(
      *drive.session, true, 0.0,
      [&](const calibration::TrajectorySnapshot& snapshot) { answers += snapshot.known ? 1 : 0; }, progress);
  EXPECT_GT(answers, 5);
  const calibration::CalibrationResult batch = calibrated({drive}, "trajectory", true, settings);
  const calibration::TrajectorySnapshot& last = feed.history().back();
  for (const std::size_t tilt : {kPitch, kRoll}) {
    ASSERT_TRUE(last.sigma[calibration::kParameters[tilt]] && batch.estimate(calibration::kParameters[tilt]).sigma)
        << to_string(calibration::kParameters[tilt]);
    std::printf("%s: %.2f deg on the way, %.2f deg in the end\n", to_string(calibration::kParameters[tilt]).data(),
                radians_to_degrees(*last.sigma[calibration::kParameters[tilt]]),
                radians_to_degrees(*batch.estimate(calibration::kParameters[tilt]).sigma));
    EXPECT_GT(*last.sigma[calibration::kParameters[tilt]], 0.85 * *batch.estimate(calibration::kParameters[tilt]).sigma)
        << to_string(calibration::kParameters[tilt]);
  }
}

}  // namespace
}  // namespace remount::conventions
