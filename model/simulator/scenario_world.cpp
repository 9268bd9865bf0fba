#include "model/simulator/scenario_world.h"

#include <algorithm>
#include <utility>

#include "model/simulator/random_stream.h"
#include "model/simulator/scenery.h"
#include "model/simulator/slew_yard.h"

namespace remount::simulator {

using Eigen::Vector2d;

namespace {

constexpr std::uint64_t kHighwayStream = 31, kTunnelStream = 32;
constexpr double kScenarioBury_m = 1.5;
constexpr double kRight_m = -2.8, kLeft_m = 6.0;  ///< edges of the two lanes, across from the middle of the driven one
constexpr double kBefore_m = 90.0, kBeyond_m = 130.0;  ///< built before the start and beyond the end

/// Sets things beside the road by their place along and across it.
class RoadBuilder {
 public:
  RoadBuilder(const Road& road, const Ground& ground, RandomStream numbers)
      : random(numbers), road_(road), ground_(ground) {}

  double height_m(double along_m, double left_m) const {
    const Vector2d p = road_.point_in_road(along_m, left_m);
    return ground_.height_m(p.x(), p.y());
  }
  /// A box that is turned with the road; heights above the ground in its middle.
  void box(double along_m, double left_m, const Vector2d& half, double bottom_m, double top_m, double albedo) {
    Box box;
    box.centre = road_.point_in_road(along_m, left_m);
    box.yaw_rad = road_.yaw_rad(along_m);
    box.half = half;
    const double ground_m = ground_.height_m(box.centre.x(), box.centre.y());
    box.bottom_m = ground_m + bottom_m;
    box.top_m = ground_m + top_m;
    box.albedo = static_cast<float>(albedo);
    boxes_.push_back(box);
  }
  void post(double along_m, double left_m, double radius_m, double top_m) {
    Cylinder post;
    post.centre = road_.point_in_road(along_m, left_m);
    post.radius_m = radius_m;
    const double ground_m = ground_.height_m(post.centre.x(), post.centre.y());
    post.bottom_m = ground_m - kScenarioBury_m;
    post.top_m = ground_m + top_m;
    cylinders_.push_back(post);
  }
  World world() { return World(ground_, std::move(boxes_), std::move(cylinders_)); }

  RandomStream random;

 private:
  const Road& road_;
  const Ground& ground_;
  std::vector<Box> boxes_;
  std::vector<Cylinder> cylinders_;
};

/// 200 m of one side beyond the guard rail: a noise barrier or trees.
void highway_side(RoadBuilder& builder, double from_m, double side) {
  const double edge_m = side > 0.0 ? kLeft_m : kRight_m;
  RandomStream& random = builder.random;
  if (random.uniform() < 0.3) {
    const double away_m = random.uniform(4.0, 7.0), top_m = random.uniform(2.0, 4.0);
    for (double s = from_m; s < from_m + 200.0; s += 5.0)
      builder.box(s + 2.5, edge_m + side * away_m, {2.5, 0.1}, -kScenarioBury_m, top_m, 0.5);
    return;
  }
  for (double s = from_m; s < from_m + 200.0; s += random.uniform(5.0, 15.0))
    builder.post(s, edge_m + side * random.uniform(5.0, 18.0), random.uniform(0.15, 0.35), random.uniform(5.0, 12.0));
}

World highway_world(const Road& road, const Ground& ground, const SimulationOptions& options) {
  RoadBuilder builder(road, ground, RandomStream(static_cast<std::uint64_t>(options.seed), kHighwayStream));
  const double from_m = -kBefore_m, to_m = options.speed_mps * options.duration_s + kBeyond_m;
  for (const double side : {-1.0, 1.0}) {
    const double edge_m = side > 0.0 ? kLeft_m : kRight_m;
    for (double s = from_m; s < to_m; s += 4.0) {
      builder.box(s + 2.0, edge_m + side * 0.5, {2.0, 0.04}, 0.45, 0.75, 0.6);
      builder.post(s, edge_m + side * 0.6, 0.06, 0.7);
    }
    for (double s = from_m; s < to_m; s += 50.0) builder.post(s, edge_m + side * 1.2, 0.06, 1.0);
    for (double s = from_m; s < to_m; s += 200.0) highway_side(builder, s, side);
  }
  for (double s = from_m + builder.random.uniform(150.0, 300.0); s < to_m; s += builder.random.uniform(500.0, 900.0)) {
    builder.post(s, kRight_m - 1.5, 0.25, 7.0);
    builder.post(s, kLeft_m + 1.5, 0.25, 7.0);
    builder.box(s, 0.5 * (kLeft_m + kRight_m), {0.3, 0.5 * (kLeft_m - kRight_m) + 1.5}, 6.0, 7.5, 0.7);
  }
  return builder.world();
}

/// Open road before and behind a tunnel.
void open_road(RoadBuilder& builder, double from_m, double to_m) {
  RandomStream& random = builder.random;
  for (const double side : {-1.0, 1.0}) {
    const double edge_m = side > 0.0 ? kLeft_m : kRight_m;
    for (double s = from_m; s < to_m; s += random.uniform(5.0, 9.0))
      builder.post(s, edge_m + side * random.uniform(0.8, 5.0), random.uniform(0.08, 0.3), random.uniform(2.0, 7.0));
    for (double s = from_m; s < to_m; s += random.uniform(10.0, 20.0))
      builder.box(s, edge_m + side * random.uniform(6.0, 10.0), {random.uniform(1.0, 4.0), random.uniform(1.0, 2.0)},
                  -kScenarioBury_m, random.uniform(1.5, 5.0), random.uniform(0.3, 0.8));
  }
}

constexpr double kCeiling_m = 5.5, kWall_m = 0.5;

/// The front of a tunnel, and the cabinets on its walls for 60 m from there inwards (`inwards` is 1 or -1).
void portal(RoadBuilder& builder, double at_m, double inwards) {
  const double width_m = kLeft_m - kRight_m, middle_m = 0.5 * (kLeft_m + kRight_m);
  builder.box(at_m, middle_m, {0.5, 0.5 * width_m + 6.0}, kCeiling_m, kCeiling_m + 3.5, 0.5);
  for (const double side : {-1.0, 1.0}) {
    const double edge_m = side > 0.0 ? kLeft_m : kRight_m;
    builder.box(at_m, edge_m + side * 3.0, {0.5, 3.0}, -kScenarioBury_m, kCeiling_m, 0.5);
    for (double away_m = 3.0; away_m < 60.0; away_m += builder.random.uniform(5.0, 12.0)) {
      const double bottom_m = builder.random.uniform(0.2, 2.0);
      builder.box(at_m + inwards * away_m, edge_m, {builder.random.uniform(0.2, 0.6), 0.3}, bottom_m,
                  bottom_m + builder.random.uniform(0.5, 1.5), 0.7);
    }
  }
}

World tunnel_world(const Road& road, const Ground& ground, const SimulationOptions& options) {
  RoadBuilder builder(road, ground, RandomStream(static_cast<std::uint64_t>(options.seed), kTunnelStream));
  const TunnelReach reach = tunnel_reach(options);
  const double width_m = kLeft_m - kRight_m, middle_m = 0.5 * (kLeft_m + kRight_m);
  // A metre long: in bends, chords are a tenth of a millimetre off and corners a milliradian.
  const int pieces = std::max(1, static_cast<int>(reach.to_m - reach.from_m));
  const double piece_m = (reach.to_m - reach.from_m) / pieces;
  for (int i = 0; i < pieces; ++i) {
    const double s = reach.from_m + (i + 0.5) * piece_m;
    // Longer by what the outer side of a bend is longer.
    const double half_m = 0.505 * piece_m;
    for (const double side : {-1.0, 1.0})
      builder.box(s, (side > 0.0 ? kLeft_m : kRight_m) + side * 0.5 * kWall_m, {half_m, 0.5 * kWall_m},
                  -kScenarioBury_m, kCeiling_m, 0.35);
    builder.box(s, middle_m, {half_m, 0.5 * width_m + kWall_m}, kCeiling_m, kCeiling_m + 0.5, 0.35);
  }
  portal(builder, reach.from_m, 1.0);
  portal(builder, reach.to_m, -1.0);
  open_road(builder, -kBefore_m, reach.from_m - 2.0);
  open_road(builder, reach.to_m + 2.0, options.speed_mps * options.duration_s + kBeyond_m);
  return builder.world();
}

}  // namespace

TunnelReach tunnel_reach(const SimulationOptions& options) {
  constexpr double kOutside_m = 60.0, kShortest_m = 60.0;
  const double length_m = options.speed_mps * options.duration_s;
  return {kOutside_m, std::max(kOutside_m + kShortest_m, length_m - kOutside_m)};
}

World build_scenario_world(const Road& road, const Ground& ground, const SimulationOptions& options) {
  switch (options.scenario) {
    case ScenarioKind::Highway:
      return highway_world(road, ground, options);
    case ScenarioKind::Tunnel:
      return tunnel_world(road, ground, options);
    case ScenarioKind::SlewYard:
      return yard_world(options.seed);
    default:
      return build_world(road, ground, options.speed_mps * options.duration_s, options.seed);
  }
}

}  // namespace remount::simulator
