#include "app/cli/group_limits.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace remount::cli {
namespace {

namespace fs = std::filesystem;

/// Version 1 says so where it means no limit: the largest number, rounded down to a page.
constexpr std::uint64_t kUnlimitedBytes = 1ULL << 62U;

/// The folder of a group, and those of the groups that hold it, up to the mount.
struct GroupFolders {
  bool version_2 = false;
  std::vector<fs::path> folders;
};

std::vector<fs::path> folders_up(const fs::path& mount, std::string_view group) {
  const fs::path below = fs::path(group).relative_path().lexically_normal();
  if (!below.empty() && *below.begin() == "..") return {};  // it lies outside of what this namespace shows
  std::vector<fs::path> folders;
  for (fs::path at = below; !at.empty() && at != "."; at = at.parent_path()) folders.push_back(mount / at);
  folders.push_back(mount);
  return folders;
}

bool lists(std::string_view names, std::string_view name) {
  for (std::size_t begin = 0; begin <= names.size();) {
    const std::size_t end = std::min(names.find(',', begin), names.size());
    if (names.substr(begin, end - begin) == name) return true;
    begin = end + 1;
  }
  return false;
}

/// Lines are "ID:CONTROLLERS:GROUP"; that of version 2 is "0::GROUP".
GroupFolders group_folders(const fs::path& root, std::string_view controller) {
  const fs::path mount = root / "sys/fs/cgroup";
  GroupFolders found;
  std::ifstream lines(root / "proc/self/cgroup");
  std::string line;
  while (std::getline(lines, line)) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string_view all = line, controllers = all.substr(first + 1, second - first - 1);
    if (lists(controllers, controller)) return {false, folders_up(mount / controller, all.substr(second + 1))};
    if (all.starts_with("0::")) found = {true, folders_up(mount, all.substr(second + 1))};
  }
  return found;
}

std::string first_word_of(const fs::path& file) {
  std::ifstream words(file);
  std::string word;
  words >> word;
  return word;
}

std::optional<std::uint64_t> whole_number(const std::string& text) {
  std::uint64_t number = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
  return end.ec == std::errc() ? std::optional(number) : std::nullopt;
}

Limit memory_of_group(const fs::path& root) {
  const GroupFolders group = group_folders(root, "memory");
  Limit limit;
  std::error_code none;
  // The group that holds all has no limit, and no file of one.
  if (group.version_2 && !group.folders.empty())
    limit.known = fs::exists(group.folders.front() / "cgroup.controllers", none);
  for (const fs::path& folder : group.folders) {
    const std::string word = first_word_of(folder / (group.version_2 ? "memory.max" : "memory.limit_in_bytes"));
    if (word.empty()) continue;
    limit.known = true;
    const auto bytes = whole_number(word);
    if (bytes && *bytes < kUnlimitedBytes) limit.most = std::min(*bytes, limit.most.value_or(*bytes));
  }
  return limit;
}

std::optional<double> processors_of_group(const fs::path& root) {
  const GroupFolders group = group_folders(root, "cpu");
  std::optional<double> fewest;
  for (const fs::path& folder : group.folders) {
    double quota = 0.0, period = 0.0;  // "max", or -1 in version 1, where there is no limit
    if (group.version_2) {
      std::ifstream(folder / "cpu.max") >> quota >> period;
    } else {
      std::ifstream(folder / "cpu.cfs_quota_us") >> quota;
      std::ifstream(folder / "cpu.cfs_period_us") >> period;
    }
    if (quota > 0.0 && period > 0.0) fewest = std::min(quota / period, fewest.value_or(quota / period));
  }
  return fewest;
}

}  // namespace

GroupLimits limits_of_group(const fs::path& root) { return {memory_of_group(root), processors_of_group(root)}; }

}  // namespace remount::cli
