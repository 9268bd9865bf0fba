// What the operating system and libraries say of a failure, as messages.
#pragma once

#include <string_view>
#include <system_error>

#include "algorithms/messages/message.h"

namespace remount::formats {

/// @param number as in errno. What is not in the catalogue is said in the system's own words.
Message system_words(int number);
Message system_words(const std::error_code& problem);

/// Of SQLite and yaml-cpp, which give nothing but English words. What is not in the catalogue stays as it is.
Message library_words(std::string_view words);

}  // namespace remount::formats
