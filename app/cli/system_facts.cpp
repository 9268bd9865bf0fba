#include "app/cli/system_facts.h"

#include <gnu/libc-version.h>
#include <pwd.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <set>
#include <utility>

#include "app/cli/shown_path.h"

namespace remount::cli {
namespace {

namespace fs = std::filesystem;

std::string variable(const char* name) {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nothing of ours sets variables
  return value == nullptr ? "" : value;
}

/// Those that would tell whose machine this is. One called as the program tells nothing.
std::set<std::string> personal_names() {
  std::set<std::string> names{variable("USER"), variable("LOGNAME"), variable("SUDO_USER")};
  if (const passwd* user = ::getpwuid(::getuid())) names.insert(user->pw_name);  // NOLINT(concurrency-mt-unsafe)
  char host[256] = {};
  if (::gethostname(host, sizeof(host) - 1) == 0) names.merge(names_of_host(host));
  names.erase("");
  names.erase("remount");
  return names;
}

/// What stands behind the key in the first line that begins with it, without quotes; empty where there is none. Files
/// of the system only: their lines are short.
std::string value_in(const char* file, std::string_view key) {
  std::ifstream lines(file);
  std::string line;
  while (std::getline(lines, line)) {
    if (!line.starts_with(key)) continue;
    const std::size_t begin = line.find_first_not_of(" \t:=\"", key.size());
    if (begin == std::string::npos) return {};
    return line.substr(begin, line.find_last_not_of(" \t\"") + 1 - begin);
  }
  return {};
}

std::optional<std::uint64_t> leading_number(std::string_view text) {
  std::uint64_t number = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
  return end.ec == std::errc() ? std::optional(number) : std::nullopt;
}

std::optional<std::uint64_t> kilobytes_of(std::string_view key) {
  const auto number = leading_number(value_in("/proc/meminfo", key));
  return number ? std::optional(*number * 1024U) : std::nullopt;
}

Limit limit_of(int resource) {
  rlimit limit{};
  if (::getrlimit(static_cast<__rlimit_resource>(resource), &limit) != 0) return {};
  return {true, limit.rlim_cur == RLIM_INFINITY ? std::nullopt : std::optional<std::uint64_t>(limit.rlim_cur)};
}

}  // namespace

std::string without_names(const fs::path& path) { return shown_path(path, variable("HOME"), personal_names()); }

std::string system_name() {
  std::string name = value_in("/etc/os-release", "PRETTY_NAME");
  if (utsname kernel{}; ::uname(&kernel) == 0)
    name += (name.empty() ? "" : ", ") + std::string(kernel.sysname) + " " + kernel.release + " " + kernel.machine;
  return name + ", glibc " + ::gnu_get_libc_version();
}

std::string processor_name() { return value_in("/proc/cpuinfo", "model name"); }

std::vector<std::string> instruction_sets() {
  std::vector<std::string> has;
#ifdef __x86_64__
  const std::pair<const char*, int> sets[] = {{"SSE4.2", __builtin_cpu_supports("sse4.2")},
                                              {"AVX", __builtin_cpu_supports("avx")},
                                              {"AVX2", __builtin_cpu_supports("avx2")},
                                              {"FMA", __builtin_cpu_supports("fma")},
                                              {"AVX-512F", __builtin_cpu_supports("avx512f")}};
  for (const auto& [name, supported] : sets)
    if (supported != 0) has.emplace_back(name);
#endif
  return has;
}

ProcessorShare processor_share() {
  ProcessorShare share;
  share.present = std::max(1, static_cast<int>(::sysconf(_SC_NPROCESSORS_ONLN)));
  cpu_set_t allowed;
  share.usable = ::sched_getaffinity(0, sizeof(allowed), &allowed) == 0 ? CPU_COUNT(&allowed) : share.present;
  share.of_group = limits_of_group().processors;
  return share;
}

MemoryFacts memory_facts() {
  return {.total = kilobytes_of("MemTotal"),
          .available = kilobytes_of("MemAvailable"),
          .of_group = limits_of_group().memory_bytes,
          .of_process = limit_of(RLIMIT_AS)};
}

Limit most_open_files() { return limit_of(RLIMIT_NOFILE); }

std::optional<std::uint64_t> free_bytes_at(const fs::path& folder) {
  std::error_code none;
  for (fs::path there = folder; !there.empty(); there = there.parent_path()) {
    if (const fs::space_info space = fs::space(there, none); !none) return space.available;
    if (there == there.parent_path()) break;
  }
  return {};
}

std::string locale_variables() {
  std::string text;
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LC_NUMERIC", "LANG", "LANGUAGE"})
    if (const std::string value = variable(name); !value.empty())
      text.append(text.empty() ? "" : ", ").append(name).append("=").append(value);
  return text;
}

fs::path program_file() {
  std::error_code none;
  return fs::read_symlink("/proc/self/exe", none);
}

fs::path sample_folder() {
  std::error_code none;
  const fs::path sample = fs::canonical(program_file().parent_path() / "../share/remount/sample", none);
  return none ? fs::path() : sample;
}

}  // namespace remount::cli
