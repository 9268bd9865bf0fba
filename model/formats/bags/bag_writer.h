// Writing bags message by message.
#pragma once

#include <memory>

#include "model/formats/bags/chunk_codec.h"
#include "model/formats/bags/message_writer.h"

namespace remount::bags {

/// Messages are to come in the order of their times. Throws Error(Io) where writing fails; the file appears under its
/// name with finish() and not before.
class BagWriter {
 public:
  virtual ~BagWriter() = default;
  virtual MessageEncoding encoding() const = 0;
  /// @return the number by which messages of the topic are written
  virtual std::uint32_t add_topic(const std::string& name, const MessageDefinition& definition) = 0;
  virtual void write(std::uint32_t topic, std::int64_t log_time_ns, std::string_view message) = 0;
  virtual void finish() = 0;
};

/// A bag of ROS 1, format 2.0. @param chunk_bytes of unpacked messages that make a chunk full
std::unique_ptr<BagWriter> make_rosbag1_writer(const std::filesystem::path& path, ChunkCompression compression,
                                               std::size_t chunk_bytes = 768 * 1024);

/// An MCAP as ROS 2 (Cdr) or a converter of ROS 1 bags writes it. @param encoding Ros1 or Cdr
std::unique_ptr<BagWriter> make_mcap_writer(const std::filesystem::path& path, MessageEncoding encoding,
                                            ChunkCompression compression, std::size_t chunk_bytes = 768 * 1024);

/// A database of rosbag2, in CDR. Its metadata.yaml is not written: `ros2 bag reindex` makes it.
std::unique_ptr<BagWriter> make_sqlite_writer(const std::filesystem::path& path);

/// A record of Cyber, whose messages are those of apollo_writer.h.
std::unique_ptr<BagWriter> make_record_writer(const std::filesystem::path& path, std::size_t chunk_bytes = 4096 * 1024);

}  // namespace remount::bags
