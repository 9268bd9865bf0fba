#include <map>
#include <vector>

#include "algorithms/core/error.h"
#include "model/formats/bags/bag_writer.h"
#include "model/formats/bags/proto_reader.h"
#include "model/formats/bags/raw_bytes.h"
#include "model/formats/bags/record_format.h"
#include "model/formats/files/append_file.h"

namespace remount::bags {
namespace {

std::string section_of(cyber::Section kind, std::string_view content) {
  return (raw_bytes(static_cast<std::uint64_t>(kind)) + raw_bytes<std::uint64_t>(content.size())).append(content);
}

class RecordWriter final : public BagWriter {
 public:
  RecordWriter(const std::filesystem::path& path, std::size_t chunk_bytes) : file_(path), chunk_bytes_(chunk_bytes) {
    file_.append(header(false));
  }

  MessageEncoding encoding() const override { return MessageEncoding::Protobuf; }

  std::uint32_t add_topic(const std::string& name, const MessageDefinition& definition) override {
    channels_.push_back({name, definition.type, 0, 0});
    ProtoWriter channel;
    channel.bytes(cyber::kChannelName, name)
        .bytes(cyber::kMessageType, definition.type)
        .bytes(cyber::kDescription, definition.text);
    file_.append(section_of(cyber::kChannel, channel.message()));
    channels_.back().position = file_.size();  // recorders write what is behind
    return static_cast<std::uint32_t>(channels_.size() - 1);
  }

  void write(std::uint32_t topic, std::int64_t log_time_ns, std::string_view message) override {
    Channel& channel = channels_.at(topic);
    ProtoWriter one;
    one.bytes(cyber::kMessageChannel, channel.name)
        .whole(cyber::kMessageTime, static_cast<std::uint64_t>(log_time_ns))
        .bytes(cyber::kMessageContent, message);
    body_.bytes(cyber::kChunkMessage, one.message());
    if (in_chunk_++ == 0) chunk_begin_ns_ = log_time_ns;
    if (messages_++ == 0) begin_ns_ = log_time_ns;
    end_ns_ = log_time_ns;
    raw_bytes_ += message.size();
    ++channel.messages;
    if (raw_bytes_ >= chunk_bytes_) close_chunk();
  }

  void finish() override {
    close_chunk();
    index_position_ = file_.size();
    file_.append(section_of(cyber::kIndex, index()));
    file_.overwrite(0, header(true));
    file_.finish();
  }

 private:
  struct Channel {
    std::string name, type;
    std::uint64_t messages = 0, position = 0;
  };
  struct ChunkPlace {
    std::string head;
    std::uint64_t messages = 0, head_position = 0, body_position = 0;
  };

  std::string header(bool complete) const {
    ProtoWriter fields;
    fields.whole(cyber::kMajorVersion, 1).whole(cyber::kMinorVersion, 0).whole(cyber::kCompress, cyber::kUncompressed);
    fields.whole(cyber::kIndexPosition, index_position_).whole(cyber::kChunkNumber, chunks_.size());
    fields.whole(cyber::kChannelNumber, channels_.size())
        .whole(cyber::kBeginTime, static_cast<std::uint64_t>(begin_ns_));
    fields.whole(cyber::kEndTime, static_cast<std::uint64_t>(end_ns_)).whole(cyber::kMessageNumber, messages_);
    fields.whole(cyber::kSize, file_.size()).whole(cyber::kIsComplete, complete ? 1 : 0);
    std::string section = section_of(cyber::kHeader, fields.message());
    section.resize(cyber::kSectionHead + cyber::kHeaderRoom);
    return section;
  }

  void close_chunk() {
    if (in_chunk_ == 0) return;
    ProtoWriter head;
    head.whole(cyber::kChunkBegin, static_cast<std::uint64_t>(chunk_begin_ns_))
        .whole(cyber::kChunkEnd, static_cast<std::uint64_t>(end_ns_))
        .whole(cyber::kChunkMessages, in_chunk_)
        .whole(cyber::kChunkRawSize, raw_bytes_);
    ChunkPlace place{head.message(), in_chunk_, 0, 0};
    file_.append(section_of(cyber::kChunkHeader, head.message()));
    place.head_position = file_.size();
    file_.append(section_of(cyber::kChunkBody, body_.message()));
    place.body_position = file_.size();
    chunks_.push_back(std::move(place));
    body_ = {};
    in_chunk_ = raw_bytes_ = 0;
  }

  std::string index() const {
    constexpr std::uint32_t kEntry = 1, kKind = 1, kPlace = 2, kOfChannel = 101, kOfChunkHeader = 102,
                            kOfChunkBody = 103;
    ProtoWriter entries;
    const auto add = [&](cyber::Section kind, std::uint64_t position, std::uint32_t field, std::string_view content) {
      entries.bytes(kEntry, ProtoWriter().whole(kKind, kind).whole(kPlace, position).bytes(field, content).message());
    };
    for (const Channel& channel : channels_)
      add(cyber::kChannel, channel.position, kOfChannel,
          ProtoWriter().whole(1, channel.messages).bytes(2, channel.name).bytes(3, channel.type).message());
    for (const ChunkPlace& chunk : chunks_) {
      add(cyber::kChunkHeader, chunk.head_position, kOfChunkHeader, ProtoWriter().whole(1, chunk.messages).message());
      add(cyber::kChunkBody, chunk.body_position, kOfChunkBody, ProtoWriter().whole(1, chunk.messages).message());
    }
    return entries.message();
  }

  formats::AppendFile file_;
  std::size_t chunk_bytes_;
  std::vector<Channel> channels_;
  std::vector<ChunkPlace> chunks_;
  ProtoWriter body_;
  std::uint64_t in_chunk_ = 0, raw_bytes_ = 0, messages_ = 0, index_position_ = 0;
  std::int64_t chunk_begin_ns_ = 0, begin_ns_ = 0, end_ns_ = 0;
};

}  // namespace

std::unique_ptr<BagWriter> make_record_writer(const std::filesystem::path& path, std::size_t chunk_bytes) {
  return std::make_unique<RecordWriter>(path, chunk_bytes);
}

}  // namespace remount::bags
