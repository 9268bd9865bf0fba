// FLEET.yaml: the calibrations of many vehicles, each a job that can be run by itself, on this machine or another.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
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
  /// LiDARs that are calibrated together, as `--lidars` takes them: "all", or names with commas in between; empty: one,
  /// as the sessions suggest it or a topic says. With any, and be it one, the result is that of a vehicle.
  std::string lidars;
  std::filesystem::path result;   ///< what the job makes
  std::filesystem::path failure;  ///< text that is there where it could not make one
  std::filesystem::path log;      ///< of its last run
  std::filesystem::path lock;     ///< held while it runs
};

/// Results that a vehicle's jobs are compared with: one file, of one LiDAR or of several by their names, or files by
/// the names of LiDARs.
struct EarlierFiles {
  std::filesystem::path file;
  std::map<std::string, std::filesystem::path> of_lidars;

  /// Empty where there is none.
  const std::filesystem::path& of(const std::string& lidar) const {
    const auto own = of_lidars.find(lidar);
    return own == of_lidars.end() ? file : own->second;
  }
};

struct FleetVehicle {
  std::string name;
  settings::Settings settings;  ///< of the fleet, changed by those of the vehicle
  drive::TopicChoice topics;    ///< of bags: those of the fleet, changed by those of the vehicle
  /// As --nominal takes it; empty: as the sessions declare it. Of jobs with LiDARs a file that holds their mountings by
  /// names, or "none".
  std::string nominal;
  std::map<std::string, std::string> nominal_of_lidars;  ///< by their names; of the others as the sessions declare it
  EarlierFiles last;  ///< calibrations from before the first job; empty: none is known
  /// Those that the mountings are judged by, whatever came since; empty: the oldest that is known.
  EarlierFiles reference;
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

/// What the vehicle says of nominals, in one line: "front=1,2,3,0,0,0; rear=/data/rear.yaml". Empty where it says
/// nothing.
std::string nominal_text(const FleetVehicle& vehicle);

/// Makes the folder that the job writes into. Throws Error(Io).
void make_job_folder(const FleetJob& job);

}  // namespace remount::fleet
