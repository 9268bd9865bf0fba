#include "model/io/bag/rosbag1_file.h"

#include <algorithm>

#include "model/io/bag/byte_reader.h"
#include "model/io/bag/rosbag1_format.h"
#include "model/io/stream_tools.h"

namespace remount {
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
    if (equals == std::string_view::npos)
      throw Error(ErrorCode::Format, where, "a field of a record header has no '=', expected NAME=VALUE");
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
    if (found == fields.end())
      throw Error(ErrorCode::Format, where, "the record has no field '" + std::string(name) + "'");
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
  if (offset >= source.size()) throw Error(ErrorCode::Format, record.where, "a record is expected behind the end");
  std::string head = source.read(offset, std::min(kRecordHeadBytes, source.size() - offset));
  const std::uint64_t header_bytes = ByteReader(head, record.where).number<std::uint32_t>();
  if (header_bytes > kMaxHeaderBytes)
    throw Error(ErrorCode::Format, record.where,
                "a record header promises " + std::to_string(header_bytes) + " bytes, at most " +
                    std::to_string(kMaxHeaderBytes) + " are read");
  if (header_bytes + 8 > head.size()) head = source.read(offset, header_bytes + 8);
  ByteReader reader(head, record.where);
  record.fields = read_fields(reader.string(), record.where);
  record.data_bytes = reader.number<std::uint32_t>();
  record.data_offset = offset + reader.position();
  if (whole && record.data_bytes > source.size() - record.data_offset)
    throw Error(ErrorCode::Format, record.where,
                "a record promises " + std::to_string(record.data_bytes) + " bytes, " +
                    std::to_string(source.size() - record.data_offset) + " are there");
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
  const RandomAccessFile& file = chunks_.file();
  const std::string head = file.read(0, std::min<std::uint64_t>(file.size(), rosbag1::kMagic.size()));
  if (head.size() < rosbag1::kMagic.size() && is_rosbag1(head))
    throw Error(ErrorCode::Format, path.string(), "the bag holds no readable message (it was not closed).");
  if (head != rosbag1::kMagic)
    throw Error(ErrorCode::Unsupported, path.string(),
                is_rosbag1(head) ? "is a bag of an older version; 'rosbag fix' makes one of version 2.0"
                                 : "is no bag of ROS 1");
  const auto whole = chunks_.source(kNoChunk);
  const Record header = read_record(*whole, rosbag1::kMagic.size());
  if (header.op() != rosbag1::kBagHeader)
    throw Error(ErrorCode::Format, header.where, "expected the header of the bag");
  if (const auto encryptor = header.fields.find("encryptor");
      encryptor != header.fields.end() && !encryptor->second.empty())
    throw Error(ErrorCode::Unsupported, header.where, "the bag is encrypted");
  const auto index_offset = header.number<std::uint64_t>("index_pos");
  std::string why = "it was not closed";
  if (index_offset != 0) try {
      read_index(index_offset, header.number<std::uint32_t>("chunk_count"), progress);
      sort_topics();
      return;
    } catch (const Error& error) {
      if (error.code() != ErrorCode::Format) throw;
      why = std::string("its index is damaged: ") + error.what();
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
  if (type == fields.end()) throw Error(ErrorCode::Format, record.where, "a connection has no type");
  topic_of_connection_[id] = topic(std::string(record.field("topic")), type->second, MessageEncoding::Ros1);
}

std::size_t Rosbag1File::topic_of(std::uint32_t connection, const std::string& where) const {
  const auto found = topic_of_connection_.find(connection);
  if (found == topic_of_connection_.end())
    throw Error(ErrorCode::Format, where, "connection " + std::to_string(connection) + " is not described");
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
    throw Error(
        ErrorCode::Format, whole->place(index_offset),
        "the index names " + std::to_string(chunk_offsets.size()) + " of " + std::to_string(chunk_count) + " chunks");
  std::sort(chunk_offsets.begin(), chunk_offsets.end());
  if (std::adjacent_find(chunk_offsets.begin(), chunk_offsets.end()) != chunk_offsets.end())
    throw Error(ErrorCode::Format, whole->place(index_offset), "the index names a chunk twice");
  for (std::size_t i = 0; i < chunk_offsets.size() && !progress.cancelled(); ++i) {
    if (i % 1000 == 0) progress.report("reading the index", i, chunk_offsets.size());
    read_chunk_index(chunk_offsets[i]);
  }
}

/// The index records that follow a chunk, one for each connection.
void Rosbag1File::read_chunk_index(std::uint64_t chunk_offset) {
  const auto whole = chunks_.source(kNoChunk);
  const Record record = read_record(*whole, chunk_offset);
  if (record.op() != rosbag1::kChunk)
    throw Error(ErrorCode::Format, record.where, "the index says a chunk begins here");
  const std::uint32_t chunk = chunks_.add(chunk_of(record, false));
  for (std::uint64_t offset = behind_zeros(*whole, record.end()); offset < whole->size();) {
    const Record index = read_record(*whole, offset);
    if (index.op() != rosbag1::kIndexData) return;
    if (index.number<std::uint32_t>("ver") != 1)
      throw Error(ErrorCode::Format, index.where, "the index has another version than 1");
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

void Rosbag1File::scan(std::uint64_t offset, const std::string& why, Progress& progress) {
  const auto whole = chunks_.source(kNoChunk);
  std::string end = "It is readable to its end.";
  std::size_t damaged_chunks = 0;
  std::string first_damage;
  while (offset < whole->size() && !progress.cancelled()) {
    progress.report("reading a bag without an index, MB", offset >> 20, whole->size() >> 20);
    try {
      offset = behind_zeros(*whole, offset);
      if (offset == whole->size()) break;
      const Record record = read_record(*whole, offset, false);
      const bool cut = record.data_bytes > whole->size() - record.data_offset;
      offset = cut ? whole->size() : record.end();
      if (cut) end = "It ends in the middle of a record.";
      if (record.op() == rosbag1::kChunk) try {
          scan_chunk(record, cut);
        } catch (const Error& error) {
          if (!cut && damaged_chunks++ == 0) first_damage = error.what();
        }
    } catch (const Error& error) {
      end = "The last " + std::to_string(whole->size() - offset) + " bytes are not readable: " + error.what() + ".";
      break;
    }
  }
  if (entry_count() == 0)
    throw Error(ErrorCode::Format, files_[0].string(),
                "the bag holds no readable message (" + why + "). " + (first_damage.empty() ? end : first_damage));
  if (damaged_chunks > 0) end += " " + std::to_string(damaged_chunks) + " chunks are damaged. First: " + first_damage;
  findings_.push_back(make_finding(
      Severity::Warning, "bag-unindexed", files_[0].string(),
      "The bag has no usable index (" + why + "). It was read from the beginning: " + std::to_string(entry_count()) +
          " messages in " + std::to_string(chunks_.size()) + " chunks were found. " + end));
}

std::string Rosbag1File::message(const BagEntry& entry, std::size_t at_most) const {
  const auto source = chunks_.source(entry.chunk);
  const Record record = read_record(*source, entry.offset);
  if (record.op() != rosbag1::kMessage)
    throw Error(ErrorCode::Format, record.where, "the index says a message begins here");
  return source->read(record.data_offset, std::min<std::uint64_t>(record.data_bytes, at_most));
}

}  // namespace remount
