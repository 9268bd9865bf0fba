#include "model/formats/files/output_file.h"

#include <string>
#include <system_error>

#include "algorithms/core/error.h"
#include "messages/files.h"
#include "model/formats/files/atomic_save.h"
#include "model/formats/files/system_words.h"

namespace remount::formats {

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  save_atomically(path, bytes, Flush::Later);
}

void make_directories(const std::filesystem::path& path) {
  std::error_code error;
  do {
    error.clear();
    std::filesystem::create_directories(path, error);
  } while (error == std::errc::interrupted);
  if (error || !std::filesystem::is_directory(path, error))
    throw Error(ErrorCode::Io, path.string(),
                error ? say::folder_cannot_be_made(system_words(error)) : say::folder_file_in_the_way());
}

}  // namespace remount::formats
