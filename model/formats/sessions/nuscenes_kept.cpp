#include "model/formats/sessions/nuscenes_kept.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

/// By what it is seen that a file is still the same.
struct FileState {
  std::uintmax_t bytes = 0;
  fs::file_time_type written;
  bool operator==(const FileState&) const = default;
};

std::vector<FileState> states_of(const fs::path& folder) {
  std::vector<FileState> states;
  for (const char* table : kNuscenesTables) {
    const fs::path file = folder / (std::string(table) + ".json");
    std::error_code unknown;
    FileState& state = states.emplace_back();
    state.bytes = fs::file_size(file, unknown);
    state.written = fs::last_write_time(file, unknown);
  }
  return states;
}

/// Times of files come in steps, and of one that was just written another may follow with the same.
bool are_settled(const std::vector<FileState>& states) {
  constexpr std::chrono::seconds kSettles(2);
  const auto now = fs::file_time_type::clock::now();
  return std::all_of(states.begin(), states.end(),
                     [&](const FileState& state) { return state.written + kSettles < now; });
}

struct Kept {
  fs::path folder;
  std::vector<FileState> states;
  std::shared_ptr<const NuscenesTables> tables;
  std::shared_ptr<const NuscenesPoses> poses;  ///< null: not read yet
};

/// What is kept, and a thread that gives it back some time after the last use.
class KeptTables {
 public:
  std::mutex mutex;
  std::deque<Kept> last;  ///< the latest first
  std::size_t readings = 0;
  std::chrono::milliseconds keep_for = std::chrono::minutes(2);

  /// With `mutex` locked.
  void was_used() {
    last_used_ = std::chrono::steady_clock::now();
    if (!forgetting_.joinable()) forgetting_ = std::jthread([this](const std::stop_token& stop) { forget(stop); });
    changed_.notify_all();
  }

 private:
  void forget(const std::stop_token& stop) {
    std::unique_lock<std::mutex> lock(mutex);
    while (!stop.stop_requested()) {
      if (last.empty())
        changed_.wait(lock, stop, [this] { return !last.empty(); });
      else if (std::chrono::steady_clock::now() >= last_used_ + keep_for)
        last.clear();
      else
        changed_.wait_until(lock, stop, last_used_ + keep_for, [before = last_used_, by = keep_for, this] {
          return last_used_ != before || keep_for != by;
        });
    }
  }

  std::condition_variable_any changed_;
  std::chrono::steady_clock::time_point last_used_;
  std::jthread forgetting_;  ///< the last: it ends before what it uses
};

KeptTables& kept_tables() {
  static KeptTables kept;
  return kept;
}

/// Not owned where the waiting was cancelled.
std::unique_lock<std::mutex> lock_or_cancelled(std::mutex& mutex, const Progress& progress) {
  std::unique_lock<std::mutex> lock(mutex, std::try_to_lock);
  while (!lock.owns_lock() && !progress.cancelled()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    (void)lock.try_lock();
  }
  return lock;
}

}  // namespace

std::shared_ptr<const NuscenesTables> kept_nuscenes_tables(const fs::path& tables, Progress& progress) {
  constexpr std::size_t kMostKept = 2;  // v1.0-mini beside v1.0-trainval
  KeptTables& kept = kept_tables();
  const std::unique_lock<std::mutex> lock = lock_or_cancelled(kept.mutex, progress);
  if (!lock.owns_lock()) return nullptr;
  const fs::path folder = fs::absolute(tables).lexically_normal();
  const std::vector<FileState> states = states_of(folder);
  const auto before =
      std::find_if(kept.last.begin(), kept.last.end(), [&](const Kept& one) { return one.folder == folder; });
  if (before != kept.last.end() && before->states == states) {
    kept.was_used();
    return before->tables;
  }
  if (before != kept.last.end()) kept.last.erase(before);
  std::shared_ptr<const NuscenesTables> read = read_nuscenes_tables(tables, progress);
  if (!read) return nullptr;
  ++kept.readings;
  if (!are_settled(states)) return read;
  kept.last.push_front({folder, states, read, nullptr});
  if (kept.last.size() > kMostKept) kept.last.pop_back();
  kept.was_used();
  return read;
}

std::shared_ptr<const NuscenesPoses> kept_ego_poses(const std::shared_ptr<const NuscenesTables>& tables,
                                                    Progress& progress) {
  KeptTables& kept = kept_tables();
  const std::unique_lock<std::mutex> lock = lock_or_cancelled(kept.mutex, progress);
  if (!lock.owns_lock()) return nullptr;
  const auto of_these =
      std::find_if(kept.last.begin(), kept.last.end(), [&](const Kept& one) { return one.tables == tables; });
  if (of_these != kept.last.end()) kept.was_used();
  if (of_these != kept.last.end() && of_these->poses) return of_these->poses;
  std::shared_ptr<const NuscenesPoses> read = read_ego_poses(*tables, progress);
  if (!read) return nullptr;
  ++kept.readings;
  if (of_these != kept.last.end()) of_these->poses = read, kept.was_used();
  return read;
}

std::chrono::milliseconds keep_nuscenes_for(std::chrono::milliseconds time) {
  KeptTables& kept = kept_tables();
  const std::scoped_lock lock(kept.mutex);
  const std::chrono::milliseconds before = std::exchange(kept.keep_for, time);
  kept.was_used();
  return before;
}

std::size_t nuscenes_readings() {
  KeptTables& kept = kept_tables();
  const std::scoped_lock lock(kept.mutex);
  return kept.readings;
}

}  // namespace remount::formats
