// Small valid inputs of every reader, most of them made by the writers of the product: to be damaged, and the seeds of
// the fuzz targets.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace remount::formats {

struct Sample {
  std::string reader;  ///< of tests/fuzz/readers.h
  std::string name;    ///< of the seed in the reader's folder
  std::string bytes;   ///< as the reader takes them: a file, or a pack of files
};

/// The same for every call. Those of one reader; of all where `reader` is empty.
std::vector<Sample> sample_inputs(std::string_view reader = {});

/// "READER_NAME" of each of all samples, without making them.
std::vector<std::string> sample_names();

/// The sample of the name at that place of sample_names().
Sample sample_input(std::size_t index);

}  // namespace remount::formats
