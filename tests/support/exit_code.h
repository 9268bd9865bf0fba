// How a process ended, in one number.
#pragma once

#include <sys/wait.h>

namespace remount::testing {

/// From what waitpid or std::system say: the exit code, or 128 + signal where one ended it, as shells say it.
inline int exit_code_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

}  // namespace remount::testing
