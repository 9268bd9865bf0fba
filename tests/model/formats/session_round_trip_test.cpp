// Sessions in every layout, settings, results and projects read back as they were written: random ones with the edges
// of their types.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "algorithms/messages/render.h"
#include "model/formats/sessions/native_session_reader.h"
#include "model/formats/sessions/native_session_writer.h"
#include "model/project/project.h"
#include "model/settings/settings_file.h"
#include "tests/model/formats/bags/bag_fixtures.h"
#include "tests/model/formats/cloud_comparison.h"
#include "tests/model/formats/random_values.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kSessionStamp_ns = 1'600'000'000'123'456'789;

// ---- Sessions

class MadeScans final : public drive::ScanSource {
 public:
  explicit MadeScans(std::vector<cloud::PointCloud> clouds) : clouds_(std::move(clouds)) {}
  std::size_t size() const override { return clouds_.size(); }
  std::int64_t stamp_ns(std::size_t scan) const override {
    return kSessionStamp_ns + static_cast<std::int64_t>(scan) * 100'000'007;
  }
  std::string name(std::size_t scan) const override { return std::to_string(scan); }
  cloud::PointCloud load(std::size_t scan) const override { return clouds_[scan]; }

 private:
  std::vector<cloud::PointCloud> clouds_;
};

template <class Item, class Fill>
std::vector<Item> items(RandomValues& random, Fill&& fill) {
  std::vector<Item> list(random.below(4) == 0 ? 0 : 2 + random.below(30));
  std::int64_t stamp_ns = kSessionStamp_ns;
  for (Item& item : list) {
    item.stamp_ns = stamp_ns += 1 + static_cast<std::int64_t>(random.below(50'000'000));
    fill(item);
  }
  return list;
}

Eigen::Vector3d vector(RandomValues& random, double size) {
  return {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
}

void fill_place(RandomValues& random, double& latitude_rad, double& longitude_rad, double& height_m) {
  latitude_rad = 0.85 + random.between(-1e-4, 1e-4);
  longitude_rad = -2.1 + random.between(-1e-4, 1e-4);
  height_m = random.between(-400.0, 9000.0);
}

/// Any layout of Remount's own folders: an INS of either kind, scans with any columns or poses, sensors or none.
drive::Session made_session(RandomValues& random) {
  drive::Session session;
  session.name = random.text();
  const bool timed = random.flip();
  if (random.flip()) {
    std::vector<cloud::PointCloud> clouds;
    const bool intensity = random.flip(), ring = random.flip();
    for (int i = 0; i < 3; ++i) {
      clouds.push_back(random.cloud(20, intensity, ring, timed));
      clouds.back().points[0] = {1.0F, 2.0F, 3.0F};  // no scan without a point
    }
    session.scans = std::make_shared<MadeScans>(clouds);
    session.scan_timing = timed           ? drive::ScanTiming::PerPoint
                          : random.flip() ? drive::ScanTiming::Instant
                                          : drive::ScanTiming::SweepAzimuth;
    session.sweep = {random.between(0.05, 0.2), random.between(-3.0, 3.0), random.flip(), random.flip()};
  } else {
    do
      session.odometry_from_lidar =
          items<motion::StampedPose>(random, [&](motion::StampedPose& p) { p.pose = random.rigid(); });
    while (session.odometry_from_lidar.empty());
  }
  if (random.flip()) {
    do
      session.ins = items<motion::InsSample>(random, [&](motion::InsSample& sample) {
        fill_place(random, sample.latitude_rad, sample.longitude_rad, sample.height_m);
        sample.enu_from_ins = random.attitude();
        sample.quality = random.flip() ? motion::InsQuality::Good : motion::InsQuality::Degraded;
      });
    while (session.ins.empty());
  } else {
    do
      session.world_from_ins =
          items<motion::StampedPose>(random, [&](motion::StampedPose& p) { p.pose = random.rigid(); });
    while (session.world_from_ins.empty());
  }
  session.imu = items<motion::ImuSample>(random, [&](motion::ImuSample& sample) {
    sample.angular_rate_radps = vector(random, 3.0), sample.specific_force_mps2 = vector(random, 30.0);
  });
  session.gnss = items<motion::GnssFix>(random, [&](motion::GnssFix& fix) {
    fill_place(random, fix.latitude_rad, fix.longitude_rad, fix.height_m);
    fix.covariance_enu_m2 = vector(random, 1.0).cwiseAbs().asDiagonal();
  });
  session.wheels = items<motion::WheelSample>(random, [&](motion::WheelSample& sample) {
    sample.rear_left_mps = random.between(-20.0, 40.0), sample.rear_right_mps = random.flip() ? -0.0 : 1.0 / 3.0;
  });
  session.barometer = items<motion::BarometerSample>(
      random, [&](motion::BarometerSample& sample) { sample.height_m = random.between(-400.0, 9000.0); });
  if (random.flip()) session.nominal_ins_from_lidar = random.rigid();
  if (random.flip()) session.ins_position_white_sigma_m = random.between(1e-6, 1.0);
  return session;
}

template <class Item, class Same>
void expect_all(const std::vector<Item>& read, const std::vector<Item>& written, const char* what, Same&& same) {
  ASSERT_EQ(read.size(), written.size()) << what;
  for (std::size_t i = 0; i < read.size(); ++i) {
    ASSERT_EQ(read[i].stamp_ns, written[i].stamp_ns) << what << " " << i;
    const double off = same(read[i], written[i]);
    ASSERT_LT(off, 1e-9) << what << " " << i;
  }
}

double apart(const motion::StampedPose& a, const motion::StampedPose& b) {
  return (a.pose.matrix() - b.pose.matrix()).norm();
}

void expect_same_session(const drive::Session& read, const drive::Session& written) {
  EXPECT_EQ(read.name, written.name);
  expect_all(read.ins, written.ins, "INS", [](const motion::InsSample& a, const motion::InsSample& b) {
    return 6.4e6 * (std::abs(a.latitude_rad - b.latitude_rad) + std::abs(a.longitude_rad - b.longitude_rad)) * 1e-1 +
           std::abs(a.height_m - b.height_m) + a.enu_from_ins.angularDistance(b.enu_from_ins) * 1e-2 +
           (a.quality == b.quality ? 0.0 : 1.0);
  });
  expect_all(read.world_from_ins, written.world_from_ins, "INS poses", apart);
  expect_all(read.odometry_from_lidar, written.odometry_from_lidar, "LiDAR poses", apart);
  expect_all(read.imu, written.imu, "IMU", [](const motion::ImuSample& a, const motion::ImuSample& b) {
    return (a.angular_rate_radps - b.angular_rate_radps).norm() +
           (a.specific_force_mps2 - b.specific_force_mps2).norm();
  });
  expect_all(read.gnss, written.gnss, "GNSS", [](const motion::GnssFix& a, const motion::GnssFix& b) {
    return (a.covariance_enu_m2 - b.covariance_enu_m2).norm() + std::abs(a.latitude_rad - b.latitude_rad) +
           std::abs(a.longitude_rad - b.longitude_rad) + std::abs(a.height_m - b.height_m);
  });
  expect_all(read.wheels, written.wheels, "wheels", [](const motion::WheelSample& a, const motion::WheelSample& b) {
    return std::abs(a.rear_left_mps - b.rear_left_mps) + std::abs(a.rear_right_mps - b.rear_right_mps);
  });
  expect_all(read.barometer, written.barometer, "barometer",
             [](const motion::BarometerSample& a, const motion::BarometerSample& b) {
               return std::abs(a.height_m - b.height_m);
             });
  ASSERT_EQ(read.nominal_ins_from_lidar.has_value(), written.nominal_ins_from_lidar.has_value());
  if (read.nominal_ins_from_lidar) {
    EXPECT_LT(difference(*read.nominal_ins_from_lidar, *written.nominal_ins_from_lidar).norm(), 1e-12);
  }
  ASSERT_EQ(read.scans != nullptr, written.scans != nullptr);
  for (std::size_t i = 0; read.scans && i < written.scans->size(); ++i) {
    EXPECT_EQ(read.scans->stamp_ns(i), written.scans->stamp_ns(i));
    expect_same(read.scans->load(i), written.scans->load(i), "scan " + std::to_string(i));
  }
}

TEST(session_round_trip, native_sessions_of_every_layout) {
  RandomValues random(14);
  Progress progress;
  for (int draw = 0; draw < 40; ++draw) {
    SCOPED_TRACE("draw " + std::to_string(draw));
    const TemporaryFolder folder;
    const drive::Session written = made_session(random);
    write_native_session(written, folder.path() / "fahrt № 一", 1, progress);
    drive::Session read;
    const std::string problem =
        error_of([&] { read = NativeSessionReader().open(folder.path() / "fahrt № 一", progress); });
    ASSERT_EQ(problem, "");
    expect_same_session(read, written);
  }
}

// ---- Documents

/// Any value within its bounds.
struct AnySetting {
  RandomValues& random;
  void operator()(const OptionInfo&, bool& value) { value = random.flip(); }
  void operator()(const OptionInfo& info, int& value) {
    value = static_cast<int>(std::floor(random.between(info.minimum, info.maximum)));
  }
  void operator()(const OptionInfo& info, double& value) { value = random.between(info.minimum, info.maximum); }
  void operator()(const OptionInfo&, std::string&) {}  // names of methods, which have tests of their own
  template <class T>
  void choice(const OptionInfo&, T& value, const std::vector<std::string_view>& names) {
    value = static_cast<T>(random.below(names.size()));
  }
};

TEST(session_round_trip, settings_with_any_values) {
  RandomValues random(15);
  const TemporaryFolder folder;
  for (int draw = 0; draw < 60; ++draw) {
    settings::Settings settings;
    settings::Settings::visit_sections(settings, [&](std::string_view, auto& section) {
      std::decay_t<decltype(section)>::visit(section, AnySetting{random});
    });
    const std::string text = settings::settings_text(settings, random.flip());
    EXPECT_EQ(settings::settings_text(settings::load_settings(folder.write("s.yaml", text))),
              settings::settings_text(settings))
        << text;
  }
}

results::ResultFile any_result(RandomValues& random) {
  results::ResultFile file;
  calibration::CalibrationResult& result = file.result;
  result.status = random.flip() ? calibration::Status::Ok : calibration::Status::Degenerate;
  result.message = Message::verbatim(random.text());
  for (std::size_t i = random.below(3); i > 0; --i) result.advice.push_back(Message::verbatim(random.text()));
  result.mounting.reference_from_sensor = random.rigid();
  for (std::size_t i = 0; i < 6; ++i) result.known[calibration::kParameters[i]].observed = random.flip();
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < 6; ++k) {
      const bool known =
          result.known[calibration::kParameters[i]].observed && result.known[calibration::kParameters[k]].observed;
      result.covariance(i, k) = !known ? std::nan("") : i == k ? random.between(1e-12, 1.0) : 0.0;
    }
  result.frobenius_sum = random.between(0.0, 1e6);
  result.time_offset = {random.between(-1.0, 1.0), random.between(0.0, 1.0), random.flip()};
  if (random.flip()) file.nominal_ins_from_lidar = random.rigid();
  for (std::size_t i = random.below(4); i > 0; --i)
    file.findings.push_back({drive::Severity::Warning, "code", random.text(), Message::verbatim(random.text())});
  for (std::size_t i = random.below(3); i > 0; --i)
    file.inputs.push_back({random.text(), random.text(), random.below(1000), std::string(64, 'a')});
  return file;
}

TEST(session_round_trip, results_in_yaml_and_json) {
  RandomValues random(16);
  const TemporaryFolder folder;
  for (int draw = 0; draw < 60; ++draw)
    for (const char* name : {"r.yaml", "r.json"}) {
      const results::ResultFile written = any_result(random);
      results::save_result(written, folder.path() / name);
      const results::ResultFile read = results::load_result(folder.path() / name);
      EXPECT_EQ(to_yaml(results::result_document(read)), to_yaml(results::result_document(written)))
          << name << ", draw " << draw;
      EXPECT_LT(
          (read.result.mounting.reference_from_sensor.matrix() - written.result.mounting.reference_from_sensor.matrix())
              .norm(),
          1e-14);
    }
}

TEST(session_round_trip, projects) {
  RandomValues random(17);
  for (int draw = 0; draw < 30; ++draw) {
    const TemporaryFolder folder;
    project::Project written;
    for (std::size_t i = random.below(4); i > 0; --i)
      written.sessions.push_back(folder.path() / ("s" + std::to_string(i) + random.text()));
    if (random.flip()) written.nominal_ins_from_lidar = random.rigid();
    for (std::size_t i = random.below(5); i > 0 && !written.sessions.empty(); --i)
      written.verdicts.push_back({motion::SessionIndex(random.below(written.sessions.size())),
                                  kSessionStamp_ns + static_cast<std::int64_t>(i), kSessionStamp_ns + 1'000'000'000,
                                  random.flip() ? motion::PairState::Accepted : motion::PairState::Rejected,
                                  Message::verbatim(random.text())});
    written.settings.pairing.max_gap_s = random.between(0.5, 5.0);
    project::save_project(written, folder.path() / "one.remount");
    const project::Project read = project::load_project(folder.path() / "one.remount");
    ASSERT_EQ(read.sessions.size(), written.sessions.size());
    for (std::size_t i = 0; i < read.sessions.size(); ++i)
      EXPECT_EQ(fs::absolute(read.sessions[i]).lexically_normal(), written.sessions[i].lexically_normal());
    ASSERT_EQ(read.verdicts.size(), written.verdicts.size());
    for (std::size_t i = 0; i < read.verdicts.size(); ++i)
      EXPECT_EQ(english(read.verdicts[i].reason), english(written.verdicts[i].reason));
    EXPECT_EQ(settings::settings_text(read.settings), settings::settings_text(written.settings));
    project::save_project(read, folder.path() / "two.remount");
    EXPECT_EQ(bytes_of(folder.path() / "one.remount"), bytes_of(folder.path() / "two.remount"));
  }
}

}  // namespace
}  // namespace remount::formats
