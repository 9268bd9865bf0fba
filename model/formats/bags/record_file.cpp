#include "model/formats/bags/record_file.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "algorithms/core/error.h"
#include "messages/records.h"
#include "messages/stages.h"
#include "model/drive/bad_items.h"
#include "model/formats/bags/proto_reader.h"
#include "model/formats/bags/record_format.h"
#include "model/formats/bags/split_bag.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/number_bytes.h"
#include "model/formats/sessions/several_sessions.h"

namespace remount::bags {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kSectionsBegin = cyber::kSectionHead + cyber::kHeaderRoom;
/// Of a channel's name and type; what describes the type stands behind them and may be long.
constexpr std::uint64_t kHeadOfChannel = std::uint64_t{8} << 10;
/// Of a message: its channel and time. Names are shorter.
constexpr std::uint64_t kHeadOfMessage = 1024;
/// With what the types begin that are Apollo's: others are never read.
constexpr std::string_view kKnownTypes = "apollo.";

struct SectionHead {
  std::uint32_t kind = 0;
  std::uint64_t bytes = 0;
};
SectionHead section_head(std::string_view head) {
  return {formats::little_number<std::uint32_t>(head, 0), formats::little_number<std::uint64_t>(head, 8)};
}

/// The header of a record, as far as it is used.
struct RecordHeader {
  std::uint64_t compress = cyber::kUncompressed, messages = 0;
  bool complete = false;
};

/// Nothing where these bytes are none: fields of numbers that a header does not have.
std::optional<RecordHeader> parse_record_header(std::string_view bytes) try {
  RecordHeader header;
  bool versioned = false;
  for (ProtoReader reader(bytes, {}); reader.next();) {
    if (reader.field() > cyber::kLastHeaderField) return std::nullopt;
    const std::optional<std::uint64_t> value = reader.whole();
    versioned = versioned || (reader.field() == cyber::kMajorVersion && value);
    if (reader.field() == cyber::kCompress) header.compress = value.value_or(cyber::kUncompressed);
    if (reader.field() == cyber::kMessageNumber) header.messages = value.value_or(0);
    if (reader.field() == cyber::kIsComplete) header.complete = value.value_or(0) != 0;
  }
  return versioned ? std::optional(header) : std::nullopt;
} catch (const Error&) {
  return std::nullopt;
}

/// The header that a file begins with; nothing where it is no record.
std::optional<RecordHeader> record_header(std::string_view head) {
  if (head.size() < cyber::kSectionHead) return std::nullopt;
  const SectionHead section = section_head(head);
  if (section.kind != cyber::kHeader || section.bytes == 0 ||
      section.bytes > std::min(cyber::kHeaderRoom, head.size() - cyber::kSectionHead))
    return std::nullopt;
  return parse_record_header(head.substr(cyber::kSectionHead, section.bytes));
}

/// By its header, and by the section behind it where there is one.
bool is_record(const fs::path& path) {
  try {
    const std::string head = formats::read_file_head(path, kSectionsBegin + cyber::kSectionHead);
    if (!record_header(head)) return false;
    if (head.size() < kSectionsBegin + cyber::kSectionHead) return true;
    const std::uint32_t kind = section_head(std::string_view(head).substr(kSectionsBegin)).kind;
    return kind >= cyber::kChunkHeader && kind <= cyber::kChannel;
  } catch (const Error&) {
    return false;  // not readable: not recognised
  }
}

/// Files of a folder that are records, by the recording that they are a part of.
struct RecordPart {
  std::string recording;
  std::optional<std::uint64_t> number;  ///< of a part; nothing where the name has none
  fs::path path;
};

/// "drive.record.00012" is the part 12 of "drive.record".
RecordPart part_of(const fs::path& path) {
  constexpr std::size_t kMostDigits = 9;
  const std::string name = path.filename().string();
  const std::size_t dot = name.rfind('.');
  const std::string digits = dot == std::string::npos ? std::string() : name.substr(dot + 1);
  const bool numbered = !digits.empty() && digits.size() <= kMostDigits &&
                        std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
  if (!numbered) return {name, std::nullopt, path};
  return {name.substr(0, dot), std::stoull(digits), path};
}

bool has_part_of(const std::string& recording, const std::vector<RecordPart>& parts) {
  return std::ranges::any_of(parts, [&](const RecordPart& part) { return part.number && part.recording == recording; });
}

/// By names first: a folder may have a hundred thousand scans, which nobody wants to be opened for this.
/// A part that is no record, of a recording that has others, is one that is damaged: opening it says how.
std::vector<RecordPart> parts_in(const fs::path& folder) {
  std::vector<RecordPart> parts, others;
  for (const fs::path& file : formats::files_in(folder))
    if (file.filename().string().find(".record") != std::string::npos)
      (is_record(file) ? parts : others).push_back(part_of(file));
  for (RecordPart& other : others)
    if (other.number && has_part_of(other.recording, parts)) parts.push_back(std::move(other));
  std::ranges::stable_sort(parts, [](const RecordPart& a, const RecordPart& b) {
    return std::tie(a.recording, a.number, a.path) < std::tie(b.recording, b.number, b.path);
  });
  return parts;
}

bool are_of_one(const std::vector<RecordPart>& parts) {
  return std::ranges::adjacent_find(parts, [](const RecordPart& a, const RecordPart& b) {
           return a.recording != b.recording || !a.number || !b.number || a.number == b.number;
         }) == parts.end();
}

/// Numbers that none of the parts has, between the first and the last.
std::size_t missing_between(const std::vector<RecordPart>& parts) {
  if (parts.size() < 2) return 0;
  return static_cast<std::size_t>(*parts.back().number - *parts.front().number) + 1 - parts.size();
}

std::shared_ptr<const BagFile> open_parts_of_record(const fs::path& folder, const std::vector<RecordPart>& parts,
                                                    Progress& progress) {
  std::vector<std::shared_ptr<const BagFile>> files;
  std::vector<drive::Finding> findings;
  std::optional<Error> first;
  for (const RecordPart& part : parts) try {
      files.push_back(std::make_shared<RecordFile>(part.path, progress));
    } catch (const Error& error) {
      if (!first) first = error;
      findings.push_back(drive::make_finding(drive::Severity::Warning, "record-part-unreadable", part.path.string(),
                                             error.what_happened()));
    }
  if (files.empty()) throw *first;
  if (const std::size_t missing = missing_between(parts); missing > 0)
    findings.push_back(drive::make_finding(drive::Severity::Warning, "record-part-missing", folder.string(),
                                           say::record_parts_missing(parts.front().recording, missing)));
  const auto bag = std::make_shared<SplitBag>(std::move(files));
  for (drive::Finding& finding : findings) bag->add_finding(std::move(finding));
  return bag;
}

}  // namespace

/// Reads the file in pieces: most messages are small.
class RecordFile::Window {
 public:
  explicit Window(const formats::RandomAccessFile& file) : file_(file) {}
  const formats::RandomAccessFile& file() const { return file_; }
  /// Bytes from `offset` up to `end`, no more than `at_most`; valid until the next call.
  std::string_view at(std::uint64_t offset, std::uint64_t end, std::uint64_t at_most) {
    constexpr std::uint64_t kPiece = 4096;
    const std::uint64_t count = std::min(at_most, end - offset);
    if (offset < begin_ || offset + count > begin_ + bytes_.size()) {
      bytes_ = file_.read(offset, std::min(std::max(count, kPiece), file_.size() - offset));
      begin_ = offset;
    }
    return std::string_view(bytes_).substr(offset - begin_, count);
  }

 private:
  const formats::RandomAccessFile& file_;
  std::uint64_t begin_ = 0;
  std::string bytes_;
};

int probe_record(const fs::path& path) try {
  constexpr int kSure = 95, kSeveral = 25;
  if (formats::is_file(path)) return is_record(path) ? kSure : 0;
  if (!formats::is_folder(path)) return 0;
  const std::vector<RecordPart> parts = parts_in(path);
  return parts.empty() ? 0 : are_of_one(parts) ? kSure : kSeveral;
} catch (const Error&) {
  return 0;
}

std::shared_ptr<const BagFile> open_record(const fs::path& path, Progress& progress) {
  if (!formats::is_folder(path)) return std::make_shared<RecordFile>(path, progress);
  const std::vector<RecordPart> parts = parts_in(path);
  if (parts.empty()) throw Error(ErrorCode::Format, path.string(), say::record_folder_without());
  if (parts.size() == 1) return std::make_shared<RecordFile>(parts.front().path, progress);
  if (are_of_one(parts)) return open_parts_of_record(path, parts, progress);
  std::vector<fs::path> files;
  for (const RecordPart& part : parts) files.push_back(part.path);
  throw formats::SeveralSessions(path, say::record_folder_of_several(formats::lines_of(files)), files);
}

RecordFile::RecordFile(const fs::path& path, Progress& progress) : file_(path) {
  files_ = {path};
  read_header();
  read_sections(progress);
  for (const Span& body : chunks_)
    if (!progress.cancelled()) index_chunk(body, progress);
  chunks_ = {};
  if (!progress.cancelled()) report();
  sort_topics();
}

void RecordFile::read_header() {
  const std::optional<RecordHeader> header =
      record_header(file_.read(0, std::min<std::uint64_t>(file_.size(), kSectionsBegin)));
  if (!header) throw Error(ErrorCode::Format, files_[0].string(), say::record_no_header());
  if (header->compress != cyber::kUncompressed)
    throw Error(ErrorCode::Unsupported, files_[0].string(),
                say::record_compressed(header->compress == cyber::kBzip2 ? "BZ2"
                                       : header->compress == cyber::kLz4 ? "LZ4"
                                                                         : std::to_string(header->compress)));
  promised_ = header->messages;
  closed_ = header->complete;
}

/// A section that reaches beyond the end is the last; of a chunk what is there is used.
void RecordFile::read_sections(Progress& progress) {
  cut_at_ = file_.size();
  for (std::uint64_t offset = kSectionsBegin; offset < file_.size() && !progress.cancelled();) {
    progress.report(say::stage_reading_the_index, offset >> 20, file_.size() >> 20);
    const std::uint64_t begin = offset + cyber::kSectionHead;
    if (begin > file_.size()) {
      cut_at_ = offset;
      return;
    }
    const SectionHead head = section_head(file_.read(offset, cyber::kSectionHead));
    const bool known = head.kind >= cyber::kChunkHeader && head.kind <= cyber::kChannel;
    const bool cut = !known || head.bytes > file_.size() - begin;
    const Span section{begin, cut ? file_.size() : begin + head.bytes};
    if (known && head.kind == cyber::kChunkBody) chunks_.push_back(section);
    if (known && head.kind == cyber::kChannel) read_channel(section);
    if (cut) {
      cut_at_ = offset;
      return;
    }
    offset = section.end;
  }
}

void RecordFile::read_channel(const Span& section) {
  const std::string bytes = file_.read(section.begin, std::min(kHeadOfChannel, section.end - section.begin));
  const std::string where = file_.place(section.begin);
  std::string_view name, type;
  try {
    for (ProtoReader reader(bytes, where, ProtoReader::End::Cut); reader.next();) {
      if (reader.field() == cyber::kChannelName) name = reader.bytes().value_or(std::string_view());
      if (reader.field() == cyber::kMessageType) type = reader.bytes().value_or(std::string_view());
    }
  } catch (const Error&) {
    return;  // its messages are of no type that is known
  }
  if (!name.empty()) types_.try_emplace(std::string(name), type);
}

std::size_t RecordFile::topic_of(const std::string& channel) {
  const auto known = topic_of_channel_.find(channel);
  if (known != topic_of_channel_.end()) return known->second;
  constexpr std::size_t kMostChannels = 4096;  // no vehicle has more, and each is looked for among the others
  if (topic_of_channel_.size() == kMostChannels)
    throw Error(ErrorCode::Format, files_[0].string(), say::record_too_many_channels(kMostChannels));
  const auto type = types_.find(channel);
  const std::string name = type == types_.end() ? std::string() : type->second;
  const bool is_known = name.starts_with(kKnownTypes);
  const std::size_t made = topic(channel, name, is_known ? MessageEncoding::Protobuf : MessageEncoding::Other);
  return topic_of_channel_[channel] = made;
}

/// Of the message whose field begins at `offset`. Throws Error(Format) where it is none, or does not end before `end`.
RecordFile::Head RecordFile::read_head(Window& window, std::uint64_t offset, std::uint64_t end) {
  const std::string where = window.file().place(offset);
  const std::string_view bytes = window.at(offset, end, kHeadOfMessage);
  ProtoReader frame(bytes, where, ProtoReader::End::Cut);
  if (!frame.next() || frame.field() != cyber::kChunkMessage || !frame.bytes() ||
      frame.length() > end - offset - frame.begins())
    throw Error(ErrorCode::Format, where, say::record_no_message());
  Head head;
  const std::uint64_t message = offset + frame.begins();
  head.content = {message + frame.length(), message + frame.length()};
  for (ProtoReader reader(*frame.bytes(), where, ProtoReader::End::Cut); reader.next();) {
    if (reader.field() == cyber::kMessageChannel) head.channel = reader.bytes().value_or(std::string_view());
    if (reader.field() == cyber::kMessageTime) head.time_ns = static_cast<std::int64_t>(reader.whole().value_or(0));
    if (reader.field() != cyber::kMessageContent || !reader.bytes()) continue;
    const std::uint64_t begin = message + reader.begins();
    if (reader.length() > head.content.end - begin) throw Error(ErrorCode::Format, where, say::record_no_message());
    head.content = {begin, begin + reader.length()};
    break;  // what stands behind the content, nobody reads
  }
  if (head.channel.empty() || head.channel.size() >= kHeadOfMessage / 2)
    throw Error(ErrorCode::Format, where, say::record_no_channel());
  return head;
}

void RecordFile::index_chunk(const Span& body, Progress& progress) {
  Window window(file_);
  for (std::uint64_t offset = body.begin; offset < body.end;) {
    if (entry_count() % 1024 == 0) progress.report(say::stage_reading_the_index, offset >> 20, file_.size() >> 20);
    if (progress.cancelled()) return;
    std::uint64_t next = body.end;
    bool next_known = false;
    try {
      // Where the next begins is known even where this one cannot be read.
      ProtoReader frame(window.at(offset, body.end, kHeadOfMessage), {}, ProtoReader::End::Cut);
      if (frame.next() && frame.bytes() && frame.length() <= body.end - offset - frame.begins())
        next = offset + frame.begins() + frame.length(), next_known = true;
      const Head head = read_head(window, offset, body.end);
      BagEntry entry;
      entry.log_time_ns = head.time_ns;
      entry.offset = offset;
      add_entry(topic_of(head.channel), entry, file_.size(), file_.place(offset));
    } catch (const Error& error) {
      if (error.code() != ErrorCode::Format) throw;
      const bool last = body.end == file_.size() && next == body.end;
      if (last && cut_at_ != file_.size()) {
        cut_at_ = offset;
        return;
      }
      if (damaged_++ == 0) first_damage_ = error.message();
      rests_lost_ += next_known ? 0 : 1;
    }
    offset = next;
  }
  // Of a chunk that was cut behind a message nothing is left out.
  if (body.end == file_.size()) cut_at_ = body.end;
}

void RecordFile::report() {
  const std::uint64_t left_out = file_.size() - cut_at_;
  if (entry_count() == 0)
    throw Error(ErrorCode::Format, files_[0].string(),
                damaged_ > 0 ? say::record_nothing_readable(first_damage_) : say::record_without_messages());
  const auto tell = [&](Message what) {
    findings_.push_back(
        drive::make_finding(drive::Severity::Warning, "record-cut", files_[0].string(), std::move(what)));
  };
  if (left_out > 0)
    tell(say::record_cut(Bytes{left_out}, entry_count()));
  else if (!closed_)
    tell(say::record_not_closed(entry_count()));
  else if (entry_count() + damaged_ < promised_)
    tell(say::record_promises(promised_, entry_count()));
  if (damaged_ == 0) return;
  const Message damaged = say::record_messages_damaged(damaged_, first_damage_);
  findings_.push_back(drive::make_finding(
      drive::Severity::Warning, "record-damaged", files_[0].string(),
      rests_lost_ > 0 ? Message::sequence({damaged, say::record_rests_lost(rests_lost_)}) : damaged));
}

RecordFile::Span RecordFile::content_of(const BagEntry& entry) const {
  Window window(file_);
  return read_head(window, entry.offset, file_.size()).content;
}

std::string RecordFile::message(const BagEntry& entry, std::size_t at_most) const {
  const Span content = content_of(entry);
  return file_.read(content.begin, std::min<std::uint64_t>(content.end - content.begin, at_most));
}

std::string RecordFile::message_end(const BagEntry& entry, std::size_t at_most) const {
  const Span content = content_of(entry);
  const std::uint64_t count = std::min<std::uint64_t>(content.end - content.begin, at_most);
  return file_.read(content.end - count, count);
}

}  // namespace remount::bags
