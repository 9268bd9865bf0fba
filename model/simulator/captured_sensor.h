// Sensors that spin, whose packets somebody captures beside an INS's log. Adding one is a file that defines it, its
// declaration here and a line in drive_formats.cpp. They are written apart from the decoders of their packets, or an
// error in one would hide in the other.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/simulator/captured_datagrams.h"
#include "model/simulator/packet_shots.h"
#include "model/simulator/simulator.h"

namespace remount::simulator {

struct CapturedSensor {
  std::string_view format;  ///< as drives are asked for
  std::string_view model;   ///< for messages
  /// How many packets a drive takes.
  std::size_t (*packets)(const SimulationOptions& options);
  /// Of a packet, since the start of the drive.
  double (*begins_s)(const SimulationOptions& options, std::size_t packet);
  std::vector<PacketReturn> (*returns)(const Scene& scene, std::size_t packet);
  SentDatagram (*datagram)(const Scene& scene, std::size_t packet);

  /// What the sensor sends with the sentence of the receiver whose clock it follows; null: nothing.
  SentDatagram (*told_by_receiver)(const motion::InsSample& sample) = nullptr;
  std::size_t samples_between = 1;  ///< of the INS, from one of these to the next

  /// What the maker has lie beside a capture, under its name but for another ending; null: nothing.
  std::string (*description)(const SimulationOptions& options) = nullptr;
  std::string_view description_ending = {};
};

extern const CapturedSensor kPuck;          ///< a VLP-16 of Velodyne
extern const CapturedSensor kHdl64;         ///< an HDL-64E of Velodyne, with its calibration
extern const CapturedSensor kOusterHead;    ///< an OS1 with 32 beams, whose clock follows PTP
extern const CapturedSensor kHesaiSpinner;  ///< a PandarXT-32, whose clock has the date
extern const CapturedSensor kHelios;        ///< an RS-Helios of RoboSense

/// The world of a drive whose LiDAR such a sensor stands in for. Throws Error(Contract) for a drive that is not
/// simulated, or turns slower or faster than such sensors do.
const Scene& scene_without_lidar(const SimulatedDrive& drive, const CapturedSensor& sensor);

/// All that the sensor sends, in the order of a recording. What is not made when `progress` is cancelled is empty.
std::vector<SentDatagram> sent_datagrams(const CapturedSensor& sensor, const SimulatedDrive& drive, int threads,
                                         const Progress& progress);

/// A capture of the packets of a sensor that stands where the drive's LiDAR does, in its place, with its description
/// beside it, and the NMEA log. Throws as scene_without_lidar does.
void write_capture(const CapturedSensor& sensor, const SimulatedDrive& drive, const std::filesystem::path& folder,
                   int threads, Progress& progress);

}  // namespace remount::simulator
