// Writes every sample input as a seed: `write_seeds tests/fuzz/corpus`. Run after a sample was added or changed; what
// fuzzing has found lies beside them and stays.
#include <filesystem>
#include <fstream>
#include <iostream>

#include "tests/model/formats/sample_inputs.h"

int main(int count, char** arguments) {
  namespace fs = std::filesystem;
  if (count != 2) {
    std::cerr << "usage: write_seeds FOLDER\n";
    return 1;
  }
  for (const remount::formats::Sample& sample : remount::formats::sample_inputs()) {
    const fs::path folder = fs::path(arguments[1]) / sample.reader;
    fs::create_directories(folder);
    std::ofstream seed(folder / sample.name, std::ios::binary);
    seed.write(sample.bytes.data(), static_cast<std::streamsize>(sample.bytes.size()));
    if (!seed.flush()) {
      std::cerr << (folder / sample.name).string() << ": cannot be written\n";
      return 2;
    }
  }
  return 0;
}
