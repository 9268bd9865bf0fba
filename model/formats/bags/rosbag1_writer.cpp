#include <map>
#include <utility>
#include <vector>

#include "algorithms/core/error.h"
#include "model/formats/bags/bag_writer.h"
#include "model/formats/bags/raw_bytes.h"
#include "model/formats/bags/rosbag1_format.h"
#include "model/formats/files/append_file.h"

namespace remount::bags {
namespace {

constexpr std::size_t kBagHeaderBytes = 4096;

std::string raw_time(std::int64_t time_ns) {
  return raw_bytes(static_cast<std::uint32_t>(time_ns / 1'000'000'000)) +
         raw_bytes(static_cast<std::uint32_t>(time_ns % 1'000'000'000));
}

using Field = std::pair<std::string_view, std::string>;

std::string fields_text(const std::vector<Field>& fields) {
  std::string text;
  for (const auto& [name, value] : fields) {
    text += raw_bytes(static_cast<std::uint32_t>(name.size() + 1 + value.size()));
    text.append(name).append("=").append(value);
  }
  return text;
}

std::string record(rosbag1::Op op, std::vector<Field> fields, std::string_view data) {
  fields.insert(fields.begin(), {"op", raw_bytes<std::uint8_t>(op)});
  const std::string header = fields_text(fields);
  std::string bytes = raw_bytes(static_cast<std::uint32_t>(header.size())) + header;
  bytes += raw_bytes(static_cast<std::uint32_t>(data.size()));
  return bytes.append(data);
}

struct IndexEntry {
  std::int64_t time_ns = 0;
  std::uint32_t offset = 0;
};

class Rosbag1Writer final : public BagWriter {
 public:
  Rosbag1Writer(const std::filesystem::path& path, ChunkCompression compression, std::size_t chunk_bytes)
      : file_(path), compression_(compression), chunk_bytes_(chunk_bytes) {
    file_.append(std::string(rosbag1::kMagic));
    file_.append(bag_header(0));
  }

  MessageEncoding encoding() const override { return MessageEncoding::Ros1; }

  std::uint32_t add_topic(const std::string& name, const MessageDefinition& definition) override {
    const auto id = static_cast<std::uint32_t>(connections_.size());
    const std::string data = fields_text({{"topic", name},
                                          {"type", definition.type},
                                          {"md5sum", definition.md5},
                                          {"message_definition", definition.text}});
    connections_.push_back(record(rosbag1::kConnection, {{"conn", raw_bytes(id)}, {"topic", name}}, data));
    written_.push_back(false);
    return id;
  }

  void write(std::uint32_t topic, std::int64_t log_time_ns, std::string_view message) override {
    if (!written_.at(topic)) chunk_ += connections_[topic];
    written_[topic] = true;
    if (index_.empty()) start_ns_ = log_time_ns;
    end_ns_ = log_time_ns;
    index_[topic].push_back({log_time_ns, static_cast<std::uint32_t>(chunk_.size())});
    chunk_ += record(rosbag1::kMessage, {{"conn", raw_bytes(topic)}, {"time", raw_time(log_time_ns)}}, message);
    if (chunk_.size() >= chunk_bytes_) close_chunk();
  }

  void finish() override {
    if (!index_.empty()) close_chunk();
    const std::uint64_t index_offset = file_.size();
    for (const std::string& connection : connections_) file_.append(connection);
    for (const std::string& info : chunk_infos_) file_.append(info);
    file_.overwrite(rosbag1::kMagic.size(), bag_header(index_offset));
    file_.finish();
  }

 private:
  std::string bag_header(std::uint64_t index_offset) const {
    const std::vector<Field> fields{{"index_pos", raw_bytes(index_offset)},
                                    {"conn_count", raw_bytes(static_cast<std::uint32_t>(connections_.size()))},
                                    {"chunk_count", raw_bytes(static_cast<std::uint32_t>(chunk_infos_.size()))}};
    const std::size_t bytes = record(rosbag1::kBagHeader, fields, "").size();
    return record(rosbag1::kBagHeader, fields, std::string(kBagHeaderBytes - bytes, ' '));
  }

  void close_chunk() {
    const char* name = compression_ == ChunkCompression::Bzip2 ? "bz2"
                       : compression_ == ChunkCompression::Lz4 ? "lz4"
                                                               : "none";
    const std::uint64_t offset = file_.size();
    file_.append(record(rosbag1::kChunk,
                        {{"compression", name}, {"size", raw_bytes(static_cast<std::uint32_t>(chunk_.size()))}},
                        pack_chunk(compression_, chunk_)));
    std::string counts;
    for (const auto& [topic, entries] : index_) {
      std::string data;
      for (const IndexEntry& entry : entries) data += raw_time(entry.time_ns) + raw_bytes(entry.offset);
      const std::string count = raw_bytes(static_cast<std::uint32_t>(entries.size()));
      file_.append(record(rosbag1::kIndexData,
                          {{"ver", raw_bytes<std::uint32_t>(1)}, {"conn", raw_bytes(topic)}, {"count", count}}, data));
      counts += raw_bytes(topic) + count;
    }
    chunk_infos_.push_back(record(rosbag1::kChunkInfo,
                                  {{"ver", raw_bytes<std::uint32_t>(1)},
                                   {"chunk_pos", raw_bytes(offset)},
                                   {"start_time", raw_time(start_ns_)},
                                   {"end_time", raw_time(end_ns_)},
                                   {"count", raw_bytes(static_cast<std::uint32_t>(index_.size()))}},
                                  counts));
    chunk_.clear();
    index_.clear();
  }

  formats::AppendFile file_;
  ChunkCompression compression_;
  std::size_t chunk_bytes_;
  std::vector<std::string> connections_;  // records
  std::vector<bool> written_;             // in a chunk already
  std::string chunk_;
  std::map<std::uint32_t, std::vector<IndexEntry>> index_;
  std::int64_t start_ns_ = 0, end_ns_ = 0;
  std::vector<std::string> chunk_infos_;
};

}  // namespace

std::unique_ptr<BagWriter> make_rosbag1_writer(const std::filesystem::path& path, ChunkCompression compression,
                                               std::size_t chunk_bytes) {
  if (compression == ChunkCompression::Zstd)
    throw Error(ErrorCode::Contract, path.string(), Message::verbatim("bags of ROS 1 know no Zstandard"));
  return std::make_unique<Rosbag1Writer>(path, compression, chunk_bytes);
}

}  // namespace remount::bags
