// What of this machine a report of a fault needs, and nothing that tells whose it is.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace remount::cli {

/// The path with ~ for the home folder, and … for what is named as the user, the host or a home of somebody else.
std::string without_names(const std::filesystem::path& path);

/// As PRETTY_NAME of os-release, the kernel and the C library tell; empty where they do not.
std::string system_name();

std::string processor_name();
/// Of the instruction sets that matter to arithmetic, those that the processor has.
std::vector<std::string> instruction_sets();

/// Processors that this process may run on, and those that its control group may use up; nothing: as many as it likes.
struct ProcessorShare {
  int usable = 1, present = 1;
  std::optional<double> of_group;
};
ProcessorShare processor_share();

/// Bytes; nothing where it is not known, or not limited.
struct MemoryFacts {
  std::optional<std::uint64_t> total, available, of_group, of_process;
};
MemoryFacts memory_facts();

/// Files that may be open at once; nothing: as many as one likes.
std::optional<std::uint64_t> most_open_files();

/// Free bytes for this user where the folder lies, or would lie once it is made.
std::optional<std::uint64_t> free_bytes_at(const std::filesystem::path& folder);

/// "LC_ALL=…, LANG=…" of the variables that are set; empty where none is.
std::string locale_variables();

/// The sample that came with this program; empty where it lies nowhere known.
std::filesystem::path sample_folder();
std::filesystem::path program_file();

}  // namespace remount::cli
