// What a result was made from: the files of its sessions, by their bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/drive/session.h"

namespace remount::results {

/// One input, named relative to its session so that a result does not depend on where the data lie.
struct InputFile {
  std::string session;
  std::string file;
  std::uint64_t bytes = 0;
  std::string sha256;  ///< empty where the file could not be read any more
};
/// Hashes the files of all sessions; the order is theirs, whatever the number of threads. One that several sessions
/// have, as the LiDARs of a recording do, is read once.
std::vector<InputFile> hash_inputs(const std::vector<std::shared_ptr<const drive::Session>>& sessions, int threads,
                                   Progress& progress);
/// The same without their hashes: names and sizes alone, which takes no reading.
std::vector<InputFile> list_inputs(const std::vector<std::shared_ptr<const drive::Session>>& sessions);
/// "session/file" of the first file that is missing among `now`, or there with other bytes; empty where all are as they
/// were.
std::string changed_file(const std::vector<InputFile>& then, const std::vector<InputFile>& now);
/// One plain file as an input.
InputFile hash_input(const std::filesystem::path& path);

}  // namespace remount::results
