// What holds for every reader of the table: the same data from the same bytes, nothing read but regular files, and no
// more memory than the input's size allows.
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <iostream>
#include <set>

#include "tests/fuzz/readers.h"
#include "tests/model/formats/allocation_meter.h"
#include "tests/model/formats/bags/bag_fixtures.h"
#include "tests/model/formats/mutator.h"
#include "tests/model/formats/reader_outcome.h"
#include "tests/model/formats/sample_inputs.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/draws.h"

namespace remount::formats {
namespace {

namespace fs = std::filesystem;

Outcome outcome_of(const Reader& reader, std::string_view bytes) {
  const TemporaryFolder folder;
  // A name that is the same each time: sessions are called as their folder is.
  const fs::path inner = folder.path() / "input";
  fs::create_directories(inner);
  return outcome_of(reader, write_input(reader, bytes, inner), inner);
}

fs::path corpus(const Reader& reader) { return fs::path(REMOUNT_SOURCE_DIR) / "tests/fuzz/corpus" / reader.name; }

class every_reader : public ::testing::TestWithParam<std::string> {
 protected:
  const Reader& reader() const { return reader_of(GetParam()); }
};

TEST_P(every_reader, reads_its_samples_which_are_seeds_of_its_fuzz_target) {
  const std::vector<Sample> samples = sample_inputs(reader().name);
  EXPECT_FALSE(samples.empty()) << "add one to sample_inputs.cpp";
  for (const Sample& sample : samples) {
    const Outcome outcome = outcome_of(reader(), sample.bytes);
    EXPECT_TRUE(outcome.read) << sample.name << ": " << outcome.text;
    EXPECT_TRUE(is_regular_file(corpus(reader()) / sample.name)) << sample.name << ": run write_seeds";
  }
}

TEST_P(every_reader, makes_the_same_of_the_same_bytes_and_names_what_it_refuses) {
  std::size_t count = 0, refused = 0;
  for (const fs::directory_entry& seed : fs::directory_iterator(corpus(reader()))) {
    const std::string bytes = bytes_of(seed.path());
    const Outcome one = outcome_of(reader(), bytes), other = outcome_of(reader(), bytes);
    EXPECT_EQ(one.text, other.text) << seed.path();
    EXPECT_TRUE(one.named) << seed.path() << ": " << one.text;
    ++count, refused += !one.read;
  }
  EXPECT_GT(count, 0U);
  std::cout << GetParam() << ": " << count << " seeds, " << refused << " of them refused\n";
}

// ---- What is no regular file

using Maker = void (*)(const fs::path&);

void make_socket(const fs::path& path) {
  const fs::path before = fs::current_path();
  fs::current_path(path.parent_path());  // an address is short
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.filename().string().copy(address.sun_path, sizeof address.sun_path - 1);
  const int descriptor = ::socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(::bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0) << path;
  ::close(descriptor);
  fs::current_path(before);
}

constexpr std::pair<const char*, Maker> kNoFiles[] = {
    {"directory", [](const fs::path& path) { fs::create_directory(path); }},
    {"FIFO", [](const fs::path& path) { ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0); }},
    {"socket", make_socket},
    {"device", [](const fs::path& path) { fs::create_symlink("/dev/zero", path); }},
    {"loop of links", [](const fs::path& path) { fs::create_symlink(path.filename(), path); }},
    {"link to nothing", [](const fs::path& path) { fs::create_symlink("nothing", path); }},
};

TEST_P(every_reader, refuses_at_once_what_is_no_regular_file) {
  const Sample sample = sample_inputs(reader().name).front();
  const bool pack = reader().file_name.empty();
  std::vector<std::string> names{std::string(reader().file_name)};
  if (pack) {
    names.clear();
    std::set<std::string> kinds;  // of files that differ by their number alone, as scans do, one says it of all
    for (const PackedFile& file : unpack_files(sample.bytes)) {
      std::string kind = file.name;
      std::erase_if(kind, [](unsigned char c) { return std::isdigit(c) != 0; });
      if (kinds.insert(kind).second) names.push_back(file.name);
    }
  }
  const TemporaryFolder folder;
  for (const auto& [kind, make] : kNoFiles)
    for (const std::string& name : names) {
      const fs::path input = write_input(reader(), sample.bytes, folder.path());
      fs::remove(folder.path() / name);
      make(folder.path() / name);
      const auto started = std::chrono::steady_clock::now();
      const Outcome outcome = outcome_of(reader(), input, folder.path());
      const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
      EXPECT_LT(took_s, 10.0) << kind << " as " << name;
      EXPECT_TRUE(outcome.named) << kind << " as " << name << ": " << outcome.text;
      // Of a session some files may be missing; a file that is the whole input may not.
      EXPECT_TRUE(pack || !outcome.read) << kind << " as " << name;
    }
}

// ---- Memory

struct Peak {
  std::size_t bytes = 0;  ///< beyond four times the input
  std::string what;
};

void measure(const Reader& reader, const std::string& bytes, const std::string& what, const fs::path& folder,
             Peak& peak) {
  const fs::path input = write_input(reader, bytes, folder);
  const AllocationMeter meter;
  outcome_of(reader, input, folder);
  const std::size_t taken = meter.peak_bytes(), free = 4 * bytes.size();
  if (taken > free && taken - free > peak.bytes) peak = {taken - free, what};
}

/// Sizes and counts made huge, wherever they may stand: binary in two and three widths, text in every number.
std::vector<std::pair<std::size_t, std::string>> hostile_numbers(const std::string& bytes, std::size_t at) {
  std::vector<std::pair<std::size_t, std::string>> edits;
  if (std::isdigit(static_cast<unsigned char>(bytes[at])) != 0 &&
      (at == 0 || std::isdigit(static_cast<unsigned char>(bytes[at - 1])) == 0)) {
    const std::size_t length = std::min(bytes.find_first_not_of("0123456789", at), bytes.size()) - at;
    for (const char* huge : {"4294967295", "1000000000", "18446744073709551615"}) edits.emplace_back(length, huge);
  }
  for (const std::string& huge :
       {std::string("\xff\xff\xff\x7f"), std::string("\0\0\0\x40\0\0\0\0", 8), std::string(8, '\xff')})
    if (at + huge.size() <= bytes.size()) edits.emplace_back(huge.size(), huge);
  return edits;
}

TEST_P(every_reader, takes_no_memory_for_what_is_only_promised) {
  if (!AllocationMeter::works()) GTEST_SKIP() << "the sanitizers count allocations themselves";
  const TemporaryFolder folder;
  Peak peak;
  std::size_t inputs = 0;
  for (const Sample& sample : sample_inputs(reader().name)) {
    // Headers stand at the beginning and, in bags, at the end; places in between are drawn.
    Mutator draw(1);
    const std::size_t size = sample.bytes.size();
    const std::size_t every = testing::draws_all() ? 1 : 3;
    for (std::size_t i = 0; i < (reader().file_name.empty() ? 60U : 120U); i += every) {
      const std::size_t at = i < 40 ? i * 3 : i < 50 ? size - std::min(size, (i - 39) * 4) : draw.below(size);
      if (at >= size) continue;
      for (const auto& [length, huge] : hostile_numbers(sample.bytes, at)) {
        std::string bytes = sample.bytes;
        bytes.replace(at, length, huge);
        measure(reader(), bytes, sample.name + ", byte " + std::to_string(at), folder.path(), peak);
        ++inputs;
      }
    }
  }
  std::cout << GetParam() << ": " << inputs << " inputs, at most " << (peak.bytes >> 10) << " KiB beyond four times "
            << "the input (" << peak.what << ")\n";
  EXPECT_LT(peak.bytes, constant_bytes(reader())) << peak.what;
}

std::vector<std::string> names() {
  std::vector<std::string> list;
  for (const Reader& reader : readers()) list.emplace_back(reader.name);
  return list;
}

INSTANTIATE_TEST_SUITE_P(of, every_reader, ::testing::ValuesIn(names()), [](const auto& reader) {
  std::string name = reader.param;
  for (char& c : name)
    if (c == '-') c = '_';
  return name;
});

}  // namespace
}  // namespace remount::formats
