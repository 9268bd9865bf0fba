// System calls that a signal may interrupt, and the state of files by path.
#pragma once

#include <sys/stat.h>

#include <cerrno>
#include <filesystem>
#include <optional>

namespace remount::formats {

/// Calls again as long as a signal interrupts the call before it did anything; returns what it returns then.
template <class Call>
auto retry_interrupted(Call&& call) {
  auto result = call();
  while (result == -1 && errno == EINTR) result = call();
  return result;
}

/// Of what lies at a path, links followed; empty where nothing does. Throws Error(Io) where that cannot be found out:
/// what cannot be seen must not pass for what is not there.
std::optional<struct stat> status_of(const std::filesystem::path& path);

}  // namespace remount::formats
