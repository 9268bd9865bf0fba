// Simulated drives as they are written and read again.
#pragma once

#include <string>

#include "model/formats/documents/parse_document.h"
#include "model/formats/documents/transform_document.h"
#include "model/formats/session_readers.h"
#include "model/simulator/simulator.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::simulator {

inline std::filesystem::path drive_in(const formats::TemporaryFolder& folder) { return folder.path() / "drive"; }

inline drive::Session read_back(const SimulatedDrive& drive, const std::string& format,
                                const formats::TemporaryFolder& folder) {
  Progress progress;
  write_drive(drive, drive_in(folder), format, 1, progress);
  return formats::open_session(drive_in(folder), progress);
}

/// Where the sensors are, as truth.yaml says beside a drive that was written.
inline formats::DocumentNode truth_in(const formats::TemporaryFolder& folder) {
  return formats::read_document(drive_in(folder) / "truth.yaml");
}

inline RigidTransform true_mounting(const formats::TemporaryFolder& folder) {
  const formats::DocumentNode root = truth_in(folder);
  return formats::transform_from_document(formats::DocumentView(*root.find("ins_from_lidar"), "truth.yaml"));
}

}  // namespace remount::simulator
