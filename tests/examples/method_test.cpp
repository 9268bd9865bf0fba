// The example of a calibration method in CONTRIBUTING.md, as it is compiled.
#include <gtest/gtest.h>

#include "algorithms/core/error.h"
#include "messages/examples.h"
#include "model/method_registry/method_needs.h"
#include "model/pipeline/input_checks.h"
#include "model/pipeline/pipeline.h"

namespace remount::methods {

extern const method_registry::CalibrationMethod kDeclaredMethod;
pipeline::PipelineOutput run_declared(const pipeline::PipelineInput& input, Progress& progress);

namespace {

Message lack_for_declared(const drive::Session& session, const method_registry::GivenSessions&) {
  return session.nominal_ins_from_lidar ? Message() : say::lacks_declaration();
}

}  // namespace

constinit const method_registry::CalibrationMethod kDeclaredMethod{.id = "declared",
                                                                   .title = say::method_title_declared,
                                                                   .needs = say::needs_of_declared,
                                                                   .lack = lack_for_declared,
                                                                   .run = method_registry::solver(run_declared)};

pipeline::PipelineOutput run_declared(const pipeline::PipelineInput& input, Progress&) {
  settings::require_valid(input.settings);
  method_registry::require_served(kDeclaredMethod, input.sessions);
  pipeline::PipelineOutput output;
  output.method = kDeclaredMethod.id;
  calibration::CalibrationResult& result = output.result;
  result.mounting.reference_from_sensor = *input.sessions.front()->nominal_ins_from_lidar;
  result.set_observed({}, say::only_declared());
  result.conclude(calibration::Status::Degenerate, say::declared_result());
  return output;
}

namespace {

pipeline::PipelineInput input_of(const std::optional<RigidTransform>& declared) {
  auto session = std::make_shared<drive::Session>();
  session->name = "drive";
  session->nominal_ins_from_lidar = declared;
  pipeline::PipelineInput input;
  input.sessions = {session};
  return input;
}

TEST(example_of_a_method, takes_what_a_session_declares_and_has_seen_nothing) {
  const RigidTransform x = rigid_from_six({1.2, -0.3, 1.9, 0.5, -0.02, 0.01});
  Progress progress;
  const calibration::CalibrationResult result = kDeclaredMethod.run(input_of(x), progress).result;
  EXPECT_TRUE(result.mounting.ins_from_lidar().isApprox(x, 1e-12));
  EXPECT_TRUE(result.observed().empty());
  EXPECT_FALSE(calibration::is_usable(result));
}

TEST(example_of_a_method, refuses_a_session_that_declares_nothing) {
  Progress progress;
  try {
    (void)kDeclaredMethod.run(input_of({}), progress);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::Unsupported);
    // The sentences of the examples are in no catalogue that a program has: their ids stand for them.
    EXPECT_NE(std::string(error.what()).find("lacks-declaration"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace remount::methods
