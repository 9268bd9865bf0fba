#include "model/formats/files/current_time.h"

#include <chrono>
#include <string_view>

#include "model/formats/files/time_stamp.h"

namespace remount::formats {

std::string now_in_utc() {
  constexpr std::size_t kToTheSecond = std::string_view("2011-09-26 13:02:25").size();
  const std::chrono::nanoseconds now = std::chrono::system_clock::now().time_since_epoch();
  return utc_text(now.count()).substr(0, kToTheSecond) + " UTC";
}

}  // namespace remount::formats
