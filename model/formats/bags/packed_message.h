// Messages that rosbag2 compressed one by one (--compression-mode message), in databases and in MCAP alike.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace remount::bags {

/// A message as it lies in the bag.
struct StoredMessage {
  std::uint64_t bytes = 0;                               ///< how long it is
  std::function<std::string(std::uint64_t count)> read;  ///< its first `count` bytes
  std::uint64_t file_bytes = 0;                          ///< of the bag: how much a message may become
  std::string where;
};

/// The first `at_most` bytes of a message in CDR, unpacked where it is a frame of Zstandard: CDR begins otherwise. Of a
/// long one no more is read than that takes. Throws Error(Format) where the frame is damaged before these bytes, or
/// says that it becomes larger than any message of a bag of this size.
std::string message_content(const StoredMessage& message, std::uint64_t at_most);

}  // namespace remount::bags
