// What lies in a folder that nobody declared: clouds by folders, captures, and texts.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "algorithms/core/progress.h"
#include "algorithms/messages/message.h"
#include "model/formats/clouds/cloud_file.h"

namespace remount::guesses {

/// A scan that could be read.
struct ScanRead {
  std::filesystem::path file;
  std::size_t points = 0;
  Message columns;
};

/// Files of one format in one folder, of which one at least can be read as a cloud.
struct CloudFolder {
  std::filesystem::path directory;
  formats::CloudFormat format = formats::CloudFormat::Pcd;
  std::vector<std::filesystem::path> files;  ///< in the order of their names
  ScanRead read;
};

struct NotUsed {
  std::filesystem::path path;
  Message why;
};

struct FoundFiles {
  std::vector<CloudFolder> clouds;
  std::vector<std::filesystem::path> captures, others;
  std::vector<NotUsed> not_used;
};

/// Of files and folders, with what lies up to two folders deeper. What there is no permission to look into is passed
/// over. Throws Error(Io), and Error(Unsupported) for too many files.
FoundFiles find_files(const std::vector<std::filesystem::path>& paths, const Progress& progress);

}  // namespace remount::guesses
