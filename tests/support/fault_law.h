// What holds of a save whatever fails in it: the old file or the new one, whole, and the truth about which.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <sstream>
#include <string>

#include "tests/support/traced_process.h"

namespace remount::testing {

inline constexpr std::array<int, 4> kErrors{ENOSPC, EIO, EINTR, EACCES};

/// A folder of its own, in memory where there is such a place: a thousand saves wait for a disk for half a minute.
class QuickFolder {
 public:
  QuickFolder() {
    const std::filesystem::path memory = "/dev/shm";
    const bool quick = ::access(memory.c_str(), W_OK) == 0;
    std::string pattern = ((quick ? memory : std::filesystem::temp_directory_path()) / "remount-XXXXXX").string();
    if (::mkdtemp(pattern.data()) != nullptr) path_ = std::filesystem::canonical(pattern);
  }
  ~QuickFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  QuickFolder(const QuickFolder&) = delete;
  QuickFolder& operator=(const QuickFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

inline std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

/// One file that is saved over an older one.
struct SavedFile {
  std::filesystem::path path;
  std::string old_bytes, new_bytes;
  std::string may_leave;  ///< an empty file of this name may stay where its making failed half-way

  void put_old() const {
    for (const auto& entry : std::filesystem::directory_iterator(path.parent_path()))
      std::filesystem::remove_all(entry.path());
    std::ofstream(path, std::ios::binary) << old_bytes;
  }
  bool is_old() const { return bytes_of(path) == old_bytes; }
  bool is_new() const { return bytes_of(path) == new_bytes; }
};

/// What happened in words, for a test that fails.
inline std::string told(const TracedRun& run, const Fault& fault) {
  std::string text = "call " + std::to_string(fault.call) + " of " + std::to_string(run.calls.size()) +
                     (fault.error != 0 ? std::string(" returned ") + std::strerror(fault.error) : std::string()) +
                     ", exit code " + std::to_string(run.exit_code) + ", said \"" + run.said + "\"\n";
  for (std::size_t i = 0; i < run.calls.size(); ++i)
    text += (i + 1 == fault.call ? " >> " : "    ") + run.calls[i] + "\n";
  return text;
}

/// Runs `run` with a fault at the first, second, … call until it makes fewer. Returns how many it made.
inline std::size_t for_every_call(Fault fault, const std::function<TracedRun(const Fault&)>& run,
                                  const std::function<void(const TracedRun&, const Fault&)>& check) {
  for (fault.call = 1;; ++fault.call) {
    const TracedRun done = run(fault);
    check(done, fault);
    if (!done.faulted) return done.calls.size();
    if (::testing::Test::HasFailure()) return 0;  // one is enough to read
  }
}

/// The law for one run that saved `file`.
inline void check_saved(const SavedFile& file, const TracedRun& run, const Fault& fault) {
  const bool is_new = file.is_new();
  EXPECT_TRUE(is_new || file.is_old()) << "neither the old nor the new file\n" << told(run, fault);
  if (run.exit_code == 0) {
    EXPECT_TRUE(is_new) << "success, but the old file\n" << told(run, fault);
  } else {
    EXPECT_NE(run.said.find(file.path.filename().string()), std::string::npos) << told(run, fault);
    EXPECT_NE(run.said.find(std::strerror(fault.error)), std::string::npos) << told(run, fault);
    EXPECT_FALSE(is_new && run.said.find("nothing was replaced") != std::string::npos) << told(run, fault);
  }
  const bool may_fail = run.faulted && fault.kind == Fault::Kind::Error && fault.error != EINTR;
  EXPECT_TRUE(may_fail || run.exit_code == 0) << "nothing failed for good\n" << told(run, fault);
  std::set<std::string> left = names_in(file.path.parent_path());
  left.erase(file.path.filename().string());
  const bool unlinked = fault.call == 0 || !run.faulted || run.calls[fault.call - 1].rfind("unlink", 0) != 0;
  if (!file.may_leave.empty() && run.exit_code != 0 && bytes_of(file.path.parent_path() / file.may_leave).empty())
    left.erase(file.may_leave);
  EXPECT_TRUE(left.empty() || !unlinked) << *left.begin() << " is left beside the file\n" << told(run, fault);
}

}  // namespace remount::testing
