#include "model/formats/files/listed_files.h"

#include "model/formats/files/input_file.h"

namespace remount::formats {

const std::unordered_set<std::string>& ListedFiles::names_in(const std::filesystem::path& folder) {
  const auto [listed, is_new] = folders_.try_emplace(folder.string());
  if (is_new) {
    ++listings_;
    for (const std::filesystem::path& file : files_in(folder)) listed->second.insert(file.filename().string());
  }
  return listed->second;
}

}  // namespace remount::formats
