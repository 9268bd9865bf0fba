// What every kind of bag offers: topics, where their messages lie, and the bytes of each.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/drive/session.h"

namespace remount::bags {

enum class MessageEncoding {
  Ros1,      ///< ROS 1 serialisation: packed, little-endian
  Cdr,       ///< what ROS 2 writes: aligned, with a header that says the byte order
  Protobuf,  ///< Protocol Buffers, in records of Cyber: see apollo_messages.h
  Other,     ///< listed, not read
};

inline constexpr std::uint32_t kNoChunk = std::numeric_limits<std::uint32_t>::max();

/// Where a message lies.
struct BagEntry {
  std::int64_t log_time_ns = 0;  ///< when the recorder took it down, Unix time
  std::uint64_t offset = 0;      ///< of its record: in the unpacked chunk, in the file, or its row in a database
  std::uint32_t chunk = kNoChunk;
  std::uint32_t file = 0;  ///< of a bag that was split into several files
};

struct BagTopic {
  std::string name;
  std::string type;  ///< "sensor_msgs/PointCloud2", in ROS 2 as in ROS 1; "apollo.drivers.PointCloud"
  MessageEncoding encoding = MessageEncoding::Other;
  std::vector<BagEntry> entries;  ///< in the order of log_time_ns
  /// Of its type as the bag has it: fields, and behind lines of '=' those of the messages in it. Empty where it is in
  /// another language, or the bag has none.
  std::string definition = {};
};

/// An open bag. Its index is in memory, its messages are not.
class BagFile {
 public:
  virtual ~BagFile() = default;

  /// In the order of their names.
  const std::vector<BagTopic>& topics() const { return topics_; }
  const std::vector<drive::Finding>& findings() const { return findings_; }
  const std::vector<std::filesystem::path>& files() const { return files_; }

  /// The first `at_most` bytes of a message. Thread-safe. Throws Error (file, place, expectation).
  virtual std::string message(const BagEntry& entry,
                              std::size_t at_most = std::numeric_limits<std::size_t>::max()) const = 0;
  /// The last `at_most` bytes of a message; likewise.
  virtual std::string message_end(const BagEntry& entry, std::size_t at_most) const;

 protected:
  /// The topic of that name and type, new where there was none. "pkg/msg/Type" becomes "pkg/Type".
  std::size_t topic(std::string name, std::string type, MessageEncoding encoding, std::string_view definition = {});
  /// The definition of a type that is read by it, which those of packets are; nothing where it is longer than any is,
  /// or all are: a bag may have them without end.
  std::string kept_definition(std::string_view type, std::string_view definition);
  /// Throws Error(Format) at `where` beyond what a file of `file_bytes` can hold: an index may lie.
  void add_entry(std::size_t topic, const BagEntry& entry, std::uint64_t file_bytes, const std::string& where);
  std::size_t entry_count() const { return entry_count_; }
  void forget_topics();
  /// Brings topics and entries into their order.
  void sort_topics();

  std::vector<BagTopic> topics_;
  std::vector<drive::Finding> findings_;
  std::vector<std::filesystem::path> files_;

 private:
  std::size_t entry_count_ = 0;
  std::size_t definition_bytes_ = 0;
};

/// "pkg/msg/Type" as "pkg/Type".
std::string short_type(std::string_view type);

/// Opens a bag of any kind that is known: a file, or a folder that holds one. Throws Error where nothing can be read;
/// damage that leaves something readable becomes a finding.
std::shared_ptr<const BagFile> open_bag(const std::filesystem::path& path, Progress& progress);

/// How sure, from the content: 0 (no) to 100. Never throws.
int probe_bag(const std::filesystem::path& path);

}  // namespace remount::bags
