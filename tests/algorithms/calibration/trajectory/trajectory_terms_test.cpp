#include "algorithms/calibration/trajectory/trajectory_terms.h"

#include <gtest/gtest.h>

#include "tests/algorithms/support/trajectory_drive.h"

namespace remount::calibration {
namespace {

struct Fixture {
  TrajectorySession session;
  TrajectoryState state;

  Fixture() {
    testing::TrajectoryDriveOptions drive;
    drive.duration_s = 2.0;
    drive.antenna = true;
    drive.scale = 0.01;
    session = testing::trajectory_session(drive);
    state.ins_from_lidar = rigid_from_six({0.7, -0.2, 0.6, 0.05, -0.03, 0.02});
    state.antenna_in_lidar = {0.3, -0.4, 0.2};
    state.scale = {0.02};
    state.clock_s = {0.04};
    state.position_lag_s = {0.03};
    state.odometry_drift = {{0.002, -0.003, 0.005}};
    state.enu_from_lidar.resize(1);
    for (const TrajectoryEpoch& epoch : session.epochs)
      state.enu_from_lidar[0].push_back(testing::true_pose(drive, epoch.time_s) *
                                        rigid_from_six({0.1, 0.2, -0.1, 0.02, 0.01, -0.03}));
  }
};

TrajectoryState with_border(const TrajectoryState& state, int at, double step) {
  TrajectoryState out = state;
  BorderVector d = BorderVector::Zero();
  d[at] = step;
  out.ins_from_lidar = perturb(state.ins_from_lidar, d.head<6>());
  out.antenna_in_lidar += d.segment<3>(kAntennaAt);
  out.add_own(0, d.tail<kOwnSize>());
  return out;
}

void expect_derivatives_agree(const Fixture& f, std::size_t count) {
  constexpr double kStep = 1e-6;
  const std::vector<TrajectoryTerm> terms = trajectory_terms(f.session, 0, f.state);
  ASSERT_EQ(terms.size(), count);
  const auto compare = [&](const TrajectoryState& up, const TrajectoryState& down, const auto& derivative) {
    const std::vector<TrajectoryTerm> above = trajectory_terms(f.session, 0, up),
                                      below = trajectory_terms(f.session, 0, down);
    for (std::size_t k = 0; k < terms.size(); ++k) {
      const Eigen::Vector3d numeric = (above[k].residual - below[k].residual) / (2.0 * kStep);
      const Eigen::Vector3d stated = derivative(terms[k]);
      EXPECT_LT((numeric - stated).norm(), 1e-4 * (1.0 + stated.norm())) << "term " << k;
    }
  };
  for (int at = 0; at < kBorderSize; ++at)
    compare(with_border(f.state, at, kStep), with_border(f.state, at, -kStep),
            [&](const TrajectoryTerm& term) { return Eigen::Vector3d(term.by_border.col(at)); });
  for (std::size_t pose = 0; pose < f.session.epochs.size(); ++pose)
    for (int at = 0; at < 6; ++at) {
      Vector6d d = Vector6d::Zero();
      d[at] = kStep;
      TrajectoryState up = f.state, down = f.state;
      up.enu_from_lidar[0][pose] = moved_in_lidar(f.state.enu_from_lidar[0][pose], d);
      down.enu_from_lidar[0][pose] = moved_in_lidar(f.state.enu_from_lidar[0][pose], -d);
      compare(up, down, [&](const TrajectoryTerm& term) {
        if (term.epoch == pose) return Eigen::Vector3d(term.by_pose.col(at));
        if (term.is_step() && term.epoch == pose + 1) return Eigen::Vector3d(term.by_before.col(at));
        return Eigen::Vector3d(Eigen::Vector3d::Zero());
      });
    }
}

TEST(trajectory_terms, derivatives_agree_with_perturbation) { expect_derivatives_agree({}, 3u * 4u + 2u * 3u); }

// The attitude then is a heading and a tilt, each with its own sigma, and every component is in one of them.
TEST(trajectory_terms, derivatives_of_an_assumed_tilt_agree_with_perturbation) {
  Fixture f;
  for (TrajectoryEpoch& epoch : f.session.epochs)
    if (epoch.ins) epoch.ins->assumed_tilt_sigma_rad = 0.05;
  expect_derivatives_agree(f, 4u * 4u + 2u * 3u);
  const std::vector<TrajectoryTerm> terms = trajectory_terms(f.session, 0, f.state);
  std::size_t tilts = 0;
  for (std::size_t k = 1; k < terms.size(); ++k) {
    if (terms[k].kind != TermKind::InsTilt) continue;
    ++tilts;
    ASSERT_EQ(terms[k - 1].kind, TermKind::InsAttitude);
    EXPECT_EQ(Eigen::Vector3d(terms[k].used + terms[k - 1].used), Eigen::Vector3d(Eigen::Vector3d::Ones()));
  }
  EXPECT_GT(tilts, 0u);
}

TEST(trajectory_terms, vanish_at_the_truth) {
  testing::TrajectoryDriveOptions drive;
  drive.noise = false;
  drive.antenna = true;
  drive.scale = 0.01;
  drive.duration_s = 20.0;
  const TrajectorySession session = testing::trajectory_session(drive);
  TrajectoryState truth;
  truth.ins_from_lidar = drive.ins_from_lidar;
  truth.antenna_in_lidar = drive.antenna_in_lidar;
  truth.scale = {0.01};
  truth.clock_s = {0.0};
  truth.enu_from_lidar.resize(1);
  for (const TrajectoryEpoch& epoch : session.epochs)
    truth.enu_from_lidar[0].push_back(testing::true_pose(drive, epoch.time_s));
  for (const TrajectoryTerm& term : trajectory_terms(session, 0, truth)) EXPECT_LT(term.residual.norm(), 1e-8);
}

}  // namespace
}  // namespace remount::calibration
