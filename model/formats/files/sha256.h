// SHA-256 (FIPS 180-4), to name in a result exactly which files it came from.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace remount::formats {

/// Which instructions hash: those for SHA where the processor has them, a fifth of the time, or any processor's.
enum class HashInstructions { Best, Portable };

/// Feed with update(), in pieces of any size; finish() once.
class Sha256 {
 public:
  explicit Sha256(HashInstructions instructions = HashInstructions::Best);
  void update(std::string_view bytes);
  /// 64 lower-case hexadecimal digits.
  std::string finish();

 private:
  using State = std::array<std::uint32_t, 8>;

  void (*process_)(const unsigned char* block, State& state);
  State state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<unsigned char, 64> block_{};
  std::size_t filled_ = 0;
  std::uint64_t length_ = 0;
};

/// Of a regular file, in bounded memory. Throws Error(Io).
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace remount::formats
