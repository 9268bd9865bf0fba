#include <map>
#include <vector>

#include "algorithms/core/error.h"
#include "model/formats/bags/bag_writer.h"
#include "model/formats/bags/mcap_format.h"
#include "model/formats/bags/raw_bytes.h"
#include "model/formats/files/append_file.h"
#include "model/formats/files/crc32.h"

namespace remount::bags {
namespace {

using namespace mcap;

std::string with_length(std::string_view text) {
  return raw_bytes(static_cast<std::uint32_t>(text.size())).append(text);
}

std::string record(Op op, std::string_view content) {
  return (raw_bytes<std::uint8_t>(op) + raw_bytes<std::uint64_t>(content.size())).append(content);
}

class McapWriter final : public BagWriter {
 public:
  McapWriter(const std::filesystem::path& path, MessageEncoding encoding, ChunkCompression compression,
             std::size_t chunk_bytes)
      : file_(path), encoding_(encoding), compression_(compression), chunk_bytes_(chunk_bytes) {
    append(kMagic);
    append(record(kHeader, with_length(ros1() ? "ros1" : "ros2") + with_length("remount")));
  }

  MessageEncoding encoding() const override { return encoding_; }

  std::uint32_t add_topic(const std::string& name, const MessageDefinition& definition) override {
    const auto id = static_cast<std::uint16_t>(channels_.size() + 1);
    // A schema for each channel; that two channels have the same does no harm.
    schemas_ += record(kSchema, raw_bytes(id) + with_length(definition.type) +
                                    with_length(ros1() ? "ros1msg" : "ros2msg") + with_length(definition.text));
    channels_.push_back(record(kChannel, raw_bytes(id) + raw_bytes(id) + with_length(name) +
                                             with_length(ros1() ? "ros1" : "cdr") + raw_bytes<std::uint32_t>(0)));
    counts_.push_back(0);
    return id - 1U;
  }

  void write(std::uint32_t topic, std::int64_t log_time_ns, std::string_view message) override {
    const auto channel = static_cast<std::uint16_t>(topic + 1);
    if (described_ < channels_.size()) {
      chunk_ += schemas_;
      for (const std::string& one : channels_) chunk_ += one;
      described_ = channels_.size();
    }
    if (index_.empty()) start_ns_ = log_time_ns;
    if (counts_total() == 0) first_ns_ = log_time_ns;
    end_ns_ = log_time_ns;
    index_[channel] += raw_bytes(log_time_ns) + raw_bytes<std::uint64_t>(chunk_.size());
    std::string content =
        raw_bytes(channel) + raw_bytes(counts_.at(topic)++) + raw_bytes(log_time_ns) + raw_bytes(log_time_ns);
    chunk_ += record(kMessage, content.append(message));
    if (chunk_.size() >= chunk_bytes_) close_chunk();
  }

  void finish() override {
    if (!index_.empty()) close_chunk();
    append(record(kDataEnd, raw_bytes(checksum_)));
    checksum_ = 0;  // the summary has its own
    const std::uint64_t summary = file_.size();
    append(schemas_);
    for (const std::string& channel : channels_) append(channel);
    append(record(kStatistics, statistics()));
    const std::uint64_t chunk_indexes = file_.size();
    for (const std::string& index : chunk_indexes_) append(index);
    const std::uint64_t offsets = file_.size();
    append(record(kSummaryOffset, raw_bytes<std::uint8_t>(kChunkIndex) + raw_bytes(chunk_indexes) +
                                      raw_bytes(offsets - chunk_indexes)));
    const std::string footer = raw_bytes(summary) + raw_bytes(offsets) + raw_bytes<std::uint32_t>(0);
    append(record(kFooter, footer).substr(0, kRecordHead + footer.size() - sizeof(std::uint32_t)));
    append(raw_bytes(checksum_));
    append(kMagic);
    file_.finish();
  }

 private:
  void append(std::string_view bytes) {
    file_.append(bytes);
    checksum_ = formats::crc32(bytes, checksum_);
  }
  bool ros1() const { return encoding_ == MessageEncoding::Ros1; }
  std::uint64_t counts_total() const {
    std::uint64_t total = 0;
    for (const std::uint32_t count : counts_) total += count;
    return total;
  }

  std::string statistics() const {
    const auto count = static_cast<std::uint16_t>(channels_.size());
    std::string each;
    for (std::size_t i = 0; i < counts_.size(); ++i)
      each += raw_bytes(static_cast<std::uint16_t>(i + 1)) + raw_bytes<std::uint64_t>(counts_[i]);
    return raw_bytes(counts_total()) + raw_bytes(count) + raw_bytes<std::uint32_t>(count) +
           raw_bytes<std::uint32_t>(0) + raw_bytes<std::uint32_t>(0) +
           raw_bytes(static_cast<std::uint32_t>(chunk_indexes_.size())) + raw_bytes(first_ns_) + raw_bytes(end_ns_) +
           with_length(each);
  }

  void close_chunk() {
    const char* name = compression_ == ChunkCompression::Zstd  ? "zstd"
                       : compression_ == ChunkCompression::Lz4 ? "lz4"
                                                               : "";
    const std::string packed = pack_chunk(compression_, chunk_);
    const std::uint64_t start = file_.size();
    std::string head = raw_bytes(start_ns_) + raw_bytes(end_ns_) + raw_bytes<std::uint64_t>(chunk_.size()) +
                       raw_bytes(formats::crc32(chunk_));
    head += with_length(name) + raw_bytes<std::uint64_t>(packed.size());
    append(record(kChunk, head + packed));
    const std::uint64_t indexes = file_.size();
    std::string offsets;
    for (const auto& [channel, items] : index_) {
      offsets += raw_bytes(channel) + raw_bytes(file_.size());
      append(record(kMessageIndex, raw_bytes(channel) + with_length(items)));
    }
    chunk_indexes_.push_back(
        record(kChunkIndex, raw_bytes(start_ns_) + raw_bytes(end_ns_) + raw_bytes(start) + raw_bytes(indexes - start) +
                                with_length(offsets) + raw_bytes(file_.size() - indexes) + with_length(name) +
                                raw_bytes<std::uint64_t>(packed.size()) + raw_bytes<std::uint64_t>(chunk_.size())));
    chunk_.clear();
    index_.clear();
  }

  formats::AppendFile file_;
  MessageEncoding encoding_;
  ChunkCompression compression_;
  std::size_t chunk_bytes_;
  std::string schemas_;                // records
  std::vector<std::string> channels_;  // records
  std::size_t described_ = 0;          // channels that stand in a chunk
  std::vector<std::uint32_t> counts_;
  std::string chunk_;
  std::map<std::uint16_t, std::string> index_;  // times and offsets
  std::int64_t start_ns_ = 0, end_ns_ = 0, first_ns_ = 0;
  std::vector<std::string> chunk_indexes_;  // records
  std::uint32_t checksum_ = 0;              // of what was written: of the data, then of the summary
};

}  // namespace

std::unique_ptr<BagWriter> make_mcap_writer(const std::filesystem::path& path, MessageEncoding encoding,
                                            ChunkCompression compression, std::size_t chunk_bytes) {
  if (compression == ChunkCompression::Bzip2)
    throw Error(ErrorCode::Contract, path.string(), Message::verbatim("MCAP knows no bzip2"));
  return std::make_unique<McapWriter>(path, encoding, compression, chunk_bytes);
}

}  // namespace remount::bags
