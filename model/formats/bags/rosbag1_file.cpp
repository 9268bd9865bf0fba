#include "model/formats/bags/rosbag1_file.h"

#include <algorithm>

#include "messages/bags.h"
#include "messages/stages.h"
#include "model/drive/bad_items.h"
#include "model/formats/bags/byte_reader.h"
#include "model/formats/bags/rosbag1_format.h"

namespace remount::bags {
namespace {

constexpr std::uint64_t kRecordHeadBytes = 512;  // most record headers fit
constexpr std::uint64_t kMaxHeaderBytes = std::uint64_t{1} << 20;

using Fields = std::map<std::string, std::string, std::less<>>;

Fields read_fields(std::string_view bytes, const std::string& where) {
  Fields fields;
  ByteReader reader(bytes, where);
  while (reader.left() > 0) {
    const std::string_view field = reader.string();
    const std::size_t equals = field.find('=');
    if (equals == std::string_view::npos) throw Error(ErrorCode::Format, where, say::bag_header_field());
    fields.emplace(field.substr(0, equals), field.substr(equals + 1));
  }
  return fields;
}

std::int64_t read_time_ns(ByteReader& reader) {
  const auto seconds = reader.number<std::uint32_t>(), nanoseconds = reader.number<std::uint32_t>();
  return std::int64_t{seconds} * 1'000'000'000 + nanoseconds;
}

}  // namespace

/// A record: <header length><header><data length><data>.
struct Rosbag1File::Record {
  Fields fields;
  std::string where;
  std::uint64_t data_offset = 0;
  std::uint64_t data_bytes = 0;
  std::uint64_t end() const { return data_offset + data_bytes; }

  std::string_view field(std::string_view name) const {
    const auto found = fields.find(name);
    if (found == fields.end()) throw Error(ErrorCode::Format, where, say::bag_record_without_field(std::string(name)));
    return found->second;
  }
  template <class T>
  T number(std::string_view name) const {
    return ByteReader(field(name), where + ", field '" + std::string(name) + "'").number<T>();
  }
  std::uint8_t op() const { return number<std::uint8_t>("op"); }
};

bool is_rosbag1(std::string_view head) { return head.starts_with("#ROSBAG V") || head.starts_with("#ROSRECORD V"); }

/// `whole`: the data must lie within the source.
Rosbag1File::Record Rosbag1File::read_record(const ByteSource& source, std::uint64_t offset, bool whole) {
  Record record;
  record.where = source.place(offset);
  if (offset >= source.size()) throw Error(ErrorCode::Format, record.where, say::bag_record_behind_end());
  std::string head = source.read(offset, std::min(kRecordHeadBytes, source.size() - offset));
  const std::uint64_t header_bytes = ByteReader(head, record.where).number<std::uint32_t>();
  if (header_bytes > kMaxHeaderBytes)
    throw Error(ErrorCode::Format, record.where, say::bag_record_header_too_long(Bytes{header_bytes}, kMaxHeaderBytes));
  if (header_bytes + 8 > head.size()) head = source.read(offset, header_bytes + 8);
  ByteReader reader(head, record.where);
  record.fields = read_fields(reader.string(), record.where);
  record.data_bytes = reader.number<std::uint32_t>();
  record.data_offset = offset + reader.position();
  if (whole && record.data_bytes > source.size() - record.data_offset)
    throw Error(ErrorCode::Format, record.where,
                say::bag_record_promises(Bytes{record.data_bytes}, source.size() - record.data_offset));
  return record;
}

/// Where the next record begins: recorders that reserve room, and file systems after a crash, leave zeros between two.
/// The offset itself where none are there, and the end where nothing else follows.
std::uint64_t Rosbag1File::behind_zeros(const ByteSource& source, std::uint64_t offset) {
  constexpr std::uint64_t kBlockBytes = 65536, kLengthBytes = 4;
  // No header is empty.
  if (source.size() - std::min(offset, source.size()) < kLengthBytes) return offset;
  if (source.read(offset, kLengthBytes) != std::string(kLengthBytes, '\0')) return offset;
  std::uint64_t at = offset;
  while (at < source.size()) {
    const std::string block = source.read(at, std::min(kBlockBytes, source.size() - at));
    const std::size_t other = block.find_first_not_of('\0');
    at += std::min(other, block.size());
    if (other != std::string::npos) break;
  }
  // Zeros may be the first bytes of the length, as in 256.
  for (std::uint64_t back = 0; at < source.size() && back < kLengthBytes; ++back) try {
      if (read_record(source, at - back, false).fields.contains("op")) return at - back;
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Io) throw;
    }
  return at;
}

Rosbag1File::Rosbag1File(const std::filesystem::path& path, Progress& progress) : chunks_(path) {
  files_ = {path};
  const formats::RandomAccessFile& file = chunks_.file();
  const std::string head = file.read(0, std::min<std::uint64_t>(file.size(), rosbag1::kMagic.size()));
  if (head.size() < rosbag1::kMagic.size() && is_rosbag1(head))
    throw Error(ErrorCode::Format, path.string(), say::bag_nothing_readable(say::bag_not_closed()));
  if (head != rosbag1::kMagic)
    throw Error(ErrorCode::Unsupported, path.string(), is_rosbag1(head) ? say::bag_ros1_version() : say::bag_no_ros1());
  const auto whole = chunks_.source(kNoChunk);
  const Record header = read_record(*whole, rosbag1::kMagic.size());
  if (header.op() != rosbag1::kBagHeader) throw Error(ErrorCode::Format, header.where, say::bag_no_header());
  if (const auto encryptor = header.fields.find("encryptor");
      encryptor != header.fields.end() && !encryptor->second.empty())
    throw Error(ErrorCode::Unsupported, header.where, say::bag_encrypted());
  const auto index_offset = header.number<std::uint64_t>("index_pos");
  Message why = say::bag_not_closed();
  if (index_offset != 0) try {
      read_index(index_offset, header.number<std::uint32_t>("chunk_count"), progress);
      sort_topics();
      return;
    } catch (const Error& error) {
      if (error.code() != ErrorCode::Format) throw;
      why = say::bag_index_damaged(error.message());
      forget_topics();
      topic_of_connection_.clear();
      chunks_.clear();
    }
  scan(header.end(), why, progress);
  sort_topics();
}

void Rosbag1File::add_connection(const ByteSource& source, const Record& record) {
  const auto id = record.number<std::uint32_t>("conn");
  if (topic_of_connection_.contains(id)) return;
  const std::string data = source.read(record.data_offset, record.data_bytes);
  const Fields fields = read_fields(data, record.where);
  const auto type = fields.find("type");
  if (type == fields.end()) throw Error(ErrorCode::Format, record.where, say::bag_connection_without_type());
  const auto definition = fields.find("message_definition");
  topic_of_connection_[id] = topic(std::string(record.field("topic")), type->second, MessageEncoding::Ros1,
                                   definition == fields.end() ? std::string() : definition->second);
}

std::size_t Rosbag1File::topic_of(std::uint32_t connection, const std::string& where) const {
  const auto found = topic_of_connection_.find(connection);
  if (found == topic_of_connection_.end())
    throw Error(ErrorCode::Format, where, say::bag_connection_not_described(connection));
  return found->second;
}

BagChunk Rosbag1File::chunk_of(const Record& record, bool cut) const {
  BagChunk chunk;
  chunk.offset = record.data_offset;
  chunk.packed_bytes = cut ? chunks_.file().size() - record.data_offset : record.data_bytes;
  chunk.compression = chunk_compression(record.field("compression"), record.where);
  chunk.bytes = record.number<std::uint32_t>("size");
  chunk.cut = cut;
  return chunk;
}

void Rosbag1File::read_index(std::uint64_t index_offset, std::uint32_t chunk_count, Progress& progress) {
  const auto whole = chunks_.source(kNoChunk);
  std::vector<std::uint64_t> chunk_offsets;
  for (std::uint64_t offset = behind_zeros(*whole, index_offset); offset < whole->size();) {
    const Record record = read_record(*whole, offset);
    if (record.op() == rosbag1::kConnection) add_connection(*whole, record);
    if (record.op() == rosbag1::kChunkInfo) chunk_offsets.push_back(record.number<std::uint64_t>("chunk_pos"));
    offset = behind_zeros(*whole, record.end());
  }
  if (chunk_offsets.size() < chunk_count)
    throw Error(ErrorCode::Format, whole->place(index_offset),
                say::bag_index_names_some_chunks(chunk_offsets.size(), chunk_count));
  std::sort(chunk_offsets.begin(), chunk_offsets.end());
  if (std::adjacent_find(chunk_offsets.begin(), chunk_offsets.end()) != chunk_offsets.end())
    throw Error(ErrorCode::Format, whole->place(index_offset), say::bag_chunk_twice());
  for (std::size_t i = 0; i < chunk_offsets.size() && !progress.cancelled(); ++i) {
    if (i % 1000 == 0) progress.report(say::stage_reading_the_index, i, chunk_offsets.size());
    read_chunk_index(chunk_offsets[i]);
  }
}

/// The index records that follow a chunk, one for each connection.
void Rosbag1File::read_chunk_index(std::uint64_t chunk_offset) {
  const auto whole = chunks_.source(kNoChunk);
  const Record record = read_record(*whole, chunk_offset);
  if (record.op() != rosbag1::kChunk) throw Error(ErrorCode::Format, record.where, say::bag_no_chunk_there());
  const std::uint32_t chunk = chunks_.add(chunk_of(record, false));
  for (std::uint64_t offset = behind_zeros(*whole, record.end()); offset < whole->size();) {
    const Record index = read_record(*whole, offset);
    if (index.op() != rosbag1::kIndexData) return;
    if (index.number<std::uint32_t>("ver") != 1) throw Error(ErrorCode::Format, index.where, say::bag_index_version());
    const std::size_t topic = topic_of(index.number<std::uint32_t>("conn"), index.where);
    const std::string data = whole->read(index.data_offset, index.data_bytes);
    ByteReader reader(data, index.where);
    for (auto left = index.number<std::uint32_t>("count"); left > 0; --left) {
      BagEntry entry;
      entry.log_time_ns = read_time_ns(reader);
      entry.offset = reader.number<std::uint32_t>();
      entry.chunk = chunk;
      add_entry(topic, entry, whole->size(), index.where);
    }
    offset = behind_zeros(*whole, index.end());
  }
}

/// Messages and connections of a chunk as they stand in it. Throws Error where one is damaged; those before it stay.
void Rosbag1File::scan_chunk(const Record& record, bool cut) {
  const std::uint32_t chunk = chunks_.add(chunk_of(record, cut));
  chunks_.check(chunk);  // all of it is unpacked now
  const auto source = chunks_.source(chunk);
  for (std::uint64_t offset = 0; offset < source->size();) {
    const Record inner = read_record(*source, offset);
    if (inner.op() == rosbag1::kConnection) add_connection(*source, inner);
    if (inner.op() == rosbag1::kMessage) {
      BagEntry entry;
      ByteReader time(inner.field("time"), inner.where);
      entry.log_time_ns = read_time_ns(time);
      entry.offset = offset;
      entry.chunk = chunk;
      add_entry(topic_of(inner.number<std::uint32_t>("conn"), inner.where), entry, chunks_.file().size(), inner.where);
    }
    offset = inner.end();
  }
}

void Rosbag1File::scan(std::uint64_t offset, const Message& why, Progress& progress) {
  const auto whole = chunks_.source(kNoChunk);
  Message end = say::bag_readable_to_end();
  std::size_t damaged_chunks = 0;
  Message first_damage;
  while (offset < whole->size() && !progress.cancelled()) {
    progress.report(say::stage_reading_a_bag_without_an_index, offset >> 20, whole->size() >> 20);
    try {
      offset = behind_zeros(*whole, offset);
      if (offset == whole->size()) break;
      const Record record = read_record(*whole, offset, false);
      const bool cut = record.data_bytes > whole->size() - record.data_offset;
      offset = cut ? whole->size() : record.end();
      if (cut) end = say::bag_ends_within_record();
      if (record.op() == rosbag1::kChunk) try {
          scan_chunk(record, cut);
        } catch (const Error& error) {
          if (!cut && damaged_chunks++ == 0) first_damage = error.message();
        }
    } catch (const Error& error) {
      end = say::bag_last_bytes_not_readable(Bytes{whole->size() - offset}, error.message());
      break;
    }
  }
  if (entry_count() == 0)
    throw Error(ErrorCode::Format, files_[0].string(),
                Message::sequence({say::bag_nothing_readable(why), first_damage.empty() ? end : first_damage}));
  std::vector<Message> told{say::bag_chunks_without_index(why, entry_count(), chunks_.size()), end};
  if (damaged_chunks > 0) told.push_back(say::bag_chunks_damaged(damaged_chunks, first_damage));
  findings_.push_back(drive::make_finding(drive::Severity::Warning, "bag-unindexed", files_[0].string(),
                                          Message::sequence(std::move(told))));
}

std::string Rosbag1File::message(const BagEntry& entry, std::size_t at_most) const {
  const auto source = chunks_.source(entry.chunk);
  const Record record = read_record(*source, entry.offset);
  if (record.op() != rosbag1::kMessage) throw Error(ErrorCode::Format, record.where, say::bag_no_message_there());
  return source->read(record.data_offset, std::min<std::uint64_t>(record.data_bytes, at_most));
}

}  // namespace remount::bags
