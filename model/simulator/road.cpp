#include "model/simulator/road.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/core/index.h"
#include "model/simulator/random_stream.h"

namespace remount::simulator {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int kKnots = 256;
constexpr double kComfort_mps2 = 4.0;  ///< sideways acceleration that a driver accepts

struct Swing {
  double amplitude_rad;
  double shortest_period_m;
};

Swing swing_of(ScenarioKind scenario) {
  switch (scenario) {
    case ScenarioKind::Street:
    case ScenarioKind::Flat:
      return {1.3, 60.0};
    case ScenarioKind::Straight:
      return {0.0, 100.0};
    case ScenarioKind::FigureEight:
      return {2.404825557695773, 120.0};
    case ScenarioKind::ParkingRamp:
      return {1.4, 50.0};
    case ScenarioKind::Hill:
      return {0.9, 150.0};
    case ScenarioKind::Tunnel:  // bends of a kilometre's radius
      return {0.3, 2000.0};
    case ScenarioKind::Highway:
    case ScenarioKind::SlewYard:
      return {0.0, 100.0};
  }
  return {0.0, 100.0};
}

}  // namespace

Road::Road(ScenarioKind scenario, double speed_mps) : closed_(scenario == ScenarioKind::FigureEight) {
  const Swing swing = swing_of(scenario);
  amplitude_rad_ = swing.amplitude_rad;
  // Sharpest curvature is 2 pi amplitude / period.
  period_m_ = std::max(swing.shortest_period_m, 2.0 * kPi * amplitude_rad_ * speed_mps * speed_mps / kComfort_mps2);
  knots_.push_back(Vector2d::Zero());
  for (int i = 0; i < kKnots; ++i)
    knots_.push_back(knots_.back() + integral(i * period_m_ / kKnots, (i + 1) * period_m_ / kKnots));
  if (closed_) knots_.back().setZero();
}

double Road::yaw_rad(double along_m) const { return amplitude_rad_ * std::sin(2.0 * kPi * along_m / period_m_); }

Vector2d Road::integral(double from_m, double to_m) const {
  // Gauss-Legendre, five points: exact to rounding over a knot.
  constexpr std::array<double, 5> nodes{0.0, 0.5384693101056831, -0.5384693101056831, 0.9061798459386640,
                                        -0.9061798459386640};
  constexpr std::array<double, 5> weights{0.5688888888888889, 0.4786286704993665, 0.4786286704993665,
                                          0.2369268850561891, 0.2369268850561891};
  const double half = 0.5 * (to_m - from_m), middle = 0.5 * (to_m + from_m);
  Vector2d sum = Vector2d::Zero();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double yaw = yaw_rad(middle + half * nodes[i]);
    sum += weights[i] * Vector2d(std::cos(yaw), std::sin(yaw));
  }
  return half * sum;
}

Vector2d Road::point_in_road(double along_m) const {
  const double turns = std::floor(along_m / period_m_);
  const double rest_m = along_m - turns * period_m_;
  const int knot = std::clamp(static_cast<int>(rest_m / period_m_ * kKnots), 0, kKnots - 1);
  return turns * knots_.back() + knots_[index_at(knot)] + integral(knot * period_m_ / kKnots, rest_m);
}

Vector2d Road::point_in_road(double along_m, double left_m) const {
  const double yaw = yaw_rad(along_m);
  return point_in_road(along_m) + left_m * Vector2d(-std::sin(yaw), std::cos(yaw));
}

Ground scenario_ground(ScenarioKind scenario, int seed) {
  std::vector<GroundWave> waves;
  switch (scenario) {
    case ScenarioKind::Flat:
    case ScenarioKind::Straight:
    case ScenarioKind::Tunnel:
    case ScenarioKind::SlewYard:
      return Ground({});
    case ScenarioKind::Hill:  // slopes of nine in a hundred
      waves = {{1, 0, 1.30, 0.0}, {0, 1, 1.30, 0.0}, {2, 1, 0.22, 0.0}};
      break;
    case ScenarioKind::Highway:
      waves = {{1, 0, 0.12, 0.0}, {2, 1, 0.04, 0.0}};
      break;
    case ScenarioKind::Street:  // wavelengths 41, 25, 18 and 12 m
      waves = {{3, 1, 0.18, 0.0}, {-2, 5, 0.10, 0.0}, {6, 4, 0.07, 0.0}, {9, -6, 0.03, 0.0}};
      break;
    case ScenarioKind::FigureEight:
      waves = {{3, 1, 0.12, 0.0}, {-2, 5, 0.07, 0.0}, {6, 4, 0.04, 0.0}};
      break;
    case ScenarioKind::ParkingRamp:  // slopes of eight to ten in a hundred
      waves = {{2, 0, 0.80, 0.0}, {1, 2, 0.30, 0.0}, {-2, 3, 0.15, 0.0}};
      break;
  }
  RandomStream random(static_cast<std::uint64_t>(seed), 1);
  for (GroundWave& wave : waves) wave.phase_rad = random.uniform(0.0, 2.0 * kPi);
  return Ground(std::move(waves));
}

RigidTransform road_from_vehicle(const Road& road, const Ground& ground, double along_m) {
  constexpr double kWheelbase_m = 2.7, kHalfTrack_m = 0.5 * kTrack_m;
  const Vector2d rear = road.point_in_road(along_m);
  const double yaw = road.yaw_rad(along_m);
  const Vector2d forward(std::cos(yaw), std::sin(yaw)), left(-forward.y(), forward.x());
  const auto wheel_height = [&](double ahead_m, double left_m) {
    const Vector2d p = rear + ahead_m * forward + left_m * left;
    return ground.height_m(p.x(), p.y());
  };
  const double rear_left = wheel_height(0.0, kHalfTrack_m), rear_right = wheel_height(0.0, -kHalfTrack_m);
  const double front_left = wheel_height(kWheelbase_m, kHalfTrack_m),
               front_right = wheel_height(kWheelbase_m, -kHalfTrack_m);
  const double climb = 0.5 * (front_left + front_right - rear_left - rear_right) / kWheelbase_m;
  const double bank = 0.25 * (front_left + rear_left - front_right - rear_right) / kHalfTrack_m;
  const Vector3d x = Vector3d(forward.x(), forward.y(), climb).normalized();
  const Vector3d z = x.cross(Vector3d(left.x(), left.y(), bank)).normalized();
  Eigen::Matrix3d rotation;
  rotation << x, z.cross(x), z;
  return make_rigid(rotation, {rear.x(), rear.y(), 0.5 * (rear_left + rear_right)});
}

}  // namespace remount::simulator
