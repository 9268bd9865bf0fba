#include "tests/widgets/support/sample_world.h"

#include <chrono>
#include <cmath>
#include <random>
#include <thread>

#include "algorithms/core/error.h"
#include "messages/sessions.h"
#include "messages/stages.h"

namespace remount::testing {
namespace {

constexpr int kScans = 60;

RigidTransform world_from_ins(double scan) {
  return rigid_from_six(
      {1.0 * scan, 4.0 * std::sin(0.1 * scan), 0.0, 0.4 * std::cos(0.1 * scan), 0.01 * std::sin(0.5 * scan), 0.0});
}

class StreetScans : public drive::ScanSource {
 public:
  std::size_t size() const override { return kScans; }
  std::int64_t stamp_ns(std::size_t scan) const override {
    return 1'700'000'000'000'000'000 + static_cast<std::int64_t>(scan) * 100'000'000;
  }
  std::string name(std::size_t scan) const override { return "scan" + std::to_string(scan) + ".pcd"; }
  cloud::PointCloud load(std::size_t scan) const override {
    return street_cloud(world_from_ins(static_cast<double>(scan)) * rigid_from_six(kTruth), static_cast<int>(scan));
  }
};

motion::Pair make_pair(int a, int b, const RigidTransform& ins_from_lidar, std::mt19937& random) {
  std::normal_distribution<double> noise(0.0, 1.0);
  motion::Pair pair;
  pair.keyframe_a = index_at<motion::KeyframeIndex>(a);
  pair.keyframe_b = index_at<motion::KeyframeIndex>(b);
  pair.ins_b_from_ins_a = world_from_ins(b).inverse() * world_from_ins(a);
  pair.gap_s = 0.1 * (b - a);
  pair.baseline_m = pair.ins_b_from_ins_a.translation().norm();
  pair.rotation_rad = so3_log(pair.ins_b_from_ins_a.linear()).norm();
  pair.shared_objects = 5 + a % 4;
  pair.moving_objects = a % 9 == 0 ? 1 : 0;
  pair.lidar_b_from_lidar_a = ins_from_lidar.inverse() * pair.ins_b_from_ins_a * ins_from_lidar;
  pair.registration.attempted = pair.registration.converged = true;
  pair.registration.rmse_m = 0.02 + 0.003 * std::abs(noise(random));
  pair.registration.overlap = 0.8 - 0.02 * std::abs(noise(random));
  pair.registration.information.diagonal() << Eigen::Vector3d::Constant(1e4), Eigen::Vector3d::Constant(1e6);
  pair.screw.score = std::abs(noise(random));
  pair.residual_rotation_rad = 4e-4 * std::abs(noise(random));
  pair.residual_translation_m = 0.012 * std::abs(noise(random));
  pair.weight = 1.0 / (1.0 + pair.screw.score * pair.screw.score);
  pair.state = motion::PairState::Accepted;
  pair.decided_by = motion::DecidedBy::Program;
  return pair;
}

void add_candidates(pipeline::PipelineOutput& output) {
  for (int i = 0; i < 12; ++i) {
    calibration::Candidate candidate;
    candidate.source = i == 0 ? calibration::MountingSource::Refined
                              : calibration::MountingSource::pair(index_at<motion::PairIndex>(i));
    candidate.ins_from_lidar = rigid_from_six(
        {kTruth.x_m + 0.01 * i, kTruth.y_m, kTruth.z_m, kTruth.yaw_rad, kTruth.pitch_rad, kTruth.roll_rad});
    candidate.frobenius_sum = 0.5 + 0.1 * i;
    if (i == 0) candidate.ins_from_lidar = output.result.mounting.reference_from_sensor;
    candidate.in_range = i < 9;
    if (!candidate.in_range) candidate.out_of_range = Message::verbatim("x above 0.98 m");
    output.result.candidates.push_back(candidate);
  }
}

void fill_result(pipeline::PipelineOutput& output) {
  calibration::CalibrationResult& result = output.result;
  result.pairs_proposed = static_cast<int>(output.pairs.size());
  result.pairs_accepted = result.pairs_rejected = 0;
  for (const motion::Pair& pair : output.pairs) {
    result.pairs_accepted += pair.state == motion::PairState::Accepted;
    result.pairs_rejected += pair.state == motion::PairState::Rejected;
  }
  result.status = result.pairs_accepted < 3 ? calibration::Status::TooFewPairs : calibration::Status::Degenerate;
  result.message =
      Message::verbatim("Five of six parameters are observed; z keeps its nominal value because the road was flat.");
  result.advice = {Message::verbatim("Drive over a ramp or a speed bump to observe z.")};
  SixParameters six = kTruth;
  six.x_m += 0.001 * (result.pairs_proposed - result.pairs_accepted);
  result.mounting.reference_from_sensor = rigid_from_six(six);
  result.set_observed(~calibration::ParameterSet{calibration::Parameter::Z},
                      Message::verbatim("not shown by this drive"));
  result.covariance.setZero();
  result.covariance.diagonal() << 4e-6, 4e-6, std::nan(""), 1e-8, 1e-8, 1e-8;
  result.directions = {{Vector6d::Unit(2), std::numeric_limits<double>::infinity(), false,
                        Message::verbatim("height z: not observable, flat driving")}};
  result.frobenius_sum = 0.5;
  result.translation_rms_m = 0.011;
  result.rotation_rms_rad = 3e-4;
  result.time_offset = {0.012, 0.001, false};
}

void solve(pipeline::PipelineOutput& output) {
  fill_result(output);
  output.result.candidates.clear();
  add_candidates(output);
}

calibration::ResultDifference sample_difference(double yaw_sigmas) {
  constexpr double kNot = std::numeric_limits<double>::quiet_NaN();
  constexpr double kSigmas[] = {0.004, 0.004, kNot, 2e-4, 2e-4, 2e-4};
  const double differences[] = {0.002, -0.004, kNot, yaw_sigmas * 2e-4, -1e-5, 0.0};
  calibration::ResultDifference out;
  for (const calibration::Parameter parameter : calibration::kParameters) {
    out.difference[parameter] = differences[calibration::row_of(parameter)];
    out.sigma[parameter] = kSigmas[calibration::row_of(parameter)];
  }
  return out;
}

class SamplePairs : public pipeline::PairSource {
 public:
  SamplePairs(pipeline::PipelineInput input, std::shared_ptr<const pipeline::PipelineOutput> output)
      : input_(std::move(input)), output_(std::move(output)) {}
  pipeline::PairClouds load(motion::PairIndex pair, const Progress&) const override {
    const motion::Pair& chosen = output_->pairs.at(pair);
    pipeline::KeyframeScan scan_a, scan_b;
    pipeline::PairClouds clouds;
    scan_a.cloud = input_.sessions.at(0)->scans->load(output_->keyframes[chosen.keyframe_a].scan);
    scan_b.cloud = input_.sessions.at(0)->scans->load(output_->keyframes[chosen.keyframe_b].scan);
    for (int i = 0; i < 4; ++i) {
      cloud::SceneObject b;
      b.centroid_in_lidar = Eigen::Vector3f(6.0F * i - 9.0F, i % 2 ? 8.0F : -8.0F, 0.0F);
      b.box_min_in_lidar = b.centroid_in_lidar - Eigen::Vector3f(0.4F, 0.4F, 1.5F);
      b.box_max_in_lidar = b.centroid_in_lidar + Eigen::Vector3f(0.4F, 0.4F, 2.5F);
      for (std::size_t k = 0; k < scan_b.cloud.size(); ++k)
        if ((scan_b.cloud.points[k] - b.centroid_in_lidar).norm() < 2.5F) b.points.push_back(static_cast<int>(k));
      cloud::SceneObject a = b;
      a.points.clear();
      const Eigen::Vector3f in_a =
          (chosen.lidar_b_from_lidar_a.inverse() * b.centroid_in_lidar.cast<double>()).cast<float>();
      a.centroid_in_lidar = in_a;
      a.box_min_in_lidar = in_a - Eigen::Vector3f(0.4F, 0.4F, 1.5F);
      a.box_max_in_lidar = in_a + Eigen::Vector3f(0.4F, 0.4F, 2.5F);
      scan_a.objects.push_back(a);
      scan_b.objects.push_back(b);
      clouds.matches.push_back({index_at(i), index_at(i), i == 3, i == 3 ? 1.2 : 0.05});
    }
    clouds.scan_a = std::make_shared<const pipeline::KeyframeScan>(std::move(scan_a));
    clouds.scan_b = std::make_shared<const pipeline::KeyframeScan>(std::move(scan_b));
    return clouds;
  }
  bool serves(const pipeline::PipelineInput& input, const pipeline::PipelineOutput& output) const override {
    return input.sessions == input_.sessions && output.pairs.size() == output_->pairs.size();
  }

 private:
  pipeline::PipelineInput input_;
  std::shared_ptr<const pipeline::PipelineOutput> output_;
};

}  // namespace

cloud::PointCloud street_cloud(const RigidTransform& world_from_lidar, int seed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::normal_distribution<double> noise(0.0, 0.015);
  cloud::PointCloud cloud;
  const RigidTransform lidar_from_world = world_from_lidar.inverse();
  const Eigen::Vector3d here = world_from_lidar.translation();
  const auto add = [&](double x, double y, double z) {
    const Eigen::Vector3d point_in_lidar = lidar_from_world * Eigen::Vector3d(x, y, z);
    if (point_in_lidar.norm() > 2.0 && point_in_lidar.norm() < 40.0)
      cloud.points.push_back(
          (point_in_lidar + Eigen::Vector3d(noise(random), noise(random), noise(random))).cast<float>());
  };
  for (int i = 0; i < 12000; ++i) {
    const double radius = 3.0 + 35.0 * unit(random) * unit(random), turn = 2.0 * kPi * unit(random);
    add(here.x() + radius * std::cos(turn), here.y() + radius * std::sin(turn), -1.2);
  }
  for (int i = 0; i < 9000; ++i)
    add(here.x() + 70.0 * (unit(random) - 0.5), unit(random) < 0.5 ? 14.0 : -14.0, -1.2 + 7.0 * unit(random));
  for (int pole = -4; pole < 14; ++pole)
    for (int i = 0; i < 120; ++i) add(7.0 * pole, pole % 2 ? 9.0 : -9.0, -1.2 + 5.0 * unit(random));
  for (int car = -2; car < 7; ++car)
    for (int i = 0; i < 400; ++i)
      add(13.0 * car + 4.2 * unit(random), 11.0 + (i % 2 ? 0.0 : 1.7 * unit(random)), -1.2 + 1.5 * unit(random));
  return cloud;
}

drive::Session sample_session(const std::string& name) {
  drive::Session session;
  session.name = name;
  session.path = "/data/" + name;
  session.format = "native";
  session.ins.resize(10 * kScans);
  for (std::size_t i = 0; i < session.ins.size(); ++i)
    session.ins[i].stamp_ns = 1'700'000'000'000'000'000 + static_cast<std::int64_t>(i) * 10'000'000;
  for (std::size_t i = 0; i < session.ins.size(); ++i) {
    constexpr double kEarthRadius_m = 6371000.0;
    const RigidTransform pose = world_from_ins(0.1 * static_cast<double>(i));
    session.ins[i].latitude_rad = 0.8 + pose.translation().y() / kEarthRadius_m;
    session.ins[i].longitude_rad = 0.2 + pose.translation().x() / (kEarthRadius_m * std::cos(0.8));
    session.ins[i].enu_from_ins = Eigen::Quaterniond(pose.linear());
    session.ins[i].quality = i > 300 && i < 340 ? motion::InsQuality::Degraded : motion::InsQuality::Good;
    session.ins[i].sigma.position_enu_m.setConstant(i > 300 && i < 340 ? 0.2 : 0.02);
    session.ins[i].sigma.attitude_rad.setConstant(5e-4);
  }
  session.scans = std::make_shared<StreetScans>();
  session.findings = {{drive::Severity::Warning, "ins-gap", std::string("ins.csv:212"),
                       Message::verbatim("0.4 s without INS samples; the 3 scans in it are left out.")}};
  return session;
}

pipeline::PipelineOutput sample_output(const pipeline::PipelineInput& input, int pairs) {
  std::mt19937 random(7);
  pipeline::PipelineOutput output;
  output.map_check = pipeline::MapCheck::NoOverlap;
  const auto& scans = *input.sessions.at(0)->scans;
  for (int i = 0; i < kScans; ++i)
    output.keyframes.push_back({motion::SessionIndex{0}, index_at<motion::ScanIndex>(i),
                                scans.stamp_ns(static_cast<std::size_t>(i)), 1.0 * i});
  const RigidTransform truth = rigid_from_six(kTruth);
  for (int i = 0; i < pairs; ++i) {
    motion::Pair pair = make_pair(i % (kScans - 4), i % (kScans - 4) + 1 + i % 4, truth, random);
    if (i % 7 == 3) {
      pair.state = motion::PairState::Rejected;
      pair.reason = Message::verbatim("screw test: translation along the axis differs by 0.47 m (9.1 sigma)");
      pair.screw.score = 9.1;
      pair.screw.passed = false;
      pair.residual_translation_m = 0.12;
      pair.weight = 0.0;
    }
    if (i >= pairs - 2) pair.state = motion::PairState::Proposed, pair.decided_by = motion::DecidedBy::Nobody;
    output.pairs.push_back(pair);
  }
  output.initial_ins_from_lidar =
      input.nominal_ins_from_lidar.value_or(rigid_from_six({0.7, -0.1, 0.75, 0.06, -0.02, 0.015}));
  output.nominal_known = input.nominal_ins_from_lidar.has_value();
  fill_result(output);
  add_candidates(output);
  return output;
}

pipeline::HoldOut sample_hold_out(int sessions, double yaw_sigmas) {
  pipeline::HoldOut found;
  for (int s = 0; s < sessions; ++s) {
    pipeline::SessionAlone alone;
    alone.result.status = calibration::Status::Degenerate;
    alone.result.set_observed(
        s == 0 ? calibration::ParameterSet::all() : ~calibration::ParameterSet{calibration::Parameter::Z},
        Message::verbatim("not shown by this drive"));
    alone.pairs = 120 + s;
    alone.own = alone.common = {3e-4, 0.011};
    found.sessions.push_back(alone);
  }
  for (motion::SessionIndex a; a < found.sessions.size(); ++a)
    for (motion::SessionIndex b; b < found.sessions.size(); ++b) {
      if (a == b) continue;
      found.scores.push_back(
          {a,
           b,
           {4e-4, 0.013},
           a > 0 ? calibration::ParameterSet{calibration::Parameter::Z} : calibration::ParameterSet{}});
      if (a < b) found.differences.push_back({sample_difference(yaw_sigmas), a, b});
    }
  return found;
}

gui::Engine sample_engine(int stages, std::shared_ptr<const std::atomic<int>> hold_at) {
  gui::Engine engine;
  engine.open = [](const std::filesystem::path& path, const drive::TopicChoice&, Progress&) {
    if (path.string().find("drive") == std::string::npos)
      throw Error(ErrorCode::Format, path.string(),
                  say::session_unknown({Message::verbatim("native: a folder with session.yaml")}));
    return sample_session(path.filename().string());
  };
  engine.run = [stages, hold_at](const pipeline::PipelineInput& input, Progress& progress) {
    for (int i = 0; i < stages; ++i) {
      // Again and again: of reports that follow each other closely, some are left out.
      do {
        progress.report(say::stage_registering_pairs, static_cast<std::size_t>(i), static_cast<std::size_t>(stages));
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      } while (hold_at && *hold_at == i && !progress.cancelled());
      if (!progress.cancelled()) continue;
      pipeline::PipelineOutput output = sample_output(input, 50);
      output.result = {};
      output.result.status = calibration::Status::Cancelled;
      const auto finished = static_cast<std::size_t>(50 * i / stages);
      for (std::size_t pair = finished; pair < output.pairs.size(); ++pair) {
        output.pairs[pair].registration = {};
        output.pairs[pair].state = motion::PairState::Proposed;
        output.pairs[pair].decided_by = motion::DecidedBy::Nobody;
      }
      return output;
    }
    pipeline::PipelineOutput output = sample_output(input, 50);
    if (pipeline::apply_verdicts(input.verdicts, output) > 0) solve(output);
    return output;
  };
  engine.solve_again = [](const pipeline::PipelineInput&, pipeline::PipelineOutput& output, Progress&) {
    solve(output);
    return true;
  };
  engine.open_pairs = [](const pipeline::PipelineInput& input, std::shared_ptr<const pipeline::PipelineOutput> output) {
    return std::make_shared<const SamplePairs>(input, std::move(output));
  };
  engine.load_map_scans = [](const pipeline::PipelineInput& input, const pipeline::PipelineOutput& output,
                             motion::SessionIndex session, std::size_t most, Progress& progress) {
    pipeline::SessionScans map;
    const drive::ScanSource& scans = *input.sessions.at(session)->scans;
    for (std::size_t i = 0; i < output.keyframes.size() && !progress.cancelled(); i += 6) {
      progress.report(say::stage_reading_scans_for_the_map, i, output.keyframes.size());
      const motion::ScanIndex scan = output.keyframes[i].scan;
      map.scans.points_in_lidar.push_back(scans.load(scan).points);
      map.scans.local_from_ins.push_back(world_from_ins(static_cast<double>(signed_of(scan))));
      map.points_recorded += map.scans.points_in_lidar.back().size();
    }
    return map.points_recorded > most ? pipeline::SessionScans{} : map;
  };
  engine.load_keyframe_scan = [](const pipeline::PipelineInput& input, const pipeline::PipelineOutput& output,
                                 motion::KeyframeIndex keyframe, Progress&) {
    const motion::Keyframe& chosen = output.keyframes.at(keyframe);
    return input.sessions.at(chosen.session)->scans->load(chosen.scan);
  };
  engine.check_hold_out = [](const pipeline::PipelineInput& input, const pipeline::PipelineOutput&, Progress&) {
    return sample_hold_out(static_cast<int>(input.sessions.size()));
  };
  return engine;
}

}  // namespace remount::testing
