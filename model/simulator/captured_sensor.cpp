#include "model/simulator/captured_sensor.h"

#include "algorithms/core/error.h"
#include "algorithms/core/parallel.h"
#include "messages/simulation.h"
#include "model/formats/files/output_file.h"
#include "model/simulator/captured_datagrams.h"
#include "model/simulator/drive_formats.h"
#include "model/simulator/lidar_model.h"

namespace remount::simulator {

const Scene& scene_without_lidar(const SimulatedDrive& drive, const CapturedSensor& sensor) {
  constexpr double kSlowest_hz = 5.0, kFastest_hz = 20.0;
  const std::string format(sensor.format), model(sensor.model);
  const Scene* scene = scene_of(drive.session.scans);
  if (scene == nullptr) throw Error(ErrorCode::Contract, format, say::simulation_capture_not_simulated(model));
  const double rate_hz = scene->options().scan_rate_hz;
  if (rate_hz < kSlowest_hz || rate_hz > kFastest_hz)
    throw Error(
        ErrorCode::Contract, format,
        say::simulation_capture_rate(model, Frequency{kSlowest_hz}, Frequency{kFastest_hz}, Frequency{rate_hz}));
  return *scene;
}

std::vector<SentDatagram> sent_datagrams(const CapturedSensor& sensor, const SimulatedDrive& drive, int threads,
                                         const Progress& progress) {
  const Scene& scene = scene_without_lidar(drive, sensor);
  const SimulationOptions& options = scene.options();
  std::vector<SentDatagram> packets(sensor.packets(options)), sent;
  parallel_for(packets.size(), threads, [&](std::size_t packet) {
    if (!progress.cancelled()) packets[packet] = sensor.datagram(scene, packet);
  });
  const std::vector<motion::InsSample>& ins = drive.session.ins;
  std::size_t sample = 0;
  for (std::size_t packet = 0; packet < packets.size(); ++packet) {
    const std::int64_t stamp_ns = lidar_stamp_ns(scene, sensor.begins_s(options, packet));
    for (; sensor.told_by_receiver && sample < ins.size() && ins[sample].stamp_ns < stamp_ns;
         sample += sensor.samples_between)
      sent.push_back(sensor.told_by_receiver(ins[sample]));
    sent.push_back(std::move(packets[packet]));
  }
  return sent;
}

void write_capture(const CapturedSensor& sensor, const SimulatedDrive& drive, const std::filesystem::path& folder,
                   int threads, Progress& progress) {
  const SimulationOptions& options = scene_without_lidar(drive, sensor).options();
  std::string capture = capture_head();
  for (const SentDatagram& sent : sent_datagrams(sensor, drive, threads, progress)) capture += captured_datagram(sent);
  if (!write_receiver_log(drive, folder, progress)) return;
  formats::write_file(folder / "capture.pcap", capture);
  if (sensor.description)
    formats::write_file(folder / ("capture" + std::string(sensor.description_ending)), sensor.description(options));
}

}  // namespace remount::simulator
