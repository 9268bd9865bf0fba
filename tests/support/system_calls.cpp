#include "tests/support/system_calls.h"

#include <sys/syscall.h>

#include <algorithm>

namespace remount::testing {
namespace {

// Descriptor, folder, path, other folder, other path, size.
constexpr SystemCall kCalls[] = {
#ifdef SYS_open  // the calls of x86-64 that newer architectures do without
    {SYS_open, "open", -1, -1, 0},
    {SYS_creat, "creat", -1, -1, 0},
    {SYS_stat, "stat", -1, -1, 0},
    {SYS_lstat, "lstat", -1, -1, 0},
    {SYS_access, "access", -1, -1, 0},
    {SYS_readlink, "readlink", -1, -1, 0},
    {SYS_rename, "rename", -1, -1, 0, -1, 1},
    {SYS_unlink, "unlink", -1, -1, 0},
    {SYS_link, "link", -1, -1, 0, -1, 1},
    {SYS_symlink, "symlink", -1, -1, 1},
    {SYS_mkdir, "mkdir", -1, -1, 0},
    {SYS_rmdir, "rmdir", -1, -1, 0},
    {SYS_chmod, "chmod", -1, -1, 0},
    {SYS_chown, "chown", -1, -1, 0},
    {SYS_getdents, "getdents", 0},
#endif
#ifdef SYS_renameat
    {SYS_renameat, "renameat", -1, 0, 1, 2, 3},
#endif
    {SYS_renameat2, "renameat2", -1, 0, 1, 2, 3},
    {SYS_openat, "openat", -1, 0, 1},
    {SYS_newfstatat, "newfstatat", -1, 0, 1},
    {SYS_statx, "statx", -1, 0, 1},
    {SYS_faccessat, "faccessat", -1, 0, 1},
#ifdef SYS_faccessat2
    {SYS_faccessat2, "faccessat2", -1, 0, 1},
#endif
#ifdef SYS_openat2
    {SYS_openat2, "openat2", -1, 0, 1},
#endif
    {SYS_readlinkat, "readlinkat", -1, 0, 1},
    {SYS_unlinkat, "unlinkat", -1, 0, 1},
    {SYS_linkat, "linkat", -1, 0, 1, 2, 3},
    {SYS_symlinkat, "symlinkat", -1, 1, 2},
    {SYS_mkdirat, "mkdirat", -1, 0, 1},
    {SYS_fchmodat, "fchmodat", -1, 0, 1},
    {SYS_fchownat, "fchownat", -1, 0, 1},
    {SYS_utimensat, "utimensat", -1, 0, 1},
    {SYS_truncate, "truncate", -1, -1, 0},
    {SYS_statfs, "statfs", -1, -1, 0},
    {SYS_fstat, "fstat", 0},
    {SYS_read, "read", 0},
    {SYS_pread64, "pread64", 0},
    {SYS_readv, "readv", 0},
    {SYS_write, "write", 0, -1, -1, -1, -1, 2},
    {SYS_pwrite64, "pwrite64", 0, -1, -1, -1, -1, 2},
    {SYS_writev, "writev", 0},
    {SYS_pwritev, "pwritev", 0},
    {SYS_lseek, "lseek", 0},
    {SYS_fsync, "fsync", 0},
    {SYS_fdatasync, "fdatasync", 0},
    {SYS_syncfs, "syncfs", 0},
    {SYS_sync_file_range, "sync_file_range", 0},
    {SYS_ftruncate, "ftruncate", 0},
    {SYS_fallocate, "fallocate", 0},
    {SYS_fchmod, "fchmod", 0},
    {SYS_fchown, "fchown", 0},
    {SYS_fstatfs, "fstatfs", 0},
    {SYS_fcntl, "fcntl", 0},
    {SYS_ioctl, "ioctl", 0},
    {SYS_flock, "flock", 0},
    {SYS_getdents64, "getdents64", 0},
    {SYS_sendfile, "sendfile", 0},
    {SYS_copy_file_range, "copy_file_range", 2},
    {SYS_mmap, "mmap", 4},
    {SYS_close, "close", 0},
};

}  // namespace

const SystemCall* find_system_call(std::uint64_t number) {
  const auto* found = std::find_if(std::begin(kCalls), std::end(kCalls), [&](const SystemCall& call) {
    return static_cast<std::uint64_t>(call.number) == number;
  });
  return found == std::end(kCalls) ? nullptr : found;
}

}  // namespace remount::testing
