// FLEET.yaml: the calibrations of many vehicles, each a job that can be run by itself, on this machine or another.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "model/drive/topic_choice.h"
#include "model/settings/settings.h"

namespace remount::fleet {

/// When a change between two calibrations of one vehicle is called drift: where it exceeds both.
struct DriftLimits {
  double sigmas = 3.5;  ///< times the combined sigma of the two
  double translation_m = 0.02;
  double rotation_deg = 0.2;
};

/// One calibration: the sessions of one list, solved together.
struct FleetJob {
  std::size_t vehicle = 0;  ///< index into Fleet::vehicles
  std::string name;         ///< for people, of the sessions as they are written in the file
  std::vector<std::filesystem::path> sessions;
  std::filesystem::path result;   ///< what the job makes
  std::filesystem::path failure;  ///< text that is there where it could not make one
  std::filesystem::path log;      ///< of its last run
  std::filesystem::path lock;     ///< held while it runs
};

struct FleetVehicle {
  std::string name;
  settings::Settings settings;  ///< of the fleet, changed by those of the vehicle
  drive::TopicChoice topics;    ///< of bags: those of the fleet, changed by those of the vehicle
  std::string nominal;          ///< as --nominal takes it; empty: as the sessions declare it
  std::filesystem::path last;   ///< a calibration from before the first job; empty: none is known
  /// The calibration that the mounting is judged by, whatever came since; empty: the oldest that is known.
  std::filesystem::path reference;
};

struct Fleet {
  std::filesystem::path path;     ///< the file
  std::filesystem::path results;  ///< folder of what is made
  DriftLimits drift;
  std::vector<FleetVehicle> vehicles;
  std::vector<FleetJob> jobs;  ///< by vehicle; those of one vehicle from the oldest to the newest
};

/// Paths come back absolute; nothing but the file itself is opened, so that one missing session fails one job.
/// Throws Error(Io) where it cannot be read, Error(Format) with file, line and expectation.
Fleet load_fleet(const std::filesystem::path& path);

/// "vehicle, session".
std::string title_of(const Fleet& fleet, const FleetJob& job);

/// Makes the folder that the job writes into. Throws Error(Io).
void make_job_folder(const FleetJob& job);

}  // namespace remount::fleet
