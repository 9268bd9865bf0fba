// Tables of nuScenes that were read before.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "model/formats/sessions/nuscenes_tables.h"

namespace remount::formats {

/// As read_nuscenes_tables and read_ego_poses. Tables of hundreds of megabytes are read for a list of LiDARs, for a
/// choice of scenes and for each session: what was read last is kept and given again as long as their files have the
/// same size and time (files of the last two seconds are read anew), until some time after the last use. Safe from
/// several threads, of which one reads and the others wait, and can be cancelled.
class KeptNuscenes {
 public:
  explicit KeptNuscenes(std::chrono::milliseconds keep_for) : keep_for_(keep_for) {}

  /// Null where it is cancelled.
  std::shared_ptr<const NuscenesTables> tables(const std::filesystem::path& folder, Progress& progress);
  std::shared_ptr<const NuscenesPoses> ego_poses(const std::shared_ptr<const NuscenesTables>& tables,
                                                 Progress& progress);
  /// How many tables were read from their files so far, those of sweeps and of poses each counted once.
  std::size_t readings() const;

 private:
  /// By what it is seen that a file is still the same.
  struct FileState {
    std::uintmax_t bytes = 0;
    std::filesystem::file_time_type written;
    bool operator==(const FileState&) const = default;
  };
  struct Kept {
    std::filesystem::path folder;
    std::vector<FileState> states;
    std::shared_ptr<const NuscenesTables> tables;
    std::shared_ptr<const NuscenesPoses> poses;  ///< null: not read yet
  };

  static std::vector<FileState> states_of(const std::filesystem::path& folder);
  static bool are_settled(const std::vector<FileState>& states);
  /// Forgets those of the folder that are no longer the same.
  std::shared_ptr<const NuscenesTables> find(const std::filesystem::path& folder, const std::vector<FileState>& states);
  Kept find(const std::shared_ptr<const NuscenesTables>& tables);
  void keep(Kept kept);
  void was_used();
  void count_reading();
  void forget(const std::stop_token& stop);

  std::timed_mutex reading_;  ///< of who reads, which may take minutes
  mutable std::mutex mutex_;  ///< of all below, for moments: nothing is read meanwhile
  std::deque<Kept> last_;     ///< the latest first
  std::size_t readings_ = 0;
  std::chrono::milliseconds keep_for_;
  std::chrono::steady_clock::time_point last_used_;
  std::condition_variable_any changed_;
  std::jthread forgetting_;  ///< gives back what nobody asks for; the last: it ends before what it uses
};

/// Those of the program.
KeptNuscenes& kept_nuscenes();

}  // namespace remount::formats
