// A recording that Remount does not read: its reader makes a session of it. Here the "recording" is a simulated drive.
#include <remount/calibrate.h>
#include <remount/simulation.h>

#include <cstdio>
#include <utility>

namespace api = remount::api;

// Scans are loaded when they are asked for, from several threads at once.
class MyScans final : public api::ScanSource {
 public:
  explicit MyScans(api::Session recorded) : recorded_(std::move(recorded)) {}
  std::size_t size() const override { return recorded_.scan_count(); }
  std::int64_t stamp_ns(std::size_t scan) const override { return recorded_.scan_stamp_ns(scan); }
  api::Scan load(std::size_t scan) const override { return recorded_.load_scan(scan); }

 private:
  api::Session recorded_;
};

api::Recording read_my_format(const api::SimulatedDrive& drive) {
  api::Recording recording;
  recording.name = "my drive";
  recording.world_from_ins = drive.session().local_from_ins();
  recording.scans = std::make_shared<MyScans>(drive.session());
  recording.scan_times = api::ScanTimes::PerPoint;
  return recording;
}

int main() {
  const api::SimulatedDrive drive = api::simulate({{"scenario", "figure-eight"},
                                                   {"duration_s", 8.0},
                                                   {"scan_rate_hz", 5.0},
                                                   {"beams", 16},
                                                   {"azimuth_steps", 200},
                                                   {"moving_objects", 0}});
  const api::Session session = api::make_session(read_my_format(drive));
  api::CalibrateOptions options;
  options.settings.set("run.map_check", false);
  const api::Result result = api::calibrate({session}, options);
  std::printf("%s\n", result.message().english().c_str());
  if (!result.usable()) return 1;
  const api::Matrix4 off = result.ins_from_lidar() - drive.ins_from_lidar();
  std::printf("off by %.3f m in x and y\n", off.topRightCorner<2, 1>().norm());
  return off.topRightCorner<2, 1>().norm() < 0.1 ? 0 : 1;
}
