// Drives with known truth.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "remount/matrices.h"
#include "remount/progress.h"
#include "remount/session.h"
#include "remount/settings.h"

namespace remount::simulator {
struct SimulatedDrive;
}  // namespace remount::simulator

namespace remount::api {

/// What can be simulated, with its defaults; as `remount-cli simulate` has it.
std::vector<Option> simulation_options();

/// Immutable. Scans are cast when they are loaded.
class SimulatedDrive {
 public:
  explicit SimulatedDrive(std::shared_ptr<const simulator::SimulatedDrive> drive);

  Session session() const;
  Matrix4 ins_from_lidar() const;          ///< the truth
  std::vector<Pose> enu_from_ins() const;  ///< likewise, at the scans' stamps

  const simulator::SimulatedDrive& inside() const { return *drive_; }  ///< for Remount itself

 private:
  std::shared_ptr<const simulator::SimulatedDrive> drive_;
};

/// @param options by name: {"scenario", "figure-eight"}, {"duration_s", 10.0}; others have their defaults
/// @param ins_from_lidar the true mounting; nothing: a usual one
/// Throws Error(Contract) for an option that is none or out of range.
SimulatedDrive simulate(const std::map<std::string, OptionValue>& options = {},
                        const std::optional<Matrix4>& ins_from_lidar = {});

std::vector<std::string> drive_formats();

/// As a folder that open_session reads, with truth.yaml. Throws Error(Io), Error(Contract) for a folder that is not
/// empty and for a format that is none.
void write_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, const std::string& format = "native",
                 const Progress& progress = Progress());

}  // namespace remount::api
