#include "model/formats/sessions/nuscenes_kept.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

/// Not owned where the waiting was cancelled.
std::unique_lock<std::timed_mutex> lock_or_cancelled(std::timed_mutex& mutex, const Progress& progress) {
  std::unique_lock<std::timed_mutex> lock(mutex, std::try_to_lock);
  while (!lock.owns_lock() && !progress.cancelled()) (void)lock.try_lock_for(std::chrono::milliseconds(10));
  return lock;
}

}  // namespace

std::vector<KeptNuscenes::FileState> KeptNuscenes::states_of(const fs::path& folder) {
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
bool KeptNuscenes::are_settled(const std::vector<FileState>& states) {
  constexpr std::chrono::seconds kSettles(2);
  const auto now = fs::file_time_type::clock::now();
  return std::all_of(states.begin(), states.end(),
                     [&](const FileState& state) { return state.written + kSettles < now; });
}

std::shared_ptr<const NuscenesTables> KeptNuscenes::tables(const fs::path& folder, Progress& progress) {
  const std::unique_lock<std::timed_mutex> reading = lock_or_cancelled(reading_, progress);
  if (!reading.owns_lock()) return nullptr;
  const fs::path whole = fs::absolute(folder).lexically_normal();
  std::vector<FileState> states = states_of(whole);
  if (auto before = find(whole, states)) return before;
  std::shared_ptr<const NuscenesTables> read = read_nuscenes_tables(folder, progress);
  if (!read) return nullptr;
  count_reading();
  if (are_settled(states)) keep({whole, std::move(states), read, nullptr});
  return read;
}

std::shared_ptr<const NuscenesPoses> KeptNuscenes::ego_poses(const std::shared_ptr<const NuscenesTables>& tables,
                                                             Progress& progress) {
  const std::unique_lock<std::timed_mutex> reading = lock_or_cancelled(reading_, progress);
  if (!reading.owns_lock()) return nullptr;
  Kept of_these = find(tables);
  if (of_these.poses) return of_these.poses;
  std::shared_ptr<const NuscenesPoses> read = read_ego_poses(*tables, progress);
  if (!read) return nullptr;
  count_reading();
  of_these.poses = read;
  if (of_these.tables) keep(std::move(of_these));
  return read;
}

std::size_t KeptNuscenes::readings() const {
  const std::scoped_lock lock(mutex_);
  return readings_;
}

void KeptNuscenes::count_reading() {
  const std::scoped_lock lock(mutex_);
  ++readings_;
}

std::shared_ptr<const NuscenesTables> KeptNuscenes::find(const fs::path& folder, const std::vector<FileState>& states) {
  const std::scoped_lock lock(mutex_);
  std::erase_if(last_, [&](const Kept& one) { return one.folder == folder && one.states != states; });
  const auto found = std::ranges::find(last_, folder, &Kept::folder);
  if (found == last_.end()) return nullptr;
  was_used();
  return found->tables;
}

KeptNuscenes::Kept KeptNuscenes::find(const std::shared_ptr<const NuscenesTables>& tables) {
  const std::scoped_lock lock(mutex_);
  const auto found = std::ranges::find(last_, tables, &Kept::tables);
  if (found == last_.end()) return {};
  was_used();
  return *found;
}

/// The time for which it is kept begins anew.
void KeptNuscenes::was_used() {
  last_used_ = std::chrono::steady_clock::now();
  changed_.notify_all();
}

void KeptNuscenes::keep(Kept kept) {
  constexpr std::size_t kMostKept = 2;  // v1.0-mini beside v1.0-trainval
  const std::scoped_lock lock(mutex_);
  std::erase_if(last_, [&](const Kept& one) { return one.folder == kept.folder; });
  last_.push_front(std::move(kept));
  if (last_.size() > kMostKept) last_.pop_back();
  was_used();
  if (!forgetting_.joinable()) forgetting_ = std::jthread([this](const std::stop_token& stop) { forget(stop); });
}

void KeptNuscenes::forget(const std::stop_token& stop) {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!stop.stop_requested()) {
    if (last_.empty())
      changed_.wait(lock, stop, [this] { return !last_.empty(); });
    else if (std::chrono::steady_clock::now() >= last_used_ + keep_for_)
      last_.clear();
    else
      changed_.wait_until(lock, stop, last_used_ + keep_for_,
                          [before = last_used_, this] { return last_used_ != before; });
  }
}

KeptNuscenes& kept_nuscenes() {
  static KeptNuscenes kept(std::chrono::minutes(2));
  return kept;
}

}  // namespace remount::formats
