#include "model/io/bag/unpacked_file.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>
#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <string>
#include <system_error>

#include "algorithms/core/error.h"
#include "model/io/file_lock.h"
#include "model/io/input_file.h"
#include "model/io/random_access_file.h"
#include "model/io/system_call.h"

namespace remount {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kPieceBytes = std::uint64_t{4} << 20;
/// A database of zeros packs well, a bomb packs better.
constexpr std::uint64_t kMostTimes = 100, kAlwaysBytes = std::uint64_t{64} << 20;
/// Left for others on the disk.
constexpr std::uint64_t kSpareBytes = std::uint64_t{64} << 20;

std::string megabytes(std::uint64_t bytes) { return std::to_string(bytes >> 20) + " MB"; }

[[noreturn]] void no_room(const fs::path& packed, const fs::path& folder, const std::string& why) {
  throw Error(ErrorCode::Io, packed.string(),
              "cannot be unpacked in " + folder.string() + ": " + why + "; set TMPDIR to a folder with more room, or " +
                  "unpack it with 'zstd -d'");
}

fs::path temporary_folder(const fs::path& packed) {
  std::error_code problem;
  fs::path folder = fs::temp_directory_path(problem);
  if (problem)
    throw Error(ErrorCode::Io, packed.string(),
                "cannot be unpacked, there is no folder for temporary files: " + problem.message() +
                    "; set TMPDIR to one, or unpack it with 'zstd -d'");
  return folder;
}

void write_all(int descriptor, std::string_view bytes, const fs::path& packed, const fs::path& folder) {
  while (!bytes.empty()) {
    const ssize_t count = uninterrupted([&] { return ::write(descriptor, bytes.data(), bytes.size()); });
    if (count <= 0) no_room(packed, folder, std::strerror(errno));
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

constexpr std::string_view kName = "remount-bag-";

/// Removes what processes that were killed have unpacked; nothing where the folder cannot be listed.
void remove_leftovers(const fs::path& folder) try {
  for (const fs::path& file : files_in(folder)) {
    if (!file.filename().string().starts_with(kName)) continue;
    const FileDescriptor there(
        uninterrupted([&] { return ::open(file.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC); }));
    if (there.get() >= 0 && ::flock(there.get(), LOCK_EX | LOCK_NB) == 0 && lies_at(there, file))
      ::unlink(file.c_str());
  }
} catch (const Error&) {
}

/// A new file in the folder, locked while it is open, and its path; without a descriptor where it cannot be made.
FileDescriptor make_locked(const fs::path& folder, fs::path& path) {
  constexpr int kTries = 100;  // each fails only where it is taken for a leftover before it is locked
  for (int i = 0; i < kTries; ++i) {
    std::string pattern = (folder / (std::string(kName) + "XXXXXX")).string();
    FileDescriptor file(::mkostemp(pattern.data(), O_CLOEXEC));
    path = pattern;
    if (file.get() < 0) return file;
    // Where the file system knows no locks nobody takes it for a leftover either.
    if (::flock(file.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) continue;
    if (lies_at(file, path)) return file;
  }
  errno = EBUSY;
  return {};
}

}  // namespace

bool is_zstd(std::string_view head) { return head.starts_with("\x28\xb5\x2f\xfd"); }

UnpackedFile::UnpackedFile(const fs::path& packed, Progress& progress) {
  const fs::path folder = temporary_folder(packed);
  remove_leftovers(folder);
  file_ = make_locked(folder, path_);
  if (file_.get() < 0) no_room(packed, folder, std::strerror(errno));
  try {
    unpack(packed, progress);
  } catch (...) {
    ::unlink(path_.c_str());
    throw;
  }
}

UnpackedFile::~UnpackedFile() { ::unlink(path_.c_str()); }

void UnpackedFile::unpack(const fs::path& packed, Progress& progress) const {
  const RandomAccessFile source(packed);
  const std::uint64_t most = std::max(kAlwaysBytes, kMostTimes * source.size());
  const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context(ZSTD_createDCtx(), ZSTD_freeDCtx);
  if (!context) throw std::bad_alloc();
  std::string out(kPieceBytes, '\0');
  std::uint64_t written = 0;
  std::size_t hint = 1;
  for (std::uint64_t offset = 0; offset < source.size() && !progress.cancelled(); offset += kPieceBytes) {
    progress.report("unpacking the bag, MB", offset >> 20, source.size() >> 20);
    const std::string in = source.read(offset, std::min(kPieceBytes, source.size() - offset));
    ZSTD_inBuffer input{in.data(), in.size(), 0};
    bool full = false;
    while (input.pos < input.size || full) {
      ZSTD_outBuffer output{out.data(), out.size(), 0};
      hint = ZSTD_decompressStream(context.get(), &output, &input);
      if (ZSTD_isError(hint))
        throw Error(ErrorCode::Format, source.place(offset + input.pos), "the compressed file is damaged here");
      written += output.pos;
      if (written > most)
        throw Error(ErrorCode::Format, packed.string(),
                    "unpacks to more than " + megabytes(most) + ", which no bag of this size does");
      std::error_code unknown;
      const fs::space_info space = fs::space(path_.parent_path(), unknown);
      if (!unknown && space.available < kSpareBytes + output.pos)
        no_room(packed, path_.parent_path(),
                "after " + megabytes(written) + " only " + megabytes(space.available) + " are free");
      write_all(file_.get(), {out.data(), output.pos}, packed, path_.parent_path());
      // A frame that ends where the room does has given all: asked on, it would wait for a frame that is not there.
      full = output.pos == output.size && hint != 0;
    }
  }
  if (hint != 0 && !progress.cancelled())
    throw Error(ErrorCode::Format, source.place(source.size()), "the compressed file was cut: its end is missing");
}

}  // namespace remount
