// How soon the long calls return once they are cancelled. The bound is on processor time, which other programs on the
// machine do not lengthen, and generous; the figures are printed. REMOUNT_CANCEL_MOMENTS=40 tries that many moments.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <random>
#include <string>
#include <thread>

#include "algorithms/calibration/pairwise/robust_start.h"
#include "algorithms/messages/render.h"
#include "algorithms/motion/keyframes.h"
#include "algorithms/motion/pairing.h"
#include "algorithms/registration/registration.h"
#include "algorithms/search/certified_search.h"
#include "model/pipeline/pipeline.h"
#include "model/pipeline/register_stage.h"
#include "model/simulator/simulator.h"
#include "tests/support/draws.h"
#include "tests/support/kept_scans.h"
#include "tests/support/sanitized.h"

namespace remount::pipeline {
namespace {

constexpr double kBound_ms = 250.0 * testing::kSanitizerSlowdown, kHanging_ms = 10000.0 * testing::kSanitizerSlowdown;

double cpu_ms() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double wall_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int moments_or(int standard) {
  const char* wanted = std::getenv("REMOUNT_CANCEL_MOMENTS");
  return wanted ? std::max(1, std::atoi(wanted)) : standard;
}

// Cancels `body` at random moments of its run and expects it back soon. It returns whether its result is said, or seen,
// to be incomplete; one that finishes within a moment of being asked need not be.
template <class Body>
void expect_back_soon(const char* what, int moments, const Body& body) {
  Progress whole;
  const double begin_ms = wall_ms();
  EXPECT_FALSE(body(whole)) << what << " says that it was cancelled, and was not";
  const double full_ms = wall_ms() - begin_ms;
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> share(0.0, 0.9);
  std::vector<double> wall, cpu;
  int said = 0;
  // A short call on a busy machine is done before many moments: until one comes in time.
  for (int k = 0; k < moments || (said == 0 && k < 20 * moments); ++k) {
    std::stop_source stop;
    std::string doing;
    Progress progress(stop.get_token(), [&](const ProgressUpdate& update) {
      doing = english(update.stage()) + " " + std::to_string(update.done) + "/" + std::to_string(update.total);
    });
    double back_wall_ms = 0.0, back_cpu_ms = 0.0;
    bool says_so = false;
    const double started_ms = wall_ms();
    std::thread worker([&] {
      says_so = body(progress);
      back_wall_ms = wall_ms();
      back_cpu_ms = cpu_ms();
    });
    std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(share(random) * full_ms));
    const double asked_wall_ms = wall_ms(), asked_cpu_ms = cpu_ms();
    stop.request_stop();
    worker.join();
    if (back_wall_ms <= asked_wall_ms) continue;  // it was done before
    wall.push_back(back_wall_ms - asked_wall_ms);
    cpu.push_back(back_cpu_ms - asked_cpu_ms);
    said += says_so;
    EXPECT_LT(cpu.back(), kBound_ms) << what << ", while " << doing << ", after " << asked_wall_ms - started_ms
                                     << " ms";
    constexpr double kMoment_ms = 5.0 * testing::kSanitizerSlowdown;
    EXPECT_TRUE(says_so || cpu.back() < kMoment_ms)
        << what << ": worked on for " << cpu.back() << " ms, and says nothing";
  }
  ASSERT_GT(said, 0) << what << " takes " << full_ms << " ms and was never cancelled, or never says so";
  std::sort(wall.begin(), wall.end());
  std::sort(cpu.begin(), cpu.end());
  std::printf(
      "%-40s takes %7.0f ms; cancelled %2zu times: wall median %5.1f max %5.1f ms, cpu median %5.1f max %5.1f ms\n",
      what, full_ms, wall.size(), wall[wall.size() / 2], wall.back(), cpu[cpu.size() / 2], cpu.back());
  EXPECT_LT(wall.back(), kHanging_ms) << what;
}

const simulator::SimulatedDrive& dense_street() {
  static const simulator::SimulatedDrive drive = [] {
    simulator::SimulationOptions options;
    options.scan_rate_hz = 2.0;
    options.duration_s = 2.0;
    options.azimuth_steps = 2000;
    return testing::simulate_drive(options);
  }();
  return drive;
}

/// All of its scans are cast, so that the first run takes as long as those that are cancelled.
simulator::SimulatedDrive street_in_memory() {
  simulator::SimulationOptions options;
  options.beams = 32;
  options.azimuth_steps = 600;
  options.duration_s = 6.0;
  simulator::SimulatedDrive drive = testing::simulate_drive(options);
  for (std::size_t i = 0; i < drive.session.scans->size(); ++i) drive.session.scans->load(i);
  return drive;
}

std::vector<motion::Pair> random_pairs(int count) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  const auto vector = [&](double sigma) -> Eigen::Vector3d {  // not an expression of what is gone by then
    return sigma * Eigen::Vector3d(normal(random), normal(random), normal(random));
  };
  const RigidTransform x = rigid_from_six({1.0, 0.2, 1.5, 0.3, 0.02, -0.01});
  std::vector<motion::Pair> pairs;
  for (int i = 0; i < count; ++i) {
    motion::Pair pair;
    pair.ins_b_from_ins_a = make_rigid(so3_exp(vector(0.2)), vector(3.0));
    const RigidTransform exact = x.inverse() * pair.ins_b_from_ins_a * x;
    pair.lidar_b_from_lidar_a = i % 3 == 0 ? make_rigid(so3_exp(vector(0.3)), vector(3.0))
                                           : make_rigid(so3_exp(vector(1e-3)) * exact.linear(), exact.translation());
    pair.registration.attempted = pair.registration.converged = true;
    pair.registration.information = 1e4 * Matrix6d::Identity();
    pairs.push_back(pair);
  }
  return pairs;
}

TEST(cancelling, the_preparation_of_a_large_scan) {
  const cloud::PointCloud cloud = dense_street().session.scans->load(0);
  ASSERT_GT(cloud.size(), 90000U);
  expect_back_soon("preparing a scan", moments_or(10), [&](Progress& progress) {
    return registration::PreparedCloud(cloud, {}, {}, progress).size() == 0;
  });
}

TEST(cancelling, an_alignment_and_its_equations) {
  const auto& scans = *dense_street().session.scans;
  const registration::PreparedCloud a(scans.load(0), {}), b(scans.load(1), {});
  const RigidTransform far = make_rigid(so3_exp({0.1, 0.2, 0.4}), {-3.0, 3.0, 0.5});
  const RigidTransform near = make_rigid(Eigen::Matrix3d::Identity(), {-2.5, 0, 0});
  const auto align = [&](const RigidTransform& start, const Progress& progress) {
    return motion::is_cancelled(registration::align_scans(a, b, start, {}, progress).quality);
  };
  expect_back_soon("aligning from far away", moments_or(10), [&](Progress& progress) { return align(far, progress); });
  expect_back_soon("aligning", moments_or(10), [&](Progress& progress) { return align(near, progress); });
  expect_back_soon("alignment equations", moments_or(10), [&](Progress& progress) {
    int done = 0;
    while (done < 5 && registration::alignment_equations(a, b, RigidTransform::Identity(), 0.5, progress).overlap > 0.0)
      ++done;
    return done < 5;
  });
}

TEST(cancelling, many_pairs_on_two_workers) {
  ONLY_IN_LONG_TESTS();
  const simulator::SimulatedDrive drive = street_in_memory();
  const DriveMotion motion({std::make_shared<drive::Session>(drive.session)});
  const settings::Settings settings;
  const std::vector<motion::Keyframe> keyframes =
      motion::select_keyframes(motion::SessionIndex{0}, motion.lidar_stamps_ns(motion::SessionIndex{0}),
                               motion.track(motion::SessionIndex{0}), 0.0, settings.keyframes);
  std::vector<RigidTransform> poses;
  for (const calibration::JointNode& node : motion.nodes(keyframes)) poses.push_back(node.local_from_ins);
  const std::vector<motion::Pair> pairs = motion::propose_pairs(keyframes, poses, settings.pairing);
  const StageContext context{motion, settings, keyframes, drive.ins_from_lidar, 2};
  expect_back_soon("registering pairs", moments_or(10), [&](Progress& progress) {
    ScanStore scans(motion, settings.registration, std::size_t{256} << 20);
    scans.compensate_motion(drive.ins_from_lidar, {true});
    std::vector<motion::Pair> mine = pairs;
    std::vector<KeyframeObjects> objects;
    find_keyframe_objects(context, scans, mine, objects, progress);
    register_pairs(context, scans, objects, mine, progress);
    return std::any_of(mine.begin(), mine.end(), [](const motion::Pair& pair) {
      return motion::is_cancelled(pair.registration) || (!pair.registration.attempted && english(pair.reason).empty());
    });
  });
}

TEST(cancelling, the_robust_start_and_the_certified_search) {
  const std::vector<motion::Pair> pairs = random_pairs(2000);
  std::vector<motion::PairIndex> all;
  for (motion::PairIndex i; i < pairs.size(); ++i) all.push_back(i);
  expect_back_soon("robust start, 2000 pairs", moments_or(10), [&](Progress& progress) {
    calibration::robust_start(pairs, all, calibration::NoiseModel{}, std::nullopt, {}, Eigen::Vector3d::Zero(),
                              progress);
    return progress.cancelled();  // what is known until then is no error; solve_pairwise says that it was cancelled
  });
  std::vector<search::MotionPair> motions;
  for (const motion::Pair& pair : pairs) motions.push_back({pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, 1.0});
  const search::QuadraticForm form(motions, 10.0);
  expect_back_soon("certified search", moments_or(10), [&](Progress& progress) {
    search::SearchResult last;
    for (int i = 0; i < 20 && last.outcome != search::SearchOutcome::Cancelled; ++i)
      last = search::certified_search(form, calibration::SearchRange{}, RigidTransform::Identity(), {}, progress);
    EXPECT_TRUE(last.outcome == search::SearchOutcome::Certified || last.outcome == search::SearchOutcome::Cancelled)
        << english(last.message);
    return last.outcome == search::SearchOutcome::Cancelled;
  });
}

TEST(cancelling, a_whole_calibration) {
  PipelineInput input;
  input.sessions.push_back(std::make_shared<drive::Session>(street_in_memory().session));
  input.threads = 2;
  expect_back_soon("calibrating a street", moments_or(6), [&](Progress& progress) {
    return run_pipeline(input, progress).result.status == calibration::Status::Cancelled;
  });
}

}  // namespace
}  // namespace remount::pipeline
