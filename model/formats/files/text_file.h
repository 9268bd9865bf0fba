// Text files in whatever encoding their program chose, as UTF-8.
#pragma once

#include <filesystem>
#include <string>

#include "model/formats/files/input_file.h"

namespace remount::formats {

/// As read_regular_file. UTF-16, which Windows' editors and exporters write, becomes UTF-8, with a byte order mark or
/// without one where the text begins in Latin letters; the mark of UTF-8 is taken off. Half a character at the end,
/// and surrogates without their other half, become U+FFFD.
std::string read_text_file(const std::filesystem::path& path, std::uint64_t max_bytes = kMaxDataFileBytes);

/// The first bytes of a text, at most `bytes` of the file; same errors.
std::string read_text_head(const std::filesystem::path& path, std::size_t bytes);

/// Whether read_text_file gives a file's bytes as they are, so that what is added to it can be read alone.
bool is_plain_text(const std::filesystem::path& path);

/// What read_text_file makes of the bytes of a file.
std::string utf8_text(std::string bytes);

}  // namespace remount::formats
