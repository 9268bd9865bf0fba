// Bags of ROS 1, format 2.0.
#pragma once

#include <map>

#include "model/formats/bags/bag_file.h"
#include "model/formats/bags/chunk_store.h"

namespace remount::bags {

/// True where the file begins as a bag of ROS 1 of any version does.
bool is_rosbag1(std::string_view head);

/// Reads the index at the end and the index of each chunk. Where the bag was not closed, was cut, or its index is
/// damaged, it is read from the beginning instead as far as it goes, with a finding "bag-unindexed" that says how far.
class Rosbag1File final : public BagFile {
 public:
  /// Throws Error where the file is no bag of this version or holds no readable message at all.
  Rosbag1File(const std::filesystem::path& path, Progress& progress);
  std::string message(const BagEntry& entry, std::size_t at_most) const override;

 private:
  struct Record;
  static std::uint64_t behind_zeros(const ByteSource& source, std::uint64_t offset);
  static Record read_record(const ByteSource& source, std::uint64_t offset, bool whole = true);
  void read_index(std::uint64_t index_offset, std::uint32_t chunk_count, Progress& progress);
  void read_chunk_index(std::uint64_t chunk_offset);
  void scan(std::uint64_t offset, const Message& why, Progress& progress);
  void scan_chunk(const Record& record, bool cut);
  BagChunk chunk_of(const Record& record, bool cut) const;
  void add_connection(const ByteSource& source, const Record& record);
  std::size_t topic_of(std::uint32_t connection, const std::string& where) const;

  ChunkStore chunks_;
  std::map<std::uint32_t, std::size_t> topic_of_connection_;
};

}  // namespace remount::bags
