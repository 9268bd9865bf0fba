#include "model/simulator/simulator.h"

#include <gtest/gtest.h>

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/LocalCartesian.hpp>
#include <cstring>

#include "algorithms/core/error.h"
#include "algorithms/core/parallel.h"
#include "algorithms/messages/render.h"
#include "model/simulator/lidar_model.h"

namespace remount::simulator {
namespace {

using Eigen::Vector3d;

SimulationOptions small_options() {
  SimulationOptions options;
  options.beams = 16;
  options.azimuth_steps = 400;
  options.duration_s = 4.0;
  return options;
}

/// Distance from a point to the surface of a box.
double distance_m(const Box& box, const Vector3d& p) {
  const Eigen::Vector2d local = Eigen::Rotation2Dd(-box.yaw_rad) * (p.head<2>() - box.centre);
  const Vector3d beyond(std::abs(local.x()) - box.half.x(), std::abs(local.y()) - box.half.y(),
                        std::max(box.bottom_m - p.z(), p.z() - box.top_m));
  if (beyond.maxCoeff() <= 0.0) return -beyond.maxCoeff();
  return beyond.cwiseMax(0.0).norm();
}

/// Distance from a point to the nearest surface of the world.
double distance_m(const World& world, const Vector3d& p) {
  double nearest = std::abs(p.z() - world.ground().surface_height_m(p.x(), p.y()));
  for (const Box& box : world.boxes()) nearest = std::min(nearest, distance_m(box, p));
  for (const Cylinder& pole : world.cylinders())
    if (p.z() < pole.top_m + 0.1)
      nearest = std::min(nearest, std::abs((p.head<2>() - pole.centre).norm() - pole.radius_m));
  return nearest;
}

/// Root mean square distance of every 23rd point of some scans from the world, carried there with the points' times or
/// without.
double rms_from_world_m(const SimulatedDrive& drive, bool with_times, double& largest_m) {
  const auto& source = dynamic_cast<const SimulatedScanSource&>(*drive.session.scans);
  const SimulationOptions& options = source.scene().options();
  double sum = 0.0;
  int count = 0;
  largest_m = 0.0;
  for (std::size_t scan = 3; scan < source.size(); scan += 11) {
    const cloud::PointCloud cloud = source.load(scan);
    for (std::size_t i = 0; i < cloud.size(); i += 23) {
      const double time_s =
          scan_time_s(options, scan) + (with_times ? static_cast<double>(cloud.time_from_stamp_s[i]) : 0.0);
      const Vector3d p = source.scene().road_from_ins(time_s) * drive.ins_from_lidar * cloud.points[i].cast<double>();
      const double off = distance_m(source.scene().world(), p);
      sum += off * off;
      largest_m = std::max(largest_m, off);
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

TEST(simulator, points_carried_by_the_truth_lie_on_the_world_with_their_times_and_not_without) {
  SimulationOptions options = small_options();
  options.moving_objects = 0;
  const SimulatedDrive drive = simulate_drive(options);
  double largest_m = 0.0;
  EXPECT_LT(rms_from_world_m(drive, true, largest_m), options.range_noise_m);
  EXPECT_LT(largest_m, 5.0 * options.range_noise_m);
  EXPECT_GT(rms_from_world_m(drive, false, largest_m), 0.05);
  EXPECT_GT(largest_m, 0.5);
}

TEST(simulator, exact_scans_lie_on_the_world_exactly) {
  SimulationOptions options = small_options();
  options.moving_objects = 0;
  options.range_noise_m = 0.0;
  const SimulatedDrive drive = simulate_drive(options);
  double largest_m = 0.0;
  EXPECT_LT(rms_from_world_m(drive, true, largest_m), 1e-3);
  EXPECT_LT(largest_m, 5e-3);
}

TEST(simulator, sweep_turns_in_the_sense_that_the_session_declares_and_faces_ahead_at_the_stamp) {
  for (const bool clockwise : {true, false}) {
    SimulationOptions options = small_options();
    options.clockwise = clockwise;
    const SimulatedDrive drive = simulate_drive(options);
    const drive::SweepModel& sweep = drive.session.sweep;
    EXPECT_EQ(sweep.clockwise, clockwise);
    const cloud::PointCloud cloud = drive.session.scans->load(0);
    for (std::size_t i = 0; i < cloud.size(); i += 7) {
      const double azimuth = std::atan2(cloud.points[i].y(), cloud.points[i].x());
      const double turned = wrap_angle_rad(azimuth - sweep.stamp_azimuth_rad) / (2.0 * kPi);
      ASSERT_NEAR(cloud.time_from_stamp_s[i], (clockwise ? -turned : turned) * sweep.period_s, 1e-6);
    }
  }
}

TEST(simulator, noise_free_ins_is_the_true_motion) {
  SimulationOptions options = small_options();
  options.ins_position_noise_m = options.ins_attitude_noise_deg = 0.0;
  options.latitude_deg = 55.0;
  options.speed_mps = 30.0;
  options.duration_s = 60.0;  // far enough for the local level to turn
  const SimulatedDrive drive = simulate_drive(options);
  const GeographicLib::Geocentric earth = GeographicLib::Geocentric::WGS84();
  // Through the Earth's centre: independent of the way the samples were made.
  const auto earth_from = [&](double lat_deg, double lon_deg, double height_m) {
    std::vector<double> m(9);
    Vector3d p;
    earth.Forward(lat_deg, lon_deg, height_m, p.x(), p.y(), p.z(), m);
    return make_rigid(Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(m.data()), p);
  };
  const RigidTransform earth_from_enu = earth_from(options.latitude_deg, options.longitude_deg, options.height_m);
  std::size_t next = 0;
  std::size_t compared = 0;
  for (const motion::InsSample& sample : drive.session.ins) {
    while (next < drive.enu_from_ins.size() && drive.enu_from_ins[next].stamp_ns < sample.stamp_ns) ++next;
    if (next == drive.enu_from_ins.size() || drive.enu_from_ins[next].stamp_ns != sample.stamp_ns) continue;
    const RigidTransform earth_from_here =
        earth_from(radians_to_degrees(sample.latitude_rad), radians_to_degrees(sample.longitude_rad), sample.height_m);
    const RigidTransform found = earth_from_here * make_rigid(sample.enu_from_ins.toRotationMatrix(), Vector3d::Zero());
    const RigidTransform expected = earth_from_enu * drive.enu_from_ins[next].pose;
    ASSERT_LT((found.translation() - expected.translation()).norm(), 1e-6);
    ASSERT_LT(rotation_angle_between_rad(found, expected), 1e-9);
    ++compared;
  }
  EXPECT_EQ(compared, drive.enu_from_ins.size());
}

TEST(simulator, ins_noise_and_bias_have_the_stated_size) {
  SimulationOptions exact = small_options();
  exact.ins_position_noise_m = exact.ins_attitude_noise_deg = 0.0;
  exact.duration_s = 60.0;
  SimulationOptions noisy = exact;
  noisy.ins_position_noise_m = 0.005;
  noisy.ins_attitude_noise_deg = 0.02;
  noisy.ins_attitude_bias_deg = 0.5;
  const auto truth = simulate_drive(exact).session.ins, measured = simulate_drive(noisy).session.ins;
  ASSERT_EQ(truth.size(), measured.size());
  Vector3d mean = Vector3d::Zero(), square = Vector3d::Zero();
  double height2 = 0.0;
  const double n = static_cast<double>(truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Vector3d error = so3_log((truth[i].enu_from_ins.conjugate() * measured[i].enu_from_ins).toRotationMatrix());
    mean += error / n;
    square += error.cwiseAbs2() / n;
    height2 += std::pow(measured[i].height_m - truth[i].height_m, 2) / n;
  }
  const Vector3d sigma_deg = (square - mean.cwiseAbs2()).cwiseSqrt() * radians_to_degrees(1.0);
  EXPECT_LT((sigma_deg - Vector3d::Constant(0.02)).cwiseAbs().maxCoeff(), 0.001) << sigma_deg.transpose();
  EXPECT_NEAR(std::sqrt(height2), 0.005, 0.0003);
  const double bias_deg = radians_to_degrees(mean.norm());
  EXPECT_GT(bias_deg, 0.05);
  EXPECT_LT(bias_deg, 2.5);
}

TEST(simulator, ins_interpolates_to_a_tenth_of_a_millimetre) {
  SimulationOptions options = small_options();
  options.ins_position_noise_m = options.ins_attitude_noise_deg = 0.0;
  const auto scene = std::make_shared<const Scene>(options);
  for (double t = 0.0; t < 4.0; t += 0.01) {
    const RigidTransform a = scene->enu_from_ins(t), b = scene->enu_from_ins(t + 0.01),
                         middle = scene->enu_from_ins(t + 0.005);
    ASSERT_LT((0.5 * (a.translation() + b.translation()) - middle.translation()).norm(), 1e-4);
    const Eigen::Matrix3d half = a.linear() * so3_exp(0.5 * so3_log(a.linear().transpose() * b.linear()));
    ASSERT_LT(so3_log(half.transpose() * middle.linear()).norm(), 5e-5);
  }
}

TEST(simulator, drive_across_a_zone_boundary_is_continuous) {
  SimulationOptions options = small_options();
  options.ins_position_noise_m = 0.0;
  options.latitude_deg = 55.0;
  options.longitude_deg = 11.9999;
  options.scenario = ScenarioKind::Straight;
  const SimulatedDrive drive = simulate_drive(options);
  EXPECT_LT(radians_to_degrees(drive.session.ins.front().longitude_rad), 12.0);
  EXPECT_GT(radians_to_degrees(drive.session.ins.back().longitude_rad), 12.0);
  const GeographicLib::Geocentric earth = GeographicLib::Geocentric::WGS84();
  Vector3d before = Vector3d::Zero();
  for (const motion::InsSample& sample : drive.session.ins) {
    Vector3d p;
    earth.Forward(radians_to_degrees(sample.latitude_rad), radians_to_degrees(sample.longitude_rad), sample.height_m,
                  p.x(), p.y(), p.z());
    if (!before.isZero()) {
      ASSERT_NEAR((p - before).norm(), options.speed_mps / options.ins_rate_hz, 1e-7);
    }
    before = p;
  }
}

TEST(simulator, scans_are_the_same_bytes_for_any_number_of_threads) {
  const SimulatedDrive first = simulate_drive(small_options()), second = simulate_drive(small_options());
  const std::size_t count = first.session.scans->size();
  std::vector<cloud::PointCloud> clouds(count);
  parallel_for(count, 4, [&](std::size_t i) { clouds[count - 1 - i] = first.session.scans->load(count - 1 - i); });
  for (std::size_t i = 0; i < count; ++i) {
    const cloud::PointCloud again = second.session.scans->load(i);
    ASSERT_EQ(again.size(), clouds[i].size());
    ASSERT_EQ(std::memcmp(again.points.data(), clouds[i].points.data(), again.size() * sizeof(again.points[0])), 0);
    ASSERT_EQ(again.time_from_stamp_s, clouds[i].time_from_stamp_s);
    ASSERT_EQ(again.intensity, clouds[i].intensity);
  }
}

TEST(simulator, stamps_are_early_by_the_clock_offset) {
  SimulationOptions options = small_options();
  options.lidar_clock_offset_s = 0.25;
  const SimulatedDrive drive = simulate_drive(options);
  EXPECT_EQ(drive.session.scans->stamp_ns(5) + 250'000'000, drive.enu_from_ins[5].stamp_ns);
}

TEST(simulator, timing_says_what_the_scans_are) {
  SimulationOptions options = small_options();
  EXPECT_EQ(simulate_drive(options).session.scan_timing, drive::ScanTiming::PerPoint);
  options.per_point_time = false;
  EXPECT_EQ(simulate_drive(options).session.scan_timing, drive::ScanTiming::SweepAzimuth);
  EXPECT_TRUE(simulate_drive(options).session.scans->load(0).time_from_stamp_s.empty());
  options.motion_distortion = false;
  EXPECT_EQ(simulate_drive(options).session.scan_timing, drive::ScanTiming::Instant);
}

TEST(simulator, vehicle_never_touches_anything) {
  for (const ScenarioKind kind :
       {ScenarioKind::Street, ScenarioKind::Straight, ScenarioKind::FigureEight, ScenarioKind::ParkingRamp})
    for (int seed = 1; seed <= 5; ++seed) {
      SimulationOptions options;
      options.scenario = kind;
      options.seed = seed;
      const Scene scene(options);
      for (double t = 0.0; t < options.duration_s; t += 0.1) {
        const Vector3d ins = scene.road_from_ins(t).translation();
        for (const Box& box : scene.world().boxes())
          ASSERT_GT(distance_m(box, ins), 0.8)
              << "scenario " << static_cast<int>(kind) << " seed " << seed << " at " << t;
        for (const Box& box : scene.traffic().boxes_at(t, ins.head<2>(), 50.0))
          ASSERT_GT(distance_m(box, ins), 0.8)
              << "car, scenario " << static_cast<int>(kind) << " seed " << seed << " at " << t;
      }
    }
}

TEST(simulator, every_option_out_of_range_is_named) {
  SimulationOptions options;
  options.beams = 0;
  options.dropout = 2.0;
  try {
    simulate_drive(options);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::Contract);
    EXPECT_NE(english(error.what_happened()).find("beams"), std::string::npos);
    EXPECT_NE(english(error.what_happened()).find("dropout"), std::string::npos);
  }
}

}  // namespace
}  // namespace remount::simulator
