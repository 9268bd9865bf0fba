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
