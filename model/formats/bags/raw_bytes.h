// Numbers as the bytes of a file, least significant first, as bags have them.
#pragma once

#include <cstring>
#include <string>

namespace remount::bags {

template <class T>
std::string raw_bytes(T value) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return bytes;
}

}  // namespace remount::bags
