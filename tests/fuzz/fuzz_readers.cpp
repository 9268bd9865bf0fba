// One fuzz target for each reader of the table: `fuzz_readers --reader=NAME [libFuzzer's options] CORPUS`.
// `fuzz_readers --list` prints the names.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>

#include "tests/fuzz/readers.h"

namespace remount::formats {
namespace {

namespace fs = std::filesystem;

const Reader* chosen = nullptr;
fs::path folder;

void remove_folder() {
  std::error_code ignored;
  fs::remove_all(folder, ignored);
}

/// In memory where there is such a file system: a file is written for every input.
void make_folder() {
  const fs::path memory = "/dev/shm";
  std::string pattern = ((fs::is_directory(memory) ? memory : fs::temp_directory_path()) / "remount-fuzz-XXXXXX");
  if (::mkdtemp(pattern.data()) == nullptr) {
    std::perror("fuzz_readers: no folder can be made");
    std::exit(1);
  }
  folder = pattern;
  std::atexit(remove_folder);
}

void choose(int count, char** arguments) {
  constexpr const char* kOption = "--reader=";
  std::string name;
  for (int i = 1; i < count; ++i) {
    if (std::strncmp(arguments[i], kOption, std::strlen(kOption)) == 0) name = arguments[i] + std::strlen(kOption);
    if (std::strcmp(arguments[i], "--list") != 0) continue;
    for (const Reader& reader : readers()) std::cout << reader.name << "\n";
    std::exit(0);
  }
  try {
    chosen = &reader_of(name);
  } catch (const Error& error) {
    std::cerr << "fuzz_readers " << kOption << "NAME: " << error.what() << "\n";
    std::exit(1);
  }
}

/// Data, or an Error that names the input: anything else is a find.
void read_input(std::string_view bytes) {
  const fs::path input = write_input(*chosen, bytes, folder);
  try {
    chosen->read(input);
  } catch (const Error& error) {
    if (names_input(error, *chosen, folder)) return;
    std::cerr << "the error does not name the input: " << error.what() << "\n";
    std::abort();
  }
}

}  // namespace
}  // namespace remount::formats

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  remount::formats::choose(*count, *arguments);
  remount::formats::make_folder();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  remount::formats::read_input({reinterpret_cast<const char*>(data), size});
  return 0;
}
