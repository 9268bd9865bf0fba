// Encodings of text that were usual before UTF-8, and still are where tables are exported by older programs.
#pragma once

#include <string>
#include <string_view>

namespace remount::formats {

struct OldEncoding {
  const char* name;
  bool by_twos;  ///< letters beyond ASCII have two bytes, nearly all of them
};
/// Of Chinese, and of western Europe: the likelier first. Bytes do not always tell which of them a text has.
inline constexpr OldEncoding kOldEncodings[] = {{"GB18030", true}, {"WINDOWS-1252", false}};

/// The text as UTF-8. What is none in that encoding becomes "?".
std::string decoded(std::string_view text, const char* encoding);

}  // namespace remount::formats
