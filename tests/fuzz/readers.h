// Every reader of files from outside, in one table: what is fuzzed, damaged, measured and refused is this list.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/core/error.h"

namespace remount::formats {

/// A pure function from the bytes of one input to data or an Error.
struct Reader {
  std::string_view name;       ///< of its fuzz target, and of its folder in tests/fuzz/corpus
  std::string_view file_name;  ///< under which the bytes are read; empty: they are a pack of files (see write_input)
  /// What was read, as text: the same for the same bytes. Throws Error.
  std::string (*read)(const std::filesystem::path& input);
};

/// Adding a reader: a line in readers.cpp, and a sample in tests/model/formats/sample_inputs.cpp.
const std::vector<Reader>& readers();

/// Throws Error(Contract) that lists the names where there is none of that name.
const Reader& reader_of(std::string_view name);

/// Several files as one string of bytes: each begins with a line ">>> NAME" of its own, also where the file before it
/// does not end with a line.
struct PackedFile {
  std::string name, bytes;
};
std::string pack_files(const std::vector<PackedFile>& files);
/// Names lead into the folder; pieces whose names do not are left out, and so are those beyond the hundredth.
std::vector<PackedFile> unpack_files(std::string_view pack);

/// Makes `folder` hold the input and nothing else. @return what the reader is to be given
std::filesystem::path write_input(const Reader& reader, std::string_view bytes, const std::filesystem::path& folder);

/// True where the message names the input or a file in it.
bool names_input(const Error& error, const Reader& reader, const std::filesystem::path& folder);

}  // namespace remount::formats
