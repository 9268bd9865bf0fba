#include "model/formats/bags/mcap_file.h"

#include <algorithm>

#include "messages/bags.h"
#include "messages/stages.h"
#include "model/drive/bad_items.h"
#include "model/formats/bags/byte_reader.h"
#include "model/formats/bags/mcap_format.h"
#include "model/formats/bags/packed_message.h"

namespace remount::bags {
namespace {

using namespace mcap;

constexpr std::uint64_t kFooterBytes = kRecordHead + 20;
constexpr std::uint64_t kMessageHead = 22;  // channel, sequence, two times
constexpr std::uint64_t kMaxDescription = std::uint64_t{16} << 20;
constexpr std::uint64_t kChecksumBytes = 4;

// Reading a bag whole for the sake of its checksums must not take longer than what one waits for anyway: beyond the
// size of a small one, chunks are checked with the first large message that is read of them.
constexpr std::uint64_t kLargeMessage = std::uint64_t{64} << 10;

MessageEncoding encoding_of(std::string_view name) {
  if (name == "ros1") return MessageEncoding::Ros1;
  return name == "cdr" ? MessageEncoding::Cdr : MessageEncoding::Other;
}

}  // namespace

struct McapFile::Record {
  std::uint8_t op = 0;
  std::string where;
  std::uint64_t offset = 0;  ///< of its content
  std::uint64_t bytes = 0;
  std::uint64_t end() const { return offset + bytes; }

  /// Of records that are small by what they mean.
  std::string content(const ByteSource& source) const {
    if (bytes > kMaxDescription)
      throw Error(ErrorCode::Format, where, say::bag_record_too_long(Bytes{bytes}, kMaxDescription));
    return source.read(offset, bytes);
  }
};

bool is_mcap(std::string_view head) { return head.starts_with(kMagic.substr(0, 5)); }

/// `whole`: the content must lie within the source.
McapFile::Record McapFile::read_record(const ByteSource& source, std::uint64_t offset, bool whole) {
  Record record;
  record.where = source.place(offset);
  const std::string head = source.read(offset, kRecordHead);
  ByteReader reader(head, record.where);
  record.op = reader.number<std::uint8_t>();
  record.bytes = reader.number<std::uint64_t>();
  record.offset = offset + kRecordHead;
  if (record.op == 0) throw Error(ErrorCode::Format, record.where, say::bag_record_of_zero());
  if (whole && record.bytes > source.size() - record.offset)
    throw Error(ErrorCode::Format, record.where,
                say::bag_record_promises(Bytes{record.bytes}, source.size() - record.offset));
  return record;
}

McapFile::McapFile(const BagInput& input, Progress& progress) : input_(input), chunks_(input.path(), input.given) {
  files_ = {input.given};
  const formats::RandomAccessFile& file = chunks_.file();
  const std::string head = file.read(0, std::min<std::uint64_t>(file.size(), kMagic.size()));
  if (head != kMagic)
    throw Error(ErrorCode::Unsupported, input.given.string(),
                is_mcap(head) ? say::bag_mcap_version() : say::bag_no_mcap());
  Message why;
  try {
    if (read_summary(progress)) {
      check_other_sums(progress);
      sort_topics();
      return;
    }
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Format) throw;
    why = error.message();
  }
  forget_all();
  scan(why, progress);
  check_other_sums(progress);
  sort_topics();
}

void McapFile::forget_all() {
  forget_topics();
  schemas_.clear();
  topic_of_channel_.clear();
  chunk_starts_.clear();
  undescribed_ = false;
  chunks_.clear();
}

void McapFile::add_schema(std::string_view content, const std::string& where) {
  ByteReader reader(content, where);
  const auto id = reader.number<std::uint16_t>();
  // Writers repeat them in every chunk, with the same content.
  if (id == 0 || schemas_.contains(id)) return;
  Schema schema;
  schema.type = reader.string();
  try {
    const std::string_view language = reader.string();
    if (language == "ros1msg" || language == "ros2msg")
      schema.definition = kept_definition(schema.type, reader.string());
  } catch (const Error&) {
    // Its type is enough for most messages.
  }
  schemas_.emplace(id, std::move(schema));
}

void McapFile::add_channel(std::string_view content, const std::string& where) {
  ByteReader reader(content, where);
  const auto id = reader.number<std::uint16_t>(), schema = reader.number<std::uint16_t>();
  const std::string name(reader.string());
  const MessageEncoding encoding = encoding_of(reader.string());
  has_cdr_ |= encoding == MessageEncoding::Cdr;
  const auto described = schemas_.find(schema);
  static const Schema kUnknownSchema;
  const Schema& type = described == schemas_.end() ? kUnknownSchema : described->second;
  topic_of_channel_[id] = topic(name, type.type, encoding, type.definition);
}

std::size_t McapFile::topic_of(std::uint16_t channel, const std::string& where) const {
  const auto found = topic_of_channel_.find(channel);
  if (found == topic_of_channel_.end()) throw Error(ErrorCode::Format, where, say::bag_channel_not_described(channel));
  return found->second;
}

BagChunk McapFile::chunk_at(std::uint64_t offset) const {
  const auto whole = chunks_.source(kNoChunk);
  const Record record = read_record(*whole, offset, false);
  if (record.op != kChunk) throw Error(ErrorCode::Format, record.where, say::bag_no_chunk_there());
  constexpr std::uint64_t kHeadBytes = 128;  // times, sizes and the name of the compression
  const std::string head = whole->read(record.offset, std::min(kHeadBytes, whole->size() - record.offset));
  ByteReader reader(head, record.where);
  reader.bytes(16);
  BagChunk chunk;
  chunk.bytes = reader.number<std::uint64_t>();
  chunk.checksum = reader.number<std::uint32_t>();
  chunk.compression = chunk_compression(reader.string(), record.where);
  chunk.packed_bytes = reader.number<std::uint64_t>();
  chunk.offset = record.offset + reader.position();
  if (chunk.packed_bytes > whole->size() - chunk.offset) {
    chunk.cut = true;
    chunk.packed_bytes = whole->size() - chunk.offset;
  } else if (record.bytes > whole->size() - record.offset || chunk.offset + chunk.packed_bytes > record.end()) {
    throw Error(ErrorCode::Format, record.where, say::bag_chunk_beyond_record());
  }
  return chunk;
}

/// False where there is no summary, or one that does not lead to every message.
bool McapFile::read_summary(Progress& progress) {
  const auto whole = chunks_.source(kNoChunk);
  const std::uint64_t tail = kFooterBytes + kMagic.size();
  if (whole->size() < kMagic.size() + tail || whole->read(whole->size() - kMagic.size(), kMagic.size()) != kMagic)
    throw Error(ErrorCode::Format, whole->place(whole->size()), say::bag_file_not_closed());
  const Record footer = read_record(*whole, whole->size() - tail);
  if (footer.op != kFooter) throw Error(ErrorCode::Format, footer.where, say::bag_no_footer());
  const std::string content = footer.content(*whole);
  const auto start = ByteReader(content, footer.where).number<std::uint64_t>();
  if (start == 0) return false;
  check_summary(start, content, footer);
  summary_whole_ = true;
  std::uint64_t promised = 0;
  bool indexed = false;
  for (std::uint64_t offset = start; offset < whole->size() - tail && !progress.cancelled();) {
    const Record record = read_record(*whole, offset);
    if (record.op == kSchema) add_schema(record.content(*whole), record.where);
    if (record.op == kChannel) add_channel(record.content(*whole), record.where);
    if (record.op == kStatistics) promised = ByteReader(record.content(*whole), record.where).number<std::uint64_t>();
    if (record.op == kChunkIndex) {
      indexed = true;
      read_chunk_index(record.content(*whole), record.where);
    }
    offset = record.end();
  }
  return indexed && !undescribed_ && entry_count() >= promised;
}

/// The checksum reaches from the summary's first byte to itself, the last field of the footer.
void McapFile::check_summary(std::uint64_t start, const std::string& footer_content, const Record& footer) const {
  const std::uint64_t end = footer.end() - kChecksumBytes;
  const auto checksum =
      ByteReader(footer_content.substr(footer_content.size() - kChecksumBytes), footer.where).number<std::uint32_t>();
  if (checksum == 0) return;
  if (start > end || file_checksum(chunks_.file(), start, end - start) != checksum)
    throw Error(ErrorCode::Format, footer.where, say::bag_summary_checksum());
}

/// Of what is not in chunks, which have their own.
void McapFile::check_other_sums(Progress& progress) {
  const auto whole = chunks_.source(kNoChunk);
  if (whole->size() > kSmallBag) return;
  std::size_t attachments = 0;
  std::string first;
  try {
    for (std::uint64_t offset = kMagic.size(); offset < whole->size() && !progress.cancelled();) {
      const Record record = read_record(*whole, offset);
      if (record.op == kFooter) break;
      if (record.op == kAttachment || record.op == kDataEnd) {
        // Of an attachment the checksum is its last field; that of the data is of everything before its record.
        if (record.bytes < kChecksumBytes) throw Error(ErrorCode::Format, record.where, say::bag_record_too_short());
        const bool data = record.op == kDataEnd;
        const std::uint64_t from = data ? 0 : record.offset, at = record.end() - kChecksumBytes;
        const auto sum = ByteReader(whole->read(at, kChecksumBytes), record.where).number<std::uint32_t>();
        const bool right = sum == 0 || file_checksum(chunks_.file(), from, (data ? offset : at) - from) == sum;
        if (!right && data)
          findings_.push_back(drive::make_finding(drive::Severity::Warning, "bag-damaged", files_[0].string(),
                                                  say::bag_data_checksum()));
        if (!right && !data && attachments++ == 0) first = record.where;
      }
      offset = record.end();
    }
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Format) throw;  // that records are damaged is told where they are read
  }
  if (attachments > 0)
    findings_.push_back(drive::make_finding(drive::Severity::Warning, "bag-damaged", files_[0].string(),
                                            say::bag_attachment_checksums(attachments, first)));
}

void McapFile::read_chunk_index(std::string_view content, const std::string& where) {
  ByteReader reader(content, where);
  reader.bytes(16);
  const auto start = reader.number<std::uint64_t>(), length = reader.number<std::uint64_t>();
  const std::size_t indexes = reader.string().size() / 10;
  const auto index_bytes = reader.number<std::uint64_t>();
  if (!chunk_starts_.insert(start).second) throw Error(ErrorCode::Format, where, say::bag_chunk_twice());
  const BagChunk described = chunk_at(start);
  if (described.cut) throw Error(ErrorCode::Format, where, say::bag_chunk_behind_end());
  const std::uint32_t chunk = chunks_.add(described);
  if (indexes == 0) {
    scan_chunk(chunk);
    return;
  }
  const auto whole = chunks_.source(kNoChunk);
  const std::uint64_t from = start + length;
  if (from < start || from > whole->size() || index_bytes > whole->size() - from)
    throw Error(ErrorCode::Format, where, say::bag_indexes_behind_end());
  for (std::uint64_t offset = from; offset < from + index_bytes;) {
    const Record record = read_record(*whole, offset);
    if (record.op == kMessageIndex) read_message_index(whole->read(record.offset, record.bytes), chunk, record.where);
    offset = record.end();
  }
}

void McapFile::read_message_index(std::string_view content, std::uint32_t chunk, const std::string& where) {
  ByteReader reader(content, where);
  const auto channel = reader.number<std::uint16_t>();
  // Writers need not repeat in the summary what stands in the chunks.
  if (!topic_of_channel_.contains(channel)) {
    undescribed_ = true;
    return;
  }
  const std::size_t topic = topic_of(channel, where);
  ByteReader items(reader.string(), where);
  while (items.left() > 0) {
    BagEntry entry;
    entry.log_time_ns = items.number<std::int64_t>();
    entry.offset = items.number<std::uint64_t>();
    entry.chunk = chunk;
    add_entry(topic, entry, chunks_.file().size(), where);
  }
}

void McapFile::scan_record(const ByteSource& source, const Record& record, std::uint32_t chunk) {
  if (record.op == kSchema) add_schema(record.content(source), record.where);
  if (record.op == kChannel) add_channel(record.content(source), record.where);
  if (record.op != kMessage) return;
  const std::string head = source.read(record.offset, kMessageHead);
  ByteReader reader(head, record.where);
  const auto channel = reader.number<std::uint16_t>();
  reader.number<std::uint32_t>();
  BagEntry entry;
  entry.log_time_ns = reader.number<std::int64_t>();
  entry.offset = record.offset - kRecordHead;
  entry.chunk = chunk;
  add_entry(topic_of(channel, record.where), entry, chunks_.file().size(), record.where);
}

void McapFile::scan_chunk(std::uint32_t chunk) {
  // All of it is unpacked now, but the points of one that is not compressed are passed over.
  if (chunks_.file().size() <= kSmallBag || chunks_.is_compressed(chunk)) chunks_.check(chunk);
  const auto source = chunks_.source(chunk);
  for (std::uint64_t offset = 0; offset < source->size();) {
    const Record record = read_record(*source, offset);
    scan_record(*source, record, chunk);
    offset = record.end();
  }
}

void McapFile::scan(const Message& why_no_summary, Progress& progress) {
  const Message why = why_no_summary.empty() ? say::bag_without_summary() : why_no_summary;
  const auto whole = chunks_.source(kNoChunk);
  bool complete = false;
  std::size_t damaged = 0;
  Message first_damage;
  std::uint64_t offset = kMagic.size();
  std::optional<Record> cut_record;
  while (offset < whole->size() && !complete && !progress.cancelled()) {
    progress.report(say::stage_reading_a_bag_without_an_index, offset >> 20, whole->size() >> 20);
    const std::uint64_t at = offset;
    try {
      const Record record = read_record(*whole, at, false);
      const bool cut = record.bytes > whole->size() - record.offset;
      if (cut) cut_record = record;
      offset = cut ? whole->size() : record.end();
      complete = record.op == kDataEnd || record.op == kFooter;
      if (record.op == kChunk)
        scan_chunk(chunks_.add(chunk_at(at)));
      else if (!cut)
        scan_record(*whole, record, kNoChunk);
    } catch (const Error& error) {
      if (damaged++ == 0) first_damage = say::bag_first_not_readable(error.message());
      if (offset == at) break;  // where the next record begins is not known
    }
  }
  if (complete && damaged == 0 && (why_no_summary.empty() || !summary_whole_)) {
    // That there is no index is nobody's fault; that what the footer promises is not there is somebody's.
    if (!why_no_summary.empty())
      findings_.push_back(drive::make_finding(drive::Severity::Warning, "bag-cut-end", files_[0].string(),
                                              say::bag_cut_behind_data(why, entry_count())));
    return;
  }
  const Message lost = cut_record
                           ? say::bag_last_record_cut(whole->size() - cut_record->offset, Bytes{cut_record->bytes})
                           : say::bag_end_not_readable(Bytes{complete ? 0 : whole->size() - offset});
  if (entry_count() == 0)
    throw Error(ErrorCode::Format, files_[0].string(),
                Message::sequence({say::bag_nothing_readable(why), first_damage}));
  findings_.push_back(
      drive::make_finding(drive::Severity::Warning, "bag-unindexed", files_[0].string(),
                          Message::sequence({say::bag_without_index(why, entry_count(), lost), first_damage})));
}

std::string McapFile::message(const BagEntry& entry, std::size_t at_most) const {
  const auto source = chunks_.source(entry.chunk);
  const Record record = read_record(*source, entry.offset);
  if (record.op != kMessage || record.bytes < kMessageHead)
    throw Error(ErrorCode::Format, record.where, say::bag_no_message_there());
  const std::uint64_t bytes = record.bytes - kMessageHead;
  const bool large = std::min<std::uint64_t>(bytes, at_most) >= kLargeMessage;
  if (large || chunks_.file().size() <= kSmallBag) chunks_.check(entry.chunk, *source);
  const auto read = [&](std::uint64_t count) { return source->read(record.offset + kMessageHead, count); };
  if (!has_cdr_) return read(std::min<std::uint64_t>(bytes, at_most));
  return message_content({bytes, read, chunks_.file().size(), record.where}, at_most);
}

}  // namespace remount::bags
