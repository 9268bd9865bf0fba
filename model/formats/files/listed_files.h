// Which files of many are there, by listing each folder once.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <unordered_map>
#include <unordered_set>

namespace remount::formats {

/// Asks the system for a folder instead of for each of its files, which are tens of thousands in a data set, and mostly
/// on a disk far away. What comes or goes afterwards is not seen.
class ListedFiles {
 public:
  /// As is_file. Throws Error(Io) where the folder cannot be listed.
  bool has(const std::filesystem::path& file) {
    return names_in(file.parent_path()).contains(file.filename().string());
  }
  /// Regular files of a folder.
  std::size_t count_in(const std::filesystem::path& folder) { return names_in(folder).size(); }
  std::size_t listings() const { return listings_; }  ///< how often the system was asked

 private:
  const std::unordered_set<std::string>& names_in(const std::filesystem::path& folder);

  std::unordered_map<std::string, std::unordered_set<std::string>> folders_;
  std::size_t listings_ = 0;
};

}  // namespace remount::formats
