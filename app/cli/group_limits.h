// What control groups (cgroups, of containers and of services) leave to this process.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace remount::cli {

/// So many at most; none where it is known that there is no limit, which is not the same as not to know.
struct Limit {
  bool known = false;
  std::optional<std::uint64_t> most;
};

struct GroupLimits {
  Limit memory_bytes;
  std::optional<double> processors;  ///< whose time may be used; nothing: not limited, or not known
};

/// The smallest of the group of this process and of those that hold it, in either version of control groups, as
/// proc/self/cgroup and sys/fs/cgroup below `root` tell.
GroupLimits limits_of_group(const std::filesystem::path& root = "/");

}  // namespace remount::cli
