// The time by the clock of this computer, where a document says when it was made.
#pragma once

#include <string>

namespace remount::formats {

/// For people, to the second: "2011-09-26 13:02:25 UTC".
std::string now_in_utc();

}  // namespace remount::formats
