#include "model/formats/files/old_encodings.h"

#include <iconv.h>

#include <cerrno>
#include <memory>

namespace remount::formats {
namespace {

struct IconvCloser {
  void operator()(void* descriptor) const { iconv_close(descriptor); }
};

std::string without_other_bytes(std::string_view text) {
  std::string out;
  for (const char c : text) out += static_cast<unsigned char>(c) < 0x80 ? c : '?';
  return out;
}

}  // namespace

bool is_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const auto first = static_cast<unsigned char>(text[at]);
    const std::size_t bytes = first < 0x80   ? 1
                              : first < 0xc2 ? 0
                              : first < 0xe0 ? 2
                              : first < 0xf0 ? 3
                              : first < 0xf5 ? 4
                                             : 0;
    if (bytes == 0 || at + bytes > text.size()) return false;
    for (std::size_t i = 1; i < bytes; ++i)
      if ((static_cast<unsigned char>(text[at + i]) & 0xc0U) != 0x80U) return false;
    // Shorter forms, halves of pairs and what lies beyond Unicode.
    const auto second = bytes > 1 ? static_cast<unsigned char>(text[at + 1]) : 0U;
    if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) || (first == 0xf0 && second < 0x90) ||
        (first == 0xf4 && second > 0x8f))
      return false;
    at += bytes;
  }
  return true;
}

std::string decoded(std::string_view text, const char* encoding) {
  const iconv_t opened = iconv_open("UTF-8", encoding);
  // A small machine may lack the table of an encoding.
  if (opened == reinterpret_cast<iconv_t>(-1)) return without_other_bytes(text);
  const std::unique_ptr<void, IconvCloser> descriptor(opened);
  std::string bytes(text), out;
  char* from = bytes.data();
  std::size_t left = bytes.size();
  while (left > 0) {
    char buffer[256];
    char* to = buffer;
    std::size_t room = sizeof buffer;
    const std::size_t done = iconv(descriptor.get(), &from, &left, &to, &room);
    out.append(buffer, sizeof buffer - room);
    if (done != static_cast<std::size_t>(-1) || errno == E2BIG) continue;
    out += '?';
    ++from, --left;
  }
  return out;
}

}  // namespace remount::formats
