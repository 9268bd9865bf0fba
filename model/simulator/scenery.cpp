#include "model/simulator/scenery.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "model/simulator/random_stream.h"
#include "model/simulator/speed_profile.h"

namespace remount::simulator {

using Eigen::Vector2d;

namespace {

constexpr double kOtherLane_m = 3.2;  ///< to the left of the driven lane
constexpr double kBury_m = 1.5;       ///< objects reach this far into the ground

/// The middle lines of both lanes, to keep objects off them.
class Lanes {
 public:
  Lanes(const Road& road, double from_m, double to_m) {
    for (double s = from_m; s <= to_m; s += 1.0)
      for (const double left_m : {0.0, 1.6, kOtherLane_m}) {
        const Vector2d p = road.point_in_road(s, left_m);
        cells_[key(cell(p.x()), cell(p.y()))].push_back(p);
      }
  }

  bool clear(const Vector2d& p, double distance_m) const {
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const auto found = cells_.find(key(cell(p.x()) + dx, cell(p.y()) + dy));
        if (found == cells_.end()) continue;
        for (const Vector2d& lane : found->second)
          if ((lane - p).squaredNorm() < distance_m * distance_m) return false;
      }
    return true;
  }

  bool clear(const Box& box, double distance_m) const {
    const Eigen::Rotation2Dd turn(box.yaw_rad);
    for (int iy = -2; iy <= 2; ++iy)
      for (int ix = -2; ix <= 2; ++ix)
        if (!clear(box.centre + turn * Vector2d(0.5 * ix * box.half.x(), 0.5 * iy * box.half.y()), distance_m))
          return false;
    return true;
  }

 private:
  static constexpr double kCell_m = 8.0;
  static int cell(double v) { return static_cast<int>(std::floor(v / kCell_m)); }
  static std::uint64_t key(int x, int y) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32 | static_cast<std::uint32_t>(y);
  }
  std::unordered_map<std::uint64_t, std::vector<Vector2d>> cells_;
};

/// Sets objects along one side of the road.
class Roadside {
 public:
  Roadside(const Road& road, const Ground& ground, const Lanes& lanes, double side, RandomStream random)
      : road_(road), ground_(ground), lanes_(lanes), side_(side), random_(random) {}

  void fill(double from_m, double to_m) {
    for (double s = from_m; s < to_m;) s += building(s);
    for (double s = from_m; s < to_m; s += random_.uniform(4.0, 9.0)) post(s);
    for (double s = from_m; s < to_m; s += random_.uniform(7.0, 16.0)) parked_car(s);
    for (double s = from_m; s < to_m; s += 2.0) kerb(s);
  }

  std::vector<Box> boxes;
  std::vector<Cylinder> cylinders;

 private:
  /// Across the road from the driven lane's middle, outwards from the edge of the road on this side.
  double across(double beyond_edge_m) const {
    return side_ * beyond_edge_m + (side_ > 0.0 ? kOtherLane_m + 2.3 : -2.3);
  }

  double building(double s) {
    const double width_m = random_.uniform(7.0, 14.0), depth_m = random_.uniform(6.0, 9.0);
    const double setback_m = random_.uniform(6.0, 8.5), height_m = random_.uniform(4.0, 11.0);
    const double middle = s + 0.5 * width_m;
    Box house;
    house.yaw_rad = road_.yaw_rad(middle);
    house.half = {0.5 * width_m, 0.5 * depth_m};
    house.albedo = static_cast<float>(random_.uniform(0.3, 0.8));
    // Inside a bend the first place may lie on the road: stand back farther there.
    for (const double farther_m : {0.0, 4.0, 9.0, 16.0}) {
      house.centre = road_.point_in_road(middle, across(setback_m + farther_m) + side_ * house.half.y());
      if (!lanes_.clear(house, 5.0)) continue;
      const double ground_m = ground_.height_m(house.centre.x(), house.centre.y());
      house.bottom_m = ground_m - kBury_m;
      house.top_m = ground_m + height_m;
      boxes.push_back(house);
      front(house, ground_m);
      break;
    }
    return width_m + random_.uniform(1.0, 4.0);
  }

  /// Bays from the ground up, with doorways between them, and balconies: what makes the place along a facade visible.
  void front(const Box& house, double ground_m) {
    const Eigen::Rotation2Dd turn(house.yaw_rad);
    for (double along = -house.half.x() + 0.4; along < house.half.x() - 1.0; along += random_.uniform(1.2, 2.5)) {
      Box bay = house;
      const double width_m = random_.uniform(0.4, 1.4), out_m = random_.uniform(0.2, 0.8);
      bay.half = {0.5 * width_m, 0.5 * out_m + 0.05};
      bay.centre =
          house.centre + turn * Vector2d(along + 0.5 * width_m, -side_ * (house.half.y() + 0.5 * out_m - 0.05));
      if (random_.uniform() < 0.3) {  // a balcony
        bay.bottom_m = ground_m + 2.8;
        bay.top_m = ground_m + 4.0;
      } else {
        bay.top_m = ground_m + random_.uniform(2.5, house.top_m - ground_m);
      }
      bay.albedo = static_cast<float>(random_.uniform(0.2, 0.9));
      boxes.push_back(bay);
      along += width_m;
    }
  }

  void post(double s) {
    Cylinder post;
    post.centre = road_.point_in_road(s, across(random_.uniform(0.5, 4.5)));
    const bool tree = random_.uniform() < 0.4;
    post.radius_m = tree ? random_.uniform(0.15, 0.30) : random_.uniform(0.07, 0.12);
    const double ground_m = ground_.height_m(post.centre.x(), post.centre.y());
    post.bottom_m = ground_m - kBury_m;
    post.top_m = ground_m + random_.uniform(3.0, 7.0);
    post.albedo = tree ? 0.3f : 0.7f;
    if (lanes_.clear(post.centre, 2.4)) cylinders.push_back(post);
  }

  void parked_car(double s) {
    const Vector2d centre = road_.point_in_road(s, across(1.4));
    const double yaw = road_.yaw_rad(s) + random_.uniform(-0.05, 0.05);
    const std::vector<Box> car = car_boxes(centre, yaw, ground_.height_m(centre.x(), centre.y()));
    if (random_.uniform() < 0.6 && lanes_.clear(car.front(), 2.1)) boxes.insert(boxes.end(), car.begin(), car.end());
  }

  void kerb(double s) {
    Box kerb;
    kerb.yaw_rad = road_.yaw_rad(s + 1.0);
    kerb.half = {1.0, 0.15};
    kerb.centre = road_.point_in_road(s + 1.0, across(0.1));
    const double ground_m = ground_.height_m(kerb.centre.x(), kerb.centre.y());
    kerb.bottom_m = ground_m - kBury_m;
    kerb.top_m = ground_m + 0.13;
    kerb.albedo = 0.4f;
    if (lanes_.clear(kerb, 1.9)) boxes.push_back(kerb);
  }

  const Road& road_;
  const Ground& ground_;
  const Lanes& lanes_;
  double side_;  ///< +1 left, -1 right
  RandomStream random_;
};

}  // namespace

std::vector<Box> car_boxes(const Vector2d& centre, double yaw_rad, double ground_m) {
  Box body;
  body.centre = centre;
  body.yaw_rad = yaw_rad;
  body.half = {2.2, 0.9};
  body.bottom_m = ground_m + 0.22;
  body.top_m = ground_m + 0.9;
  body.albedo = 0.6f;
  Box cabin = body;
  cabin.centre -= 0.3 * Vector2d(std::cos(yaw_rad), std::sin(yaw_rad));
  cabin.half = {1.25, 0.78};
  cabin.bottom_m = body.top_m;
  cabin.top_m = ground_m + 1.5;
  cabin.albedo = 0.2f;
  return {body, cabin};
}

World build_world(const Road& road, const Ground& ground, double length_m, int seed) {
  const double from_m = road.closed() ? 0.0 : -70.0;
  const double to_m = road.closed() ? road.period_m() : length_m + 100.0;
  const Lanes lanes(road, from_m - 10.0, to_m + 10.0);
  std::vector<Box> boxes;
  std::vector<Cylinder> cylinders;
  for (const double side : {-1.0, 1.0}) {
    Roadside roadside(road, ground, lanes, side, RandomStream(static_cast<std::uint64_t>(seed), side < 0.0 ? 2 : 3));
    roadside.fill(from_m, to_m);
    boxes.insert(boxes.end(), roadside.boxes.begin(), roadside.boxes.end());
    cylinders.insert(cylinders.end(), roadside.cylinders.begin(), roadside.cylinders.end());
  }
  return World(ground, std::move(boxes), std::move(cylinders));
}

Traffic::Traffic(const Road& road, const Ground& ground, const SimulationOptions& options)
    : road_(road), ground_(ground) {
  RandomStream random(static_cast<std::uint64_t>(options.seed), 4);
  const int cars = options.scenario == ScenarioKind::SlewYard ? 0 : options.moving_objects;
  const double own_speed_mps = options.speed_mps;
  // One ahead in the own lane; a closed road crosses itself, so that it could be in the way there.
  const bool one_ahead = cars > 1 && !road.closed();
  if (one_ahead) cars_.push_back({random.uniform(15.0, 18.0), own_speed_mps, 0.0, 4.0});
  const int oncoming = cars - (one_ahead ? 1 : 0);
  const double their_speed_mps = random.uniform(0.7, 1.2) * std::min(own_speed_mps, 12.0);
  for (int i = 0; i < oncoming; ++i) {
    Car car{0.0, -their_speed_mps, kOtherLane_m, 0.0};
    for (int attempt = 0; attempt < 20; ++attempt) {
      const double meeting_s = options.duration_s * (i + random.uniform(0.35, 0.65)) / oncoming;
      car.start_m = (own_speed_mps + their_speed_mps) * meeting_s;
      if (!road.closed() || !meets_at_crossing(car, options)) {
        cars_.push_back(car);
        break;
      }
    }
  }
}

bool Traffic::meets_at_crossing(const Car& car, const SimulationOptions& options) const {
  constexpr double kStep_s = 0.05;
  for (double t = -0.5; t < options.duration_s + 0.5; t += kStep_s) {
    const Vector2d theirs = road_.point_in_road(along_m(car, t), car.left_m);
    const Vector2d own = road_.point_in_road(along_road_m(options, t) + 1.0);
    if ((theirs - own).norm() < kOtherLane_m - 0.1) return true;
  }
  return false;
}

double Traffic::along_m(const Car& car, double time_s) const {
  return car.start_m + car.speed_mps * time_s + car.sway_m * std::sin(0.6 * time_s);
}

std::vector<Vector2d> Traffic::centres_at(double time_s) const {
  std::vector<Vector2d> centres;
  for (const Car& car : cars_) centres.push_back(road_.point_in_road(along_m(car, time_s), car.left_m));
  return centres;
}

std::vector<Box> Traffic::boxes_at(double time_s, const Vector2d& from, double reach_m) const {
  std::vector<Box> boxes;
  for (const Car& car : cars_) {
    const double along = along_m(car, time_s);
    const Vector2d centre = road_.point_in_road(along, car.left_m);
    if ((centre - from).norm() > reach_m + 3.0) continue;
    for (const Box& box : car_boxes(centre, road_.yaw_rad(along), ground_.height_m(centre.x(), centre.y())))
      boxes.push_back(box);
  }
  return boxes;
}

}  // namespace remount::simulator
