#include "model/formats/files/atomic_save.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <functional>

#include "algorithms/core/error.h"
#include "algorithms/core/parallel.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/sha256.h"
#include "tests/support/exit_code.h"

namespace remount::formats {
namespace {

class atomic_save : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "remount_save_XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder_), std::filesystem::directory_iterator()));
  }
  static std::string error_of(const std::filesystem::path& path, std::string_view bytes) {
    try {
      save_atomically(path, bytes);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path folder_;
};

TEST_F(atomic_save, creates_and_replaces) {
  const auto path = folder_ / "a.yaml";
  save_atomically(path, "one");
  EXPECT_EQ(read_regular_file(path, 100), "one");
  std::filesystem::permissions(path, std::filesystem::perms(0640));
  save_atomically(path, std::string(300000, 'x'));
  EXPECT_EQ(read_regular_file(path, 1000000), std::string(300000, 'x'));
  EXPECT_EQ(std::filesystem::status(path).permissions(), std::filesystem::perms(0640));
  EXPECT_EQ(files(), 1U);
}

TEST_F(atomic_save, of_new_files_in_many_threads_gives_all_the_permissions_of_the_process) {
  const mode_t before = ::umask(027);
  constexpr std::size_t kFiles = 2000;
  parallel_for(kFiles, 4, [&](std::size_t i) { save_atomically(folder_ / std::to_string(i), "scan", Flush::Later); });
  EXPECT_EQ(::umask(before), mode_t{027}) << "it is the process's, and stays as it was";
  for (std::size_t i = 0; i < kFiles; ++i)
    ASSERT_EQ(std::filesystem::status(folder_ / std::to_string(i)).permissions(), std::filesystem::perms(0640)) << i;
}

TEST_F(atomic_save, of_files_that_belong_together_replaces_all_or_none) {
  save_together({{folder_ / "page", "one"}, {folder_ / "paper", "one"}});
  EXPECT_THROW(save_together({{folder_ / "page", "two"}, {folder_ / "nowhere" / "paper", "two"}}), Error);
  EXPECT_EQ(read_regular_file(folder_ / "page", 100), "one") << "the second cannot be written";
  save_together({{folder_ / "page", "three"}, {folder_ / "paper", "three"}});
  EXPECT_EQ(read_regular_file(folder_ / "page", 100) + read_regular_file(folder_ / "paper", 100), "threethree");
  EXPECT_EQ(files(), 2U) << "no temporary file is left";
}

TEST_F(atomic_save, follows_a_link_and_keeps_it) {
  save_atomically(folder_ / "real", "one");
  std::filesystem::create_symlink("real", folder_ / "link");
  save_atomically(folder_ / "link", "two");
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link"));
  EXPECT_EQ(read_regular_file(folder_ / "real", 100), "two");
}

TEST_F(atomic_save, names_path_and_reason) {
  EXPECT_NE(error_of(folder_ / "none" / "a", "x").find("there is no folder"), std::string::npos);
  EXPECT_NE(error_of(folder_, "x").find("it is a folder"), std::string::npos);
  EXPECT_NE(error_of("/dev/full", "x").find("no regular file"), std::string::npos);
  EXPECT_NE(error_of("", "x"), "");
  const auto fifo = folder_ / "fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  EXPECT_NE(error_of(fifo, "x").find("no regular file"), std::string::npos);
}

/// Runs in a child process, which may give up root and set limits for itself.
int exit_code_in_child(const std::function<int()>& body) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(body());
  int status = 0;
  ::waitpid(child, &status, 0);
  return testing::exit_code_of(status);
}

TEST_F(atomic_save, a_check_says_what_saving_would_and_leaves_nothing) {
  const auto refused = [](const std::filesystem::path& path) {
    try {
      check_can_save(path);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  save_atomically(folder_ / "old", "one");
  EXPECT_EQ(refused(folder_ / "new"), "");
  EXPECT_EQ(refused(folder_ / "old"), "");
  EXPECT_EQ(files(), 1U);
  EXPECT_EQ(read_regular_file(folder_ / "old", 100), "one");
  for (const std::filesystem::path& path : {folder_, folder_ / "none" / "x", std::filesystem::path("/dev/null")}) {
    EXPECT_NE(refused(path), "") << path;
    EXPECT_EQ(refused(path), error_of(path, "x"));
  }
}

TEST_F(atomic_save, a_full_disk_leaves_the_old_file) {
  const auto path = folder_ / "a.yaml";
  save_atomically(path, "old");
  const int code = exit_code_in_child([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{50000, 50000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const std::string error = error_of(path, std::string(200000, 'x'));
    return error.find("File too large") != std::string::npos && error.find(path.string()) != std::string::npos ? 0 : 1;
  });
  EXPECT_EQ(code, 0);
  EXPECT_EQ(read_regular_file(path, 100), "old");
  EXPECT_EQ(files(), 1U);
}

TEST_F(atomic_save, a_read_only_folder_leaves_the_old_file) {
  const auto path = folder_ / "a.yaml";
  save_atomically(path, "old");
  std::filesystem::permissions(folder_, std::filesystem::perms(0555));
  const int code = exit_code_in_child([&] {
    if (::getuid() == 0 && ::setuid(65534) != 0) return 2;
    const std::string error = error_of(path, "new");
    return error.find("Permission denied") != std::string::npos ? 0 : 1;
  });
  std::filesystem::permissions(folder_, std::filesystem::perms(0755));
  EXPECT_EQ(code, 0);
  EXPECT_EQ(read_regular_file(path, 100), "old");
}

TEST(sha256, known_vectors_with_any_instructions) {
  for (const HashInstructions instructions : {HashInstructions::Best, HashInstructions::Portable}) {
    Sha256 empty(instructions);
    EXPECT_EQ(empty.finish(), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    Sha256 abc(instructions);
    abc.update("abc");
    EXPECT_EQ(abc.finish(), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    Sha256 two_blocks(instructions);
    two_blocks.update("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq");
    EXPECT_EQ(two_blocks.finish(), "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    Sha256 million(instructions);
    for (int i = 0; i < 1000; ++i) million.update(std::string(1000, 'a'));
    EXPECT_EQ(million.finish(), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  }
}

TEST_F(atomic_save, hash_of_a_file_is_the_hash_of_its_bytes) {
  const std::string bytes(200001, 'q');
  save_atomically(folder_ / "a", bytes);
  Sha256 hash;
  hash.update(bytes);
  EXPECT_EQ(sha256_of_file(folder_ / "a"), hash.finish());
}

}  // namespace
}  // namespace remount::formats
