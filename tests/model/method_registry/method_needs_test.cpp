#include "model/method_registry/method_needs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "messages/drives.h"
#include "model/methods/calibrate.h"

namespace remount::method_registry {
namespace {

/// Half a second of the streams whose bits are set.
struct Streams {
  bool scans = false, poses = false, ins = false, gnss = false, wheels = false, imu = false;
};
constexpr unsigned kCombinations = 1U << 6;

Streams streams_of(unsigned bits) {
  const auto bit = [bits](unsigned at) { return (bits >> at & 1U) != 0; };
  return {bit(0), bit(1), bit(2), bit(3), bit(4), bit(5)};
}

/// A few points on three walls.
class TinyScans final : public drive::ScanSource {
 public:
  std::size_t size() const override { return 5; }
  std::int64_t stamp_ns(std::size_t scan) const override { return static_cast<std::int64_t>(scan) * 100'000'000; }
  std::string name(std::size_t scan) const override { return "scan " + std::to_string(scan); }
  cloud::PointCloud load(std::size_t) const override {
    cloud::PointCloud cloud;
    for (int i = 0; i < 10; ++i)
      for (int axis = 0; axis < 3; ++axis) {
        Eigen::Vector3f point(0.5f * static_cast<float>(i), 3.0f, 0.3f * static_cast<float>(i % 4));
        std::swap(point[0], point[axis]);
        cloud.points.push_back(point);
      }
    return cloud;
  }
};

std::shared_ptr<const drive::Session> session_with(const Streams& streams) {
  auto session = std::make_shared<drive::Session>();
  session->name = "drive";
  if (streams.scans) session->scans = std::make_shared<TinyScans>();
  for (int i = 0; i < 5; ++i) {
    const std::int64_t stamp_ns = i * 100'000'000LL;
    if (streams.poses && !streams.scans)
      session->odometry_from_lidar.push_back({stamp_ns, rigid_from_six({0.5 * i, 0, 0, 0, 0, 0})});
    if (streams.ins) session->world_from_ins.push_back({stamp_ns, rigid_from_six({0.5 * i, 0, 0, 0, 0, 0})});
    if (streams.gnss)
      session->gnss.push_back({stamp_ns, 0.8 + 1e-7 * i, 0.1, 100.0, 1e-4 * Eigen::Matrix3d::Identity()});
    if (streams.wheels) {
      motion::WheelSample wheels;
      wheels.stamp_ns = stamp_ns;
      wheels.rear_left_mps = wheels.rear_right_mps = 5.0;
      session->wheels.push_back(wheels);
    }
    if (streams.imu) session->imu.push_back({stamp_ns, Eigen::Vector3d::Zero(), 9.81 * Eigen::Vector3d::UnitZ()});
  }
  return session;
}

std::string refusal(std::string_view method, const std::vector<std::shared_ptr<const drive::Session>>& sessions) {
  pipeline::PipelineInput input;
  input.sessions = sessions;
  input.settings.run.method = MethodChoice(method);
  input.settings.run.map_check = false;
  input.threads = 1;
  Progress progress;
  try {
    methods::calibrate(input, progress);
  } catch (const Error& error) {
    return error.code() == ErrorCode::Unsupported ? error.what() : "";
  }
  return {};
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// What is forecast is what the methods do, whatever streams there are.
TEST(method_needs, a_method_refuses_a_session_exactly_where_it_lacks_something) {
  int refused = 0, served = 0;
  for (unsigned bits = 0; bits < kCombinations; ++bits) {
    if (streams_of(bits).scans && streams_of(bits).poses) continue;  // no session has both
    const std::shared_ptr<const drive::Session> session = session_with(streams_of(bits));
    for (const MethodFit& fit : method_fits(*session)) {
      const std::string id(fit.method->id);
      const std::string said = refusal(id, {session});
      // Where there is no INS the odometry is shown, and the result says that there is none.
      const bool odometry_alone = id == "fusion-odometry" && contains(english(fit.lack), "attitude");
      EXPECT_EQ(said.empty(), fit.serves() || odometry_alone)
          << id << " of streams " << bits << ": \"" << said << "\", foreseen: \"" << fit.lack << "\"";
      // The turn of a machine is looked for among its recordings: that one is refused in words of its own.
      if (!said.empty() && id != "slew") {
        EXPECT_TRUE(contains(said, english(fit.lack))) << said << "\n" << fit.lack;
      }
      ++(fit.serves() ? served : refused);
    }
  }
  std::printf("%d combinations of method and streams serve, %d do not\n", served, refused);
  EXPECT_GT(served, 50);
  EXPECT_GT(refused, 50);
}

TEST(method_needs, a_refusal_names_the_methods_that_take_the_sessions) {
  const auto gnss = session_with({.scans = true, .gnss = true}),
             wheels = session_with({.scans = true, .wheels = true, .imu = true}),
             both = session_with({.scans = true, .gnss = true, .wheels = true, .imu = true}),
             lidar = session_with({.poses = true}), track = session_with({.gnss = true});
  const auto said = [](const std::vector<std::shared_ptr<const drive::Session>>& sessions) {
    return refusal("pairwise", sessions);
  };
  EXPECT_TRUE(contains(said({gnss}), "it can be calibrated with --method trajectory")) << said({gnss});
  EXPECT_FALSE(contains(said({gnss}), "vehicle-frame")) << said({gnss});
  EXPECT_TRUE(contains(said({wheels}), "with --method vehicle-frame")) << said({wheels});
  EXPECT_TRUE(contains(said({both}), "with --method trajectory or vehicle-frame")) << said({both});
  EXPECT_TRUE(contains(said({gnss, wheels}), "name a folder")) << "no method takes both: " << said({gnss, wheels});
  EXPECT_TRUE(contains(said({lidar}), "--method slew for an excavator")) << said({lidar});
  EXPECT_TRUE(contains(said({track}), "neither scans nor LiDAR poses; name a folder")) << said({track});
  EXPECT_FALSE(contains(said({track}), "--method")) << said({track});
}

// An antenna can be placed on a vehicle, and beside a sensor it has nothing to say.
TEST(method_needs, sessions_that_serve_one_by_one_may_not_serve_together) {
  const auto sensor = session_with({.scans = true, .wheels = true, .imu = true}),
             antenna = session_with({.gnss = true, .wheels = true, .imu = true});
  EXPECT_TRUE(contains(refusal("pairwise", {antenna, antenna}), "--method vehicle-frame"));
  for (const auto& sessions : {std::vector{sensor, antenna}, std::vector{antenna, sensor}}) {
    const std::string paired = refusal("pairwise", sessions);
    EXPECT_FALSE(paired.empty() || contains(paired, "--method")) << paired;
    const std::string refused = refusal("vehicle-frame", sessions);
    EXPECT_TRUE(contains(refused, "neither scans nor poses of the sensor")) << refused;
  }
}

TEST(method_needs, the_odometry_names_the_session_without_scans) {
  const auto scans = session_with({.scans = true}), poses = session_with({.poses = true});
  const std::string refused = refusal("fusion-odometry", {scans, poses});
  EXPECT_TRUE(contains(refused, "has no scans")) << refused;
}

TEST(method_needs, every_method_has_needs_and_a_word_for_what_it_leaves_out) {
  for (const CalibrationMethod* method : calibration_methods()) EXPECT_FALSE(method->needs().empty()) << method->id;
  const auto fits = method_fits(*session_with({.gnss = true, .wheels = true, .imu = true}));
  const auto fit_of = [&](std::string_view id) {
    return *std::find_if(fits.begin(), fits.end(), [&](const MethodFit& fit) { return fit.method->id == id; });
  };
  EXPECT_EQ(fit_of("vehicle-frame").limit, say::antenna_place_alone());
  EXPECT_FALSE(fit_of("trajectory").serves());
  EXPECT_FALSE(fit_of("slew").proviso.empty());
}

}  // namespace
}  // namespace remount::method_registry
