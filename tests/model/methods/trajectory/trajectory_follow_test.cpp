// A session that is written while it is read.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <thread>

#include "algorithms/messages/render.h"
#include "model/formats/session_readers.h"
#include "model/formats/sessions/native_session_writer.h"
#include "model/method_registry/calibration_method.h"
#include "model/methods/trajectory/trajectory_feed.h"
#include "model/methods/trajectory/trajectory_method.h"
#include "model/pipeline/pipeline.h"
#include "model/simulator/simulator.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::methods {
namespace {

namespace fs = std::filesystem;

/// A native session of LiDAR poses and an INS.
void write_poses(const fs::path& folder) {
  simulator::SimulationOptions options;
  options.duration_s = 40.0;
  options.ins_position_noise_m = 0.02;
  options.ins_attitude_noise_deg = 0.05;
  const simulator::SimulatedDrive drive = simulator::simulate_drive(options);
  drive::Session session = drive.session;
  session.scans.reset();
  session.imu.clear();
  session.gnss.clear();
  session.wheels.clear();
  session.barometer.clear();
  for (std::size_t i = 0; i < drive.enu_from_ins.size(); ++i)
    session.odometry_from_lidar.push_back(
        {drive.session.scans->stamp_ns(i), (drive.enu_from_ins[0].pose * drive.ins_from_lidar).inverse() *
                                               drive.enu_from_ins[i].pose * drive.ins_from_lidar});
  Progress progress;
  formats::write_native_session(session, folder, 1, progress);
}

/// Writes the files of `from` into `to` piece by piece, cutting lines anywhere.
void write_in_pieces(const fs::path& from, const fs::path& to, int pieces, const std::atomic<int>& answers) {
  fs::create_directories(to);
  std::vector<std::pair<fs::path, std::string>> files;
  for (const char* name : {"session.yaml", "ins.csv", "lidar_poses.txt"})
    files.emplace_back(name, formats::bytes_of(from / name));
  std::ofstream(to / "session.yaml", std::ios::binary) << files[0].second;
  for (int piece = 0; piece < pieces; ++piece) {
    for (std::size_t k = 1; k < files.size(); ++k) {
      const std::string& bytes = files[k].second;
      // A prime apart from the lines' lengths: pieces end within lines.
      const auto cut = [&](int i) {
        return i == pieces ? bytes.size()
                           : bytes.size() * static_cast<std::size_t>(i) / static_cast<std::size_t>(pieces) / 7 * 7;
      };
      std::ofstream file(to / files[k].first, std::ios::binary | std::ios::app);
      file << bytes.substr(cut(piece), cut(piece + 1) - cut(piece));
    }
    // The next piece when the last has led to an answer, or after a while: what the test sees does not hang on time.
    const int before = answers;
    for (int i = 0; i < 50 && answers == before; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

TEST(trajectory_follow, a_growing_session_is_answered_on_the_way_and_ends_as_the_batch) {
  const formats::TemporaryFolder folder;
  const fs::path whole = folder.path() / "whole", growing = folder.path() / "growing";
  write_poses(whole);
  std::atomic<int> answers = 0;
  std::vector<calibration::TrajectorySnapshot> told;
  std::jthread writer([&] { write_in_pieces(whole, growing, 12, answers); });
  Progress following, finishing;
  FollowOptions options;
  options.poll_s = 0.02;
  options.settled_s = 3.0;
  const auto tell = [&](const calibration::TrajectorySnapshot& snapshot) {
    told.push_back(snapshot);
    ++answers;
  };
  const FollowedSession followed = follow_trajectory(growing, {}, options, tell, following, finishing);
  writer.join();
  pipeline::PipelineInput input;
  Progress progress;
  input.sessions.push_back(std::make_shared<drive::Session>(formats::open_session(whole, progress)));
  const pipeline::PipelineOutput batch = method_registry::calibration_method("trajectory").run(input, progress);
  EXPECT_EQ(followed.output.result.status, batch.result.status) << english(followed.output.result.message);
  EXPECT_EQ(followed.output.result.mounting.reference_from_sensor.matrix(),
            batch.result.mounting.reference_from_sensor.matrix());
  std::printf("  %zu answers on the way\n", told.size());
  EXPECT_GE(told.size(), 35u);
  for (std::size_t i = 1; i < told.size(); ++i) EXPECT_GT(told[i].time_s, told[i - 1].time_s);
  EXPECT_TRUE(told.back().known);
  EXPECT_LT(
      (told.back().mounting.ins_from_lidar().translation() - batch.result.mounting.reference_from_sensor.translation())
          .head<2>()
          .norm(),
      0.02);
}

TEST(trajectory_follow, goes_on_where_the_recording_is_begun_again) {
  const formats::TemporaryFolder folder;
  const fs::path whole = folder.path() / "whole", growing = folder.path() / "growing";
  write_poses(whole);
  std::atomic<int> answers = 0;
  std::jthread writer([&] {
    fs::copy(whole, growing, fs::copy_options::recursive);
    while (answers < 5) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    // The new one has fewer samples than the first for longer than a recording may stand still.
    for (const char* name : {"ins.csv", "lidar_poses.txt"}) fs::resize_file(growing / name, 0);
    for (int piece = 1; piece <= 10; ++piece) {
      for (const char* name : {"ins.csv", "lidar_poses.txt"}) {
        const std::string bytes = formats::bytes_of(whole / name);
        std::ofstream(growing / name, std::ios::binary)
            << bytes.substr(0, bytes.size() * static_cast<std::size_t>(piece) / 10);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
    }
  });
  Progress following, finishing;
  FollowOptions options;
  options.poll_s = 0.02;
  options.settled_s = 1.0;
  const FollowedSession followed = follow_trajectory(
      growing, {}, options, [&](const calibration::TrajectorySnapshot&) { ++answers; }, following, finishing);
  pipeline::PipelineInput input;
  Progress progress;
  input.sessions.push_back(std::make_shared<drive::Session>(formats::open_session(whole, progress)));
  EXPECT_EQ(followed.session->ins.size(), input.sessions[0]->ins.size()) << "it ended before the recording";
  const calibration::CalibrationResult batch =
      method_registry::calibration_method("trajectory").run(input, progress).result;
  EXPECT_EQ(followed.output.result.mounting.reference_from_sensor.matrix(), batch.mounting.ins_from_lidar().matrix());
}

TEST(trajectory_follow, ends_at_once_when_it_is_stopped_and_still_solves) {
  const formats::TemporaryFolder folder;
  write_poses(folder.path() / "whole");
  std::stop_source stop;
  Progress following(stop.get_token()), finishing;
  FollowOptions options;
  options.settled_s = 3600.0;
  const auto tell = [&](const calibration::TrajectorySnapshot& snapshot) {
    if (snapshot.known) stop.request_stop();
  };
  const FollowedSession followed = follow_trajectory(folder.path() / "whole", {}, options, tell, following, finishing);
  EXPECT_TRUE(followed.output.result.known[calibration::Parameter::X].observed)
      << english(followed.output.result.message);
}

/// Scans of a session that was written anew: at other times, and none can be read.
class OtherScans final : public drive::ScanSource {
 public:
  explicit OtherScans(std::shared_ptr<const ScanSource> before) : before_(std::move(before)) {}
  std::size_t size() const override { return before_->size(); }
  std::int64_t stamp_ns(std::size_t scan) const override { return before_->stamp_ns(scan) + 1'000'000; }
  std::string name(std::size_t scan) const override { return before_->name(scan); }
  cloud::PointCloud load(std::size_t scan) const override {
    throw Error(ErrorCode::Io, name(scan), Message::verbatim("is gone"));
  }

 private:
  std::shared_ptr<const ScanSource> before_;
};

TEST(trajectory_follow, a_session_whose_scans_were_replaced_in_the_end_is_read_anew) {
  simulator::SimulationOptions options;
  options.duration_s = 4.0;
  options.beams = 16;
  options.azimuth_steps = 200;
  const simulator::SimulatedDrive drive = simulator::simulate_drive(options);
  TrajectoryFeed feed({}, std::nullopt, 0);
  feed.begin(drive.session);
  Progress progress;
  int answers = 0;
  const auto tell = [&](const calibration::TrajectorySnapshot&) { ++answers; };
  feed.offer(drive.session, false, 0.0, tell, progress);
  ASSERT_GT(answers, 0) << "nothing was learnt on the way";
  drive::Session replaced = drive.session;
  replaced.scans = std::make_shared<OtherScans>(drive.session.scans);
  feed.offer(replaced, true, 0.0, tell, progress);
  EXPECT_EQ(feed.odometry().back().unreadable, replaced.scans->size());
  EXPECT_TRUE(feed.odometry().back().poses.empty());
  replaced.scans.reset();
  EXPECT_ERROR(feed.offer(replaced, true, 0.0, tell, progress), "none any more");
}

TEST(trajectory_follow, a_session_that_never_comes_is_an_error) {
  const formats::TemporaryFolder folder;
  Progress following, finishing;
  FollowOptions options;
  options.settled_s = 0.05;
  options.poll_s = 0.02;
  EXPECT_ERROR(follow_trajectory(folder.path() / "nothing", {}, options, {}, following, finishing), "nothing");
}

}  // namespace
}  // namespace remount::methods
