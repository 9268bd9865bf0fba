#include "model/pipeline/without_session.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"

namespace remount::pipeline {
namespace {

/// As advice says it: with the session's number, counted as users do, and its name.
Message of_session(const char* code, std::int64_t number, const char* name) {
  return {code, {{"session", Message("session-named", {{"number", number}, {"name", std::string(name)}})}}};
}

/// Three sessions of two keyframes and two pairs each; of the middle one no pair is accepted.
struct ThreeSessions {
  PipelineInput input;
  PipelineOutput output;

  ThreeSessions() {
    for (const char* name : {"monday", "tuesday", "friday"}) add_session(name);
    calibration::CalibrationResult& result = output.result;
    result.status = calibration::Status::Ok;
    result.set_observed(calibration::ParameterSet::all(), {});
    result.mounting.reference_from_sensor = rigid_from_six({1.0, 0.2, 1.5, 0.1, 0.0, 0.0});
    result.pairs_proposed = 6, result.pairs_accepted = 4, result.pairs_rejected = 2;
    result.session_time_offset_s = {0.010, 0.700, 0.030};
    result.time_offset = {0.2467, 0.001, true};
    result.advice = {of_session("session-contradicts-itself", 2, "tuesday"), of_session("session-short", 3, "friday"),
                     Message::verbatim("Drive a ramp.")};
    for (const calibration::MountingSource& source :
         {calibration::MountingSource(calibration::MountingSource::Refined),
          calibration::MountingSource::pair(motion::PairIndex{1}),
          calibration::MountingSource::pair(motion::PairIndex{5}),
          calibration::MountingSource::pairs(motion::PairIndex{0}, motion::PairIndex{4})}) {
      result.candidates.emplace_back();
      result.candidates.back().source = source;
    }
    output.session_uses_sweep = {true, false, true};
    output.session_sweeps.resize(3);
    output.session_frames = {1, 2, 3};
    for (std::size_t s = 0; s < 3; ++s) {
      output.session_sweeps[s].period_s = 0.1 + 0.01 * static_cast<double>(s);
      output.session_swept.push_back({0.0, output.session_sweeps[s].period_s});
    }
  }
  void add_session(const char* name) {
    const auto session = std::make_shared<drive::Session>();
    session->name = name;
    const int number = static_cast<int>(input.sessions.size());
    session->findings = {
        {drive::Severity::Note, "ins-gap", "ins.csv:" + std::to_string(number), Message::verbatim("A gap.")},
        {drive::Severity::Note, "no-gnss", std::string("log"), Message::verbatim("No GNSS.")}};
    output.findings.insert(output.findings.end(), session->findings.begin(), session->findings.end());
    output.findings.push_back(
        {drive::Severity::Warning, "scan-unreadable", session->name, Message::verbatim("A scan is skipped.")});
    input.verdicts.push_back(
        {index_at<motion::SessionIndex>(number), 7, 8, motion::PairState::Rejected, Message::verbatim("lorry")});
    for (int i = 0; i < 2; ++i) {
      motion::Pair pair;
      pair.keyframe_a = index_at<motion::KeyframeIndex>(2 * number),
      pair.keyframe_b = index_at<motion::KeyframeIndex>(2 * number + 1);
      pair.gap_s = static_cast<double>(output.pairs.size());  // what it was called
      pair.state = number == 1 ? motion::PairState::Rejected : motion::PairState::Accepted;
      output.pairs.push_back(pair);
      output.keyframes.push_back(
          {index_at<motion::SessionIndex>(number), index_at<motion::ScanIndex>(i), 100 * number + i, 0.0});
    }
    input.sessions.push_back(session);
  }
};

TEST(without_session, what_the_result_does_not_rest_on_goes_and_x_stays) {
  const ThreeSessions drive;
  const auto left = without_session(drive.input, drive.output, motion::SessionIndex{1});
  ASSERT_TRUE(left);
  const calibration::CalibrationResult& result = left->result;
  EXPECT_TRUE(result.mounting.reference_from_sensor.isApprox(drive.output.result.mounting.reference_from_sensor, 0.0));
  EXPECT_EQ(result.pairs_proposed, 4);
  EXPECT_EQ(result.pairs_accepted, 4);
  EXPECT_EQ(result.pairs_rejected, 0);
  EXPECT_EQ(result.session_time_offset_s, (std::vector{0.010, 0.030}));
  EXPECT_NEAR(result.time_offset.offset_s, 0.020, 1e-12) << "the mean of those that are left";
  EXPECT_EQ(left->session_uses_sweep, (std::vector{true, true}));
  EXPECT_EQ(left->session_frames, (std::vector{1, 3}));
  ASSERT_EQ(left->session_sweeps.size(), 2U);
  EXPECT_NEAR(left->session_sweeps[1].period_s, 0.12, 1e-12);
  ASSERT_EQ(left->session_swept.size(), 2U);
  EXPECT_NEAR(left->session_swept[1].until_s, 0.12, 1e-12);
  EXPECT_EQ(result.advice,
            (std::vector<Message>{of_session("session-short", 2, "friday"), Message::verbatim("Drive a ramp.")}));
}

TEST(without_session, pairs_keyframes_and_sessions_are_numbered_anew) {
  const ThreeSessions drive;
  const auto left = without_session(drive.input, drive.output, motion::SessionIndex{1});
  ASSERT_TRUE(left);
  ASSERT_EQ(left->pairs.size(), 4U);
  ASSERT_EQ(left->keyframes.size(), 4U);
  for (const motion::Pair& pair : left->pairs) {
    const motion::Keyframe& a = left->keyframes.at(pair.keyframe_a);
    EXPECT_EQ(a.session, pair.gap_s < 2.0 ? motion::SessionIndex{0} : motion::SessionIndex{1});
    EXPECT_EQ(a.stamp_ns, pair.gap_s < 2.0 ? 0 : 200) << "the scan that it was made of";
  }
  std::vector<std::string> sources;
  for (const calibration::Candidate& candidate : left->result.candidates)
    sources.push_back(to_string(candidate.source));
  EXPECT_EQ(sources, (std::vector<std::string>{"refined", "pair 1", "pair 3", "pairs 0 + 2"}));
  const PipelineInput input = input_without_session(drive.input, motion::SessionIndex{1});
  ASSERT_EQ(input.sessions.size(), 2U);
  EXPECT_EQ(input.sessions[1], drive.input.sessions[2]);
  ASSERT_EQ(input.verdicts.size(), 2U);
  EXPECT_EQ(input.verdicts[1].session, motion::SessionIndex{1});
}

TEST(without_session, findings_of_the_session_go_and_those_that_others_have_as_well_stay) {
  const ThreeSessions drive;
  const auto left = without_session(drive.input, drive.output, motion::SessionIndex{1});
  ASSERT_TRUE(left);
  int shared = 0;
  for (const drive::Finding& finding : left->findings) {
    EXPECT_NE(drive::english(finding.where), "tuesday");
    EXPECT_NE(drive::english(finding.where), "ins.csv:1");
    shared += finding.code == "no-gnss";
  }
  EXPECT_EQ(shared, 3);
  EXPECT_EQ(left->findings.size(), drive.output.findings.size() - 2);
}

TEST(without_session, what_the_result_rests_on_cannot_be_left_out) {
  ThreeSessions drive;
  EXPECT_FALSE(without_session(drive.input, drive.output, motion::SessionIndex{0})) << "its pairs were accepted";
  EXPECT_FALSE(without_session(drive.input, drive.output, motion::SessionIndex{2}));
  drive.output.method = "trajectory";
  EXPECT_FALSE(without_session(drive.input, drive.output, motion::SessionIndex{1}))
      << "a method without pairs uses all that it is given";
  drive.output.method = std::string(calibration::kPairwise);
  drive.output.ground = calibration::ObservedGround{};
  EXPECT_FALSE(without_session(drive.input, drive.output, motion::SessionIndex{1}))
      << "the ground in its scans was used";
  drive.output.ground.reset();
  drive.output.result.status = calibration::Status::Inconsistent;
  EXPECT_FALSE(without_session(drive.input, drive.output, motion::SessionIndex{1}))
      << "without it there may be a result";
}

}  // namespace
}  // namespace remount::pipeline
