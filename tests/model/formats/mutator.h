// Damage to files of any format, the same for the same seed.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace remount::formats {

using MutatedBytes = std::string;

/// Cuts, flips, inserts, repeats and swaps bytes, lines, numbers and columns.
class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  MutatedBytes damaged(const MutatedBytes& good) {
    MutatedBytes bytes = good;
    for (unsigned i = 0; i <= below(3); ++i) damage(bytes);
    return bytes;
  }
  std::size_t below(std::size_t count) { return count == 0 ? 0 : random_() % count; }

 private:
  void damage(MutatedBytes& bytes) {
    switch (below(11)) {
      case 0:
        bytes.resize(below(bytes.size() + 1));
        break;
      case 1:
        if (!bytes.empty()) bytes[below(bytes.size())] ^= static_cast<char>(1U << below(8));
        break;
      case 2:
        if (!bytes.empty()) bytes[below(bytes.size())] = static_cast<char>(below(256));
        break;
      case 3:
        bytes.erase(below(bytes.size() + 1), below(40));
        break;
      case 4:
        bytes.insert(below(bytes.size() + 1), below(40), static_cast<char>(below(256)));
        break;
      case 5:
        replace_number(bytes);
        break;
      case 6:
        replace_token(bytes);
        break;
      case 7:
        repeat_line(bytes);
        break;
      case 8:
        overwrite_scalar(bytes);
        break;
      case 9:
        drop_line(bytes);
        break;
      default:
        swap_pieces(bytes);
    }
  }

  /// In what counts, sizes, stamps and values are written as text.
  void replace_number(MutatedBytes& bytes) {
    static const std::vector<MutatedBytes> kHostile{"nan",
                                                    "inf",
                                                    "-inf",
                                                    "1e400",
                                                    "-1e308",
                                                    "1e-400",
                                                    "-1",
                                                    "0",
                                                    "-0",
                                                    "4294967295",
                                                    "4294967296",
                                                    "2147483648",
                                                    "-9223372036854775808",
                                                    "9223372036854775807",
                                                    "18446744073709551615",
                                                    "1000000000",
                                                    "65536",
                                                    "0x10",
                                                    "1e999999",
                                                    MutatedBytes(400, '9'),
                                                    "0." + MutatedBytes(500, '3'),
                                                    "1.5",
                                                    "",
                                                    "--1",
                                                    "+1",
                                                    "1,5",
                                                    "6.3",
                                                    "90",
                                                    "1e18",
                                                    "9200000000"};
    const std::size_t begin = bytes.find_first_of("0123456789", below(bytes.size()));
    if (begin == MutatedBytes::npos) return;
    const std::size_t end = bytes.find_first_not_of("0123456789.eE+-", begin);
    bytes.replace(begin, (end == MutatedBytes::npos ? bytes.size() : end) - begin, kHostile[below(kHostile.size())]);
  }
  /// Removes a column, or makes it something else.
  void replace_token(MutatedBytes& bytes) {
    static const std::vector<MutatedBytes> kTokens{"",
                                                   "x",
                                                   "\"",
                                                   "{",
                                                   "}",
                                                   "[",
                                                   "]",
                                                   "&a",
                                                   "*a",
                                                   "<<",
                                                   "|",
                                                   "\n",
                                                   "\r",
                                                   ",,,,",
                                                   ";",
                                                   "#",
                                                   "-",
                                                   ":",
                                                   "null",
                                                   "true",
                                                   "~",
                                                   "\xff\xfe",
                                                   "\xc3\x28",
                                                   MutatedBytes(3000, 'a'),
                                                   MutatedBytes(200, '['),
                                                   MutatedBytes(200, '{'),
                                                   MutatedBytes("\0\0\0\0", 4)};
    const std::size_t begin = bytes.find_first_of(" ,\n:", below(bytes.size()));
    if (begin == MutatedBytes::npos) return;
    const std::size_t end = bytes.find_first_of(" ,\n:", begin + 1);
    bytes.replace(begin + 1, (end == MutatedBytes::npos ? bytes.size() : end) - begin - 1,
                  kTokens[below(kTokens.size())]);
  }
  std::pair<std::size_t, std::size_t> line(const MutatedBytes& bytes) {
    const std::size_t at = below(bytes.size());
    const std::size_t before = at == 0 ? MutatedBytes::npos : bytes.rfind('\n', at - 1);
    const std::size_t begin = before == MutatedBytes::npos ? 0 : before + 1, end = bytes.find('\n', begin);
    return {begin, (end == MutatedBytes::npos ? bytes.size() : end + 1) - begin};
  }
  void repeat_line(MutatedBytes& bytes) {
    const auto [begin, length] = line(bytes);
    const MutatedBytes copy = bytes.substr(begin, length);
    for (std::size_t times = 1 + below(3), i = 0; i < times; ++i) bytes.insert(begin, copy);
  }
  void drop_line(MutatedBytes& bytes) {
    const auto [begin, length] = line(bytes);
    bytes.erase(begin, length);
  }
  /// In what counts and values are written as binary: of 2, 4 or 8 bytes.
  void overwrite_scalar(MutatedBytes& bytes) {
    static constexpr std::array<std::uint64_t, 8> kValues{~std::uint64_t{0},     0,
                                                          0x7fffffff7fffffffULL, 0x8000000080000000ULL,
                                                          0x7ff8000000000000ULL, 0x7fc000007fc00000ULL,
                                                          0x7f8000007f800000ULL, 0x0000000100000001ULL};
    const std::size_t size = std::size_t{2} << below(3);
    if (bytes.size() < size) return;
    const std::uint64_t value = kValues[below(kValues.size())];
    std::memcpy(bytes.data() + below(bytes.size() - size + 1), &value, size);
  }
  void swap_pieces(MutatedBytes& bytes) {
    if (bytes.size() < 8) return;
    const std::size_t length = 1 + below(bytes.size() / 4), from = below(bytes.size() - length + 1);
    bytes.insert(below(bytes.size() + 1), bytes.substr(from, length));
  }

  std::mt19937 random_;
};

}  // namespace remount::formats
