// What of this machine a report of a fault needs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/group_limits.h"

namespace remount::cli {

/// As shown_path shows it, for this user and host.
std::string without_names(const std::filesystem::path& path);

/// As PRETTY_NAME of os-release, the kernel and the C library tell; empty where they do not.
std::string system_name();

std::string processor_name();
/// Of the instruction sets that matter to arithmetic, those that the processor has.
std::vector<std::string> instruction_sets();

/// Processors that this process may run on, and those whose time its control group may use; nothing: no limit is known.
struct ProcessorShare {
  int usable = 1, present = 1;
  std::optional<double> of_group;
};
ProcessorShare processor_share();

/// Bytes; nothing where it is not known.
struct MemoryFacts {
  std::optional<std::uint64_t> total, available;
  Limit of_group, of_process;
};
MemoryFacts memory_facts();

/// Files that may be open at once.
Limit most_open_files();

/// Free bytes for this user where the folder lies, or would lie once it is made.
std::optional<std::uint64_t> free_bytes_at(const std::filesystem::path& folder);

/// "LC_ALL=…, LANG=…" of the variables that are set; empty where none is.
std::string locale_variables();

/// The sample that came with this program; empty where it lies nowhere known.
std::filesystem::path sample_folder();
std::filesystem::path program_file();

}  // namespace remount::cli
