#include "model/formats/files/text_file.h"

#include <utility>

namespace remount::formats {
namespace {

enum class TextEncoding { Utf8, Utf16LittleEndian, Utf16BigEndian };

bool is_latin(char c) { return (c >= ' ' && c <= '~') || c == '\n' || c == '\r' || c == '\t'; }

TextEncoding encoding_of(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE")) return TextEncoding::Utf16LittleEndian;
  if (bytes.starts_with("\xFE\xFF")) return TextEncoding::Utf16BigEndian;
  const auto latin_at = [&](std::size_t letters, std::size_t zeros) {
    return bytes.size() >= 4 && is_latin(bytes[letters]) && is_latin(bytes[letters + 2]) && bytes[zeros] == '\0' &&
           bytes[zeros + 2] == '\0';
  };
  if (latin_at(0, 1)) return TextEncoding::Utf16LittleEndian;
  return latin_at(1, 0) ? TextEncoding::Utf16BigEndian : TextEncoding::Utf8;
}

void append_utf8(std::string& text, char32_t c) {
  const auto add = [&](char32_t byte) { text += static_cast<char>(byte); };
  if (c < 0x80) return add(c);
  if (c < 0x800) return add(0xC0 | c >> 6U), add(0x80 | (c & 0x3FU));
  if (c < 0x10000) {
    add(0xE0 | c >> 12U);
  } else {
    add(0xF0 | c >> 18U);
    add(0x80 | (c >> 12U & 0x3FU));
  }
  add(0x80 | (c >> 6U & 0x3FU));
  add(0x80 | (c & 0x3FU));
}

std::string from_utf16(std::string_view bytes, bool little_endian) {
  constexpr char32_t kNoCharacter = 0xFFFD;
  const auto unit = [&](std::size_t i) -> char32_t {
    const auto first = static_cast<unsigned char>(bytes[i]), second = static_cast<unsigned char>(bytes[i + 1]);
    return little_endian ? char32_t{first} | char32_t{second} << 8U : char32_t{first} << 8U | char32_t{second};
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  std::size_t i = bytes.size() >= 2 && unit(0) == 0xFEFF ? 2 : 0;
  for (; i + 1 < bytes.size(); i += 2) {
    char32_t c = unit(i);
    if (c >= 0xD800 && c < 0xE000) {
      const bool high = c < 0xDC00;
      const char32_t low = high && i + 3 < bytes.size() ? unit(i + 2) : 0;
      const bool whole = low >= 0xDC00 && low < 0xE000;
      c = whole ? 0x10000 + ((c - 0xD800) << 10U) + (low - 0xDC00) : kNoCharacter;
      if (whole) i += 2;
    }
    append_utf8(text, c);
  }
  if (i < bytes.size()) append_utf8(text, kNoCharacter);
  return text;
}

}  // namespace

std::string utf8_text(std::string bytes) {
  const TextEncoding encoding = encoding_of(bytes);
  if (encoding != TextEncoding::Utf8) return from_utf16(bytes, encoding == TextEncoding::Utf16LittleEndian);
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
  return bytes;
}

std::string read_text_file(const std::filesystem::path& path, std::uint64_t max_bytes) {
  return utf8_text(read_regular_file(path, max_bytes));
}

bool is_plain_text(const std::filesystem::path& path) {
  const std::string head = read_file_head(path, 4);
  return utf8_text(head) == head;
}

std::string read_text_head(const std::filesystem::path& path, std::size_t bytes) {
  return utf8_text(read_file_head(path, bytes & ~std::size_t{1}));
}

}  // namespace remount::formats
