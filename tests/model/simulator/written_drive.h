// Simulated drives as they are written and read again.
#pragma once

#include <string>

#include "model/formats/documents/parse_document.h"
#include "model/formats/documents/transform_document.h"
#include "model/formats/session_readers.h"
#include "model/simulator/simulator.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount {

inline std::filesystem::path drive_in(const TemporaryFolder& folder) { return folder.path() / "drive"; }

inline Session read_back(const SimulatedDrive& drive, const std::string& format, const TemporaryFolder& folder) {
  Progress progress;
  write_drive(drive, drive_in(folder), format, 1, progress);
  return open_session(drive_in(folder), progress);
}

/// Where the sensors are, as truth.yaml says beside a drive that was written.
inline DocumentNode truth_in(const TemporaryFolder& folder) { return read_document(drive_in(folder) / "truth.yaml"); }

inline RigidTransform true_mounting(const TemporaryFolder& folder) {
  const DocumentNode root = truth_in(folder);
  return transform_from_document(DocumentView(*root.find("ins_from_lidar"), "truth.yaml"));
}

}  // namespace remount
