// Small valid files of every format, damaged in thousands of ways: each is read, or refused by an Error that names the
// file. Deterministic; REMOUNT_MUTATIONS sets how many mutations a reader gets. Meant for the sanitizers.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <iostream>

#include "tests/fuzz/readers.h"
#include "tests/model/formats/mutator.h"
#include "tests/model/formats/sample_inputs.h"
#include "tests/model/formats/temporary_folder.h"

// The address sanitizer keeps what was freed, 256 MB of it unless told: more than all that readers need, so that their
// memory would not be seen beside it.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() { return "quarantine_size_mb=64"; }

namespace remount::formats {
namespace {

namespace fs = std::filesystem;

int mutations() {
  const char* text = std::getenv("REMOUNT_MUTATIONS");
  return text ? std::max(1, std::atoi(text)) : 200;
}

/// The same on every platform, unlike std::hash.
unsigned seed_of(const std::string& name) {
  unsigned seed = 2166136261U;
  for (const char c : name) seed = (seed ^ static_cast<unsigned char>(c)) * 16777619U;
  return seed;
}

/// Peak memory of the process, MB.
double peak_mb() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// Damages one file of an input at a time: cut at many lengths, then at random. What comes back is data or an Error
/// that names the input.
class mutated_input : public ::testing::TestWithParam<std::size_t> {
 protected:
  void SetUp() override {
    sample_ = sample_input(GetParam());
    reader_ = &reader_of(sample_.reader);
    pack_ = reader_->file_name.empty();
    files_ = pack_ ? unpack_files(sample_.bytes) : std::vector<PackedFile>{{"", sample_.bytes}};
  }

  void cut() {
    const std::size_t cuts = std::max<std::size_t>(1, static_cast<std::size_t>(mutations()) / 5 / files_.size());
    for (PackedFile& file : files_) {
      const MutatedBytes good = file.bytes;
      for (std::size_t i = 0; i < std::min(cuts, good.size()) && !HasFatalFailure(); ++i) {
        file.bytes.resize(good.size() * i / std::min(cuts, good.size()));
        attempt(file.name);
        file.bytes = good;
      }
    }
  }

  void mutate() {
    Mutator mutator(seed_of(sample_.reader + sample_.name));
    while (attempts_ < mutations() && !HasFatalFailure()) {
      PackedFile& file = files_[mutator.below(files_.size())];
      const MutatedBytes good = file.bytes;
      file.bytes = mutator.damaged(good);
      attempt(file.name);
      file.bytes = good;
    }
  }

  void attempt(const std::string& target) {
    const auto damaged = [this] { return pack_ ? pack_files(files_) : files_[0].bytes; };
    const fs::path input = pack_ ? write_changed(target) : write_input(*reader_, damaged(), folder_.path());
    const int number = attempts_++;
    const auto started = std::chrono::steady_clock::now();
    try {
      reader_->read(input);
    } catch (const Error& error) {
      ++refused_;
      const bool named = names_input(error, *reader_, folder_.path());
      if (!named) keep(damaged());
      ASSERT_TRUE(named) << "mutation " << number << " of " << target << ": " << error.what();
    } catch (const std::exception& error) {
      keep(damaged());
      FAIL() << "mutation " << number << " of " << target << ": not an Error: " << error.what();
    }
    const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    longest_s_ = std::max(longest_s_, took_s);
    ASSERT_LT(took_s, 20.0) << "mutation " << number << " of " << target;
  }

  /// Of the files of an input the damaged one and the one that was damaged before it, which is whole again: the others
  /// lie there as they were written first.
  fs::path write_changed(const std::string& target) {
    for (const PackedFile& file : files_)
      if (file.name == target || file.name == written_)
        std::ofstream(folder_.path() / file.name, std::ios::binary) << file.bytes;
    written_ = target;
    return folder_.path();
  }

  /// For the one who mends it: a seed for the reader's folder in tests/fuzz/corpus.
  static void keep(const MutatedBytes& bytes) {
    std::ofstream(fs::temp_directory_path() / "remount-mutation", std::ios::binary) << bytes;
  }

  TemporaryFolder folder_;
  Sample sample_;
  const Reader* reader_ = nullptr;
  bool pack_ = false;
  std::vector<PackedFile> files_;
  std::string written_;  ///< the file of the pack that was damaged last
  int attempts_ = 0, refused_ = 0;
  double longest_s_ = 0.0;
};

TEST_P(mutated_input, is_read_or_refused) {
  try {
    reader_->read(write_input(*reader_, sample_.bytes, folder_.path()));
  } catch (const Error& error) {
    FAIL() << "is not valid to begin with: " << error.what();
  }
  const double peak_before_mb = peak_mb();
  cut();
  mutate();
  const double grown_mb = peak_mb() - peak_before_mb;
  std::cout << sample_.reader << ", " << sample_.name << ": " << attempts_ << " mutations, " << refused_
            << " refused, longest " << longest_s_ << " s, memory grew by " << grown_mb << " MB\n";
  EXPECT_LT(grown_mb, 250.0) << "more than such small files can need";
}

std::string test_name(const ::testing::TestParamInfo<std::size_t>& index) {
  std::string name = sample_names().at(index.param);
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(of, mutated_input, ::testing::Range(std::size_t{0}, sample_names().size()), test_name);

}  // namespace
}  // namespace remount::formats
