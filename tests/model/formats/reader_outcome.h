// What a reader of the table makes of an input, and the memory that it may take.
#pragma once

#include "model/formats/sessions/session_reader.h"
#include "tests/fuzz/readers.h"

namespace remount::formats {

/// What a reader makes of an input: data, or the message of the Error, with the folder's name taken out of it.
struct Outcome {
  bool read = false;
  std::string text;
  bool named = true;  ///< the message names the input
};

inline Outcome outcome_of(const Reader& reader, const std::filesystem::path& input,
                          const std::filesystem::path& folder) {
  Outcome outcome;
  try {
    outcome.text = reader.read(input);
    outcome.read = true;
  } catch (const Error& error) {
    outcome.text = error.what();
    outcome.named = names_input(error, reader, folder);
  }
  for (std::size_t at = 0; (at = outcome.text.find(folder.string(), at)) != std::string::npos;)
    outcome.text.replace(at, folder.string().size(), "FOLDER");
  return outcome;
}

/// Beside four times the input: a chunk of a bag may be so large unpacked, and two hundred thousand pairs are always
/// read.
inline std::size_t constant_bytes(const Reader& reader) {
  const bool bag = reader.name.starts_with("rosbag") || reader.name == "mcap";
  return std::size_t{bag ? 80U : reader.name == "motion-pairs" ? 256U : 4U} << 20;
}

}  // namespace remount::formats
