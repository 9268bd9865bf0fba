#include "model/pipeline/step_finder.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <memory>

#include "algorithms/cloud/objects.h"
#include "model/simulator/simulator.h"

namespace remount::pipeline {
namespace {

TEST(step_finder, a_motion_is_as_long_as_that_of_the_ins_but_for_turn_and_lever_arm) {
  const RigidTransform ahead = make_rigid(Eigen::Matrix3d::Identity(), {2.5, 0.0, 0.0});
  EXPECT_TRUE(as_long_as(make_rigid(Eigen::Matrix3d::Identity(), {0.0, -2.4, 0.3}), ahead)) << "in any direction";
  EXPECT_FALSE(as_long_as(RigidTransform::Identity(), ahead));
  EXPECT_FALSE(as_long_as(make_rigid(Eigen::Matrix3d::Identity(), {5.0, 0.0, 0.0}), ahead));
  const RigidTransform turned = make_rigid(so3_exp({0.0, 0.0, 0.5}), {2.5, 0.0, 0.0});
  EXPECT_TRUE(as_long_as(RigidTransform::Identity(), turned)) << "a lever arm may make up for it";
}

TEST(step_finder, finds_the_steps_of_a_fast_drive_where_scans_look_alike_a_few_metres_on) {
  simulator::SimulationOptions options;
  options.scenario = simulator::ScenarioKind::Highway;
  options.speed_mps = 25.0;
  options.duration_s = 2.5;
  options.beams = 32;
  options.azimuth_steps = 500;
  options.seed = 2;
  const simulator::SimulatedDrive drive = simulator::simulate_drive(options);
  registration::RegistrationOptions registration;
  registration.voxel_m = 0.4;
  registration.max_correspondence_m = 2.0;
  registration.max_iterations = 60;
  const cloud::PointCloud first = drive.session.scans->load(0);
  const Progress progress;
  StepFinder steps(registration, cloud::estimate_up(first, Eigen::Vector3f::Zero()).cast<double>(), progress);
  auto previous = std::make_unique<registration::PreparedCloud>(first, registration);
  int right = 0, right_from_rest = 0, count = 0;
  for (std::size_t i = 1; i < drive.session.scans->size(); ++i, ++count) {
    auto current = std::make_unique<registration::PreparedCloud>(drive.session.scans->load(i), registration);
    const RigidTransform ins_step = drive.enu_from_ins[i - 1].pose.inverse() * drive.enu_from_ins[i].pose;
    const RigidTransform truth = drive.ins_from_lidar.inverse() * ins_step * drive.ins_from_lidar;
    // Scans are bent by their motion, along it.
    const auto is_right = [&](const registration::RegistrationResult& step) {
      return step.quality.failure.empty() && (step.target_from_source.translation() - truth.translation()).norm() < 0.7;
    };
    right += is_right(steps.find(*current, *previous, ins_step));
    right_from_rest +=
        is_right(registration::align_scans(*current, *previous, RigidTransform::Identity(), registration, {}));
    previous = std::move(current);
  }
  std::printf("  %d of %d steps, from rest %d\n", right, count, right_from_rest);
  EXPECT_GE(right, 0.6 * count) << "the others are outliers to the solution";
  EXPECT_LE(right_from_rest, 0.5 * count) << "this drive tests nothing";
}

}  // namespace
}  // namespace remount::pipeline
