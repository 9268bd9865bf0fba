// A long drive is answered from the pairs that X needs.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "algorithms/messages/render.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/forwarded_scans.h"
#include "tests/support/peak_memory.h"

namespace remount::testing {
namespace {

double processor_s(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Scans are rendered when they are read: the time that this takes would be the disk's.
class TimedScans final : public ForwardedScans {
 public:
  using ForwardedScans::ForwardedScans;
  cloud::PointCloud load(std::size_t scan) const override {
    const double before_s = processor_s(CLOCK_THREAD_CPUTIME_ID);
    cloud::PointCloud cloud = ForwardedScans::load(scan);
    rendered_s_ = rendered_s_ + processor_s(CLOCK_THREAD_CPUTIME_ID) - before_s;
    ++loaded_;
    return cloud;
  }

  double rendered_s() const { return rendered_s_; }
  std::size_t loaded() const { return loaded_; }

 private:
  mutable std::atomic<double> rendered_s_{0.0};
  mutable std::atomic<std::size_t> loaded_{0};
};

TEST(an_hour_of_driving, is_answered_within_a_minute_on_two_cores_and_two_gigabytes) {
  simulator::SimulationOptions options;
  options.duration_s = 3600.0;
  const simulator::SimulatedDrive drive = simulator::simulate_drive(options);
  const auto scans = std::make_shared<TimedScans>(drive.session.scans);
  auto session = std::make_shared<drive::Session>(drive.session);
  session->scans = scans;
  pipeline::PipelineInput input;
  input.sessions.push_back(session);
  const double begun_s = processor_s(CLOCK_PROCESS_CPUTIME_ID);
  const auto worked_s = [&] { return processor_s(CLOCK_PROCESS_CPUTIME_ID) - begun_s - scans->rendered_s(); };
  double first_answer_s = 0.0;
  input.tell_so_far = [&](const Message& x) {
    if (first_answer_s == 0.0) first_answer_s = worked_s();
    std::printf("  %.1f s: %s\n", worked_s(), english(x).c_str());
  };
  Progress progress;
  const pipeline::PipelineOutput output = pipeline::run_pipeline(input, progress);
  const double whole_s = worked_s();
  const CalibrationError error = error_of(output.result, drive.ins_from_lidar);
  std::printf(
      "  %zu keyframes, %zu pairs, %.1f s of processor time beside %.1f s for rendering %zu scans, peak %.0f MB\n",
      output.keyframes.size(), output.pairs.size(), whole_s, scans->rendered_s(), scans->loaded(), peak_mb());
  for (const calibration::Parameter parameter : calibration::kParameters)
    std::printf("  sigma of %s %.3g\n", std::string(to_string(parameter)).c_str(),
                output.result.estimate(parameter).sigma.value_or(-1.0));
  EXPECT_EQ(output.result.status, calibration::Status::Ok) << english(output.result.message);
  EXPECT_GT(first_answer_s, 0.0);
  EXPECT_LE(first_answer_s, 20.0) << "of processor time, on two cores";
  EXPECT_LE(whole_s, 120.0) << "of processor time, on two cores";
  EXPECT_LT(peak_mb(), 2048.0);
  EXPECT_LE(error.rotation_deg, 0.02);
  EXPECT_LE(std::hypot(error.x_m, error.y_m), 0.005);
}

}  // namespace
}  // namespace remount::testing
