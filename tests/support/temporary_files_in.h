// Where temporary files go while a test runs.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace remount::testing {

/// Temporary files of this process lie in `folder`, made or not, until this goes: other tests make theirs elsewhere.
class TemporaryFilesIn {
 public:
  explicit TemporaryFilesIn(const std::filesystem::path& folder) {
    if (const char* const set = std::getenv(kName)) before_ = set;
    ::setenv(kName, folder.c_str(), 1);
  }
  TemporaryFilesIn(const TemporaryFilesIn&) = delete;
  TemporaryFilesIn& operator=(const TemporaryFilesIn&) = delete;
  ~TemporaryFilesIn() {
    if (before_)
      ::setenv(kName, before_->c_str(), 1);
    else
      ::unsetenv(kName);
  }

 private:
  static constexpr const char* kName = "TMPDIR";
  std::optional<std::string> before_;
};

}  // namespace remount::testing
