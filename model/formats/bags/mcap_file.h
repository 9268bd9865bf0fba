// MCAP, version 0: what ROS 2 records today, and what bags of ROS 1 are converted to.
#pragma once

#include <map>
#include <set>

#include "model/formats/bags/bag_file.h"
#include "model/formats/bags/chunk_store.h"
#include "model/formats/bags/unpacked_file.h"

namespace remount::bags {

/// True where the file begins as an MCAP does.
bool is_mcap(std::string_view head);

/// Reads the summary and the message indexes of the chunks. Where there are none, or they are damaged, or messages lie
/// outside of chunks, the file is read from the beginning instead; a file that was cut or damaged gives what is
/// readable and a finding "bag-unindexed" that says how much that is, or "bag-cut-end" where all data are whole and
/// only what follows them is not. Checksums are compared where there are any: a chunk whose own is wrong is not read,
/// the others are. Messages in CDR that are compressed one by one (Zstandard) are unpacked.
class McapFile final : public BagFile {
 public:
  /// Throws Error where the file is no MCAP of this version or holds no readable message at all.
  McapFile(const BagInput& input, Progress& progress);
  std::string message(const BagEntry& entry, std::size_t at_most) const override;

 private:
  struct Record;
  static Record read_record(const ByteSource& source, std::uint64_t offset, bool whole = true);
  bool read_summary(Progress& progress);
  void check_summary(std::uint64_t start, const std::string& footer_content, const Record& footer) const;
  void check_other_sums(Progress& progress);
  void read_chunk_index(std::string_view content, const std::string& where);
  void read_message_index(std::string_view content, std::uint32_t chunk, const std::string& where);
  /// @param why_no_summary empty: it has none by its footer, which a recorder may choose
  void scan(const Message& why_no_summary, Progress& progress);
  void scan_record(const ByteSource& source, const Record& record, std::uint32_t chunk);
  void scan_chunk(std::uint32_t chunk);
  /// Chunk record at an offset of the file.
  BagChunk chunk_at(std::uint64_t offset) const;
  void add_schema(std::string_view content, const std::string& where);
  void add_channel(std::string_view content, const std::string& where);
  std::size_t topic_of(std::uint16_t channel, const std::string& where) const;
  void forget_all();

  BagInput input_;
  ChunkStore chunks_;
  bool has_cdr_ = false;
  struct Schema {
    std::string type, definition;
  };
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, std::size_t> topic_of_channel_;
  std::set<std::uint64_t> chunk_starts_;  // of those that the index has named
  bool summary_whole_ = false;            // up to what is within it
  bool undescribed_ = false;              // the summary leaves channels to the chunks
};

}  // namespace remount::bags
