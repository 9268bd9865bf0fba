// Registration of simulated street scans from far away; the full measurement is the benchmark "convergence".
#include <gtest/gtest.h>

#include <random>

#include "algorithms/registration/registration.h"
#include "model/simulator/simulator.h"
#include "tests/support/kept_scans.h"

namespace remount::pipeline {
namespace {

struct Street {
  Street() {
    simulator::SimulationOptions options;
    options.scan_rate_hz = 2.0;
    options.duration_s = 3.0;
    options.motion_distortion = false;
    const simulator::SimulatedDrive drive = testing::simulate_drive(options);
    for (std::size_t i = 0; i < drive.session.scans->size(); ++i) {
      scans.push_back(std::make_unique<registration::PreparedCloud>(drive.session.scans->load(i),
                                                                    registration::RegistrationOptions{}));
      world_from_lidar.push_back(drive.enu_from_ins[i].pose * drive.ins_from_lidar);
    }
  }
  std::vector<std::unique_ptr<registration::PreparedCloud>> scans;
  std::vector<RigidTransform> world_from_lidar;
};

Eigen::Vector3d random_direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  return Eigen::Vector3d(x, y, z).normalized();
}

TEST(registration_of_street_scans, succeeds_from_far_starts) {
  const Street street;
  for (const auto& [off_m, off_deg, least_share] : {std::tuple{2.0, 10.0, 0.95}, std::tuple{5.0, 30.0, 0.9}}) {
    std::mt19937_64 random(11);
    int starts = 0, found = 0;
    for (int round = 0; round < 3; ++round)
      for (std::size_t i = 1; i < street.scans.size(); ++i) {
        const RigidTransform truth = street.world_from_lidar[i - 1].inverse() * street.world_from_lidar[i];
        Vector6d step;
        step.head<3>() = off_m * random_direction(random);
        step.tail<3>() = degrees_to_radians(off_deg) * random_direction(random);
        const registration::RegistrationResult result =
            registration::align_scans(*street.scans[i], *street.scans[i - 1], perturb(truth, step), {}, {});
        const Vector6d error = difference(truth, result.target_from_source);
        found += result.quality.failure.empty() && error.head<3>().norm() < 0.2 &&
                 error.tail<3>().norm() < degrees_to_radians(0.5);
        ++starts;
      }
    std::printf("from %g m, %g deg: %d of %d starts\n", off_m, off_deg, found, starts);
    EXPECT_GE(found, least_share * starts) << off_m << " m, " << off_deg << " deg";
  }
}

}  // namespace
}  // namespace remount::pipeline
