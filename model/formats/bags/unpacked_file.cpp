#include "model/formats/bags/unpacked_file.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>
#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <string>
#include <system_error>

#include "algorithms/core/error.h"
#include "messages/bags.h"
#include "messages/stages.h"
#include "model/formats/files/file_lock.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/random_access_file.h"
#include "model/formats/files/system_call.h"
#include "model/formats/files/system_words.h"

namespace remount::bags {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kPieceBytes = std::uint64_t{4} << 20;
/// A database of zeros packs well, a bomb packs better.
constexpr std::uint64_t kMostTimes = 100, kAlwaysBytes = std::uint64_t{64} << 20;
/// Left for others on the disk.
constexpr std::uint64_t kSpareBytes = std::uint64_t{64} << 20;

/// What else helps than a folder with more room. By what the file holds, as it is read: its name may be any.
Message other_way(const fs::path& source) {
  try {
    return is_zstd(formats::read_file_head(source, 4)) ? say::bag_unpack_it() : say::bag_copy_it();
  } catch (const Error&) {
    return say::bag_copy_it();
  }
}

[[noreturn]] void no_room(const fs::path& source, const fs::path& folder, Message why) {
  throw Error(ErrorCode::Io, source.string(), say::bag_no_room(folder.string(), std::move(why), other_way(source)));
}

fs::path temporary_folder(const fs::path& packed) {
  std::error_code problem;
  fs::path folder = fs::temp_directory_path(problem);
  if (problem)
    throw Error(ErrorCode::Io, packed.string(),
                say::bag_no_temporary_folder(formats::system_words(problem), other_way(packed)));
  return folder;
}

/// Before that many bytes are written.
void check_room(std::uint64_t bytes, const fs::path& source, const fs::path& folder) {
  std::error_code unknown;
  const fs::space_info space = fs::space(folder, unknown);
  if (!unknown && space.available < kSpareBytes + bytes)
    no_room(source, folder, say::bag_little_free(Bytes{space.available}));
}

void write_all(int descriptor, std::string_view bytes, const fs::path& packed, const fs::path& folder) {
  while (!bytes.empty()) {
    const ssize_t count = formats::retry_interrupted([&] { return ::write(descriptor, bytes.data(), bytes.size()); });
    if (count <= 0) no_room(packed, folder, formats::system_words(errno));
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

constexpr std::string_view kName = "remount-bag-";
/// What stands beside a database, by its name.
constexpr std::array<const char*, 2> kBeside{"-wal", "-shm"};

bool stands_beside(const std::string& name) {
  return std::any_of(kBeside.begin(), kBeside.end(), [&](const char* end) { return name.ends_with(end); });
}

void remove_with_beside(const fs::path& file) {
  ::unlink(file.c_str());
  for (const char* end : kBeside) ::unlink((file.string() + end).c_str());
}

/// Removes what processes that were killed have unpacked; nothing where the folder cannot be listed.
void remove_leftovers(const fs::path& folder) try {
  for (const fs::path& file : formats::files_in(folder)) {
    const std::string name = file.filename().string();
    if (!name.starts_with(kName) || stands_beside(name)) continue;
    const formats::FileDescriptor there(
        formats::retry_interrupted([&] { return ::open(file.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC); }));
    if (there.get() >= 0 && ::flock(there.get(), LOCK_EX | LOCK_NB) == 0 && formats::lies_at(there, file))
      remove_with_beside(file);
  }
} catch (const Error&) {
}

/// A new file in the folder, locked while it is open, and its path; without a descriptor where it cannot be made.
formats::FileDescriptor make_locked(const fs::path& folder, fs::path& path) {
  constexpr int kTries = 100;  // each fails only where it is taken for a leftover before it is locked
  for (int i = 0; i < kTries; ++i) {
    std::string pattern = (folder / (std::string(kName) + "XXXXXX")).string();
    formats::FileDescriptor file(::mkostemp(pattern.data(), O_CLOEXEC));
    path = pattern;
    if (file.get() < 0) return file;
    // Where the file system knows no locks nobody takes it for a leftover either.
    if (::flock(file.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) continue;
    if (formats::lies_at(file, path)) return file;
  }
  errno = EBUSY;
  return {};
}

}  // namespace

bool is_zstd(std::string_view head) { return head.starts_with("\x28\xb5\x2f\xfd"); }

void UnpackedFile::make(const fs::path& source) {
  const fs::path folder = temporary_folder(source);
  remove_leftovers(folder);
  file_ = make_locked(folder, path_);
  if (file_.get() < 0) no_room(source, folder, formats::system_words(errno));
}

UnpackedFile::UnpackedFile(const fs::path& packed, Progress& progress) {
  make(packed);
  try {
    unpack(packed, progress);
  } catch (...) {
    remove_with_beside(path_);
    throw;
  }
}

UnpackedFile::UnpackedFile(const WithLog& files, Progress& progress) {
  make(files.database);
  try {
    copy(files.database, file_.get(), progress);
    const std::string log = path_.string() + kBeside[0];
    const formats::FileDescriptor beside(formats::retry_interrupted(
        [&] { return ::open(log.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600); }));
    if (beside.get() < 0) no_room(files.log, path_.parent_path(), formats::system_words(errno));
    copy(files.log, beside.get(), progress);
  } catch (...) {
    remove_with_beside(path_);
    throw;
  }
}

UnpackedFile::~UnpackedFile() { remove_with_beside(path_); }

void UnpackedFile::copy(const fs::path& source, int to, Progress& progress) const {
  const formats::RandomAccessFile from(source);
  for (std::uint64_t offset = 0; offset < from.size() && !progress.cancelled(); offset += kPieceBytes) {
    progress.report(say::stage_copying_the_bag, offset >> 20, from.size() >> 20);
    check_room(from.size() - offset, source, path_.parent_path());
    write_all(to, from.read(offset, std::min(kPieceBytes, from.size() - offset)), source, path_.parent_path());
  }
}

void UnpackedFile::unpack(const fs::path& packed, Progress& progress) const {
  const formats::RandomAccessFile source(packed);
  const std::uint64_t most = std::max(kAlwaysBytes, kMostTimes * source.size());
  const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context(ZSTD_createDCtx(), ZSTD_freeDCtx);
  if (!context) throw std::bad_alloc();
  std::string out(kPieceBytes, '\0');
  std::uint64_t written = 0;
  std::size_t hint = 1;
  for (std::uint64_t offset = 0; offset < source.size() && !progress.cancelled(); offset += kPieceBytes) {
    progress.report(say::stage_unpacking_the_bag, offset >> 20, source.size() >> 20);
    const std::string in = source.read(offset, std::min(kPieceBytes, source.size() - offset));
    ZSTD_inBuffer input{in.data(), in.size(), 0};
    bool full = false;
    while (input.pos < input.size || full) {
      ZSTD_outBuffer output{out.data(), out.size(), 0};
      hint = ZSTD_decompressStream(context.get(), &output, &input);
      if (ZSTD_isError(hint))
        throw Error(ErrorCode::Format, source.place(offset + input.pos), say::bag_file_damaged_here());
      written += output.pos;
      if (written > most) throw Error(ErrorCode::Format, packed.string(), say::bag_unpacks_to_more(Bytes{most}));
      check_room(output.pos, packed, path_.parent_path());
      write_all(file_.get(), {out.data(), output.pos}, packed, path_.parent_path());
      // A frame that ends where the room does has given all: asked on, it would wait for a frame that is not there.
      full = output.pos == output.size && hint != 0;
    }
  }
  if (hint != 0 && !progress.cancelled())
    throw Error(ErrorCode::Format, source.place(source.size()), say::bag_file_cut());
}

}  // namespace remount::bags
