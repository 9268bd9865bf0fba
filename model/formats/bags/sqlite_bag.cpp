#include "model/formats/bags/sqlite_bag.h"

#include <sqlite3.h>

#include <algorithm>
#include <cstdio>

#include "algorithms/core/error.h"
#include "messages/bags.h"
#include "messages/stages.h"
#include "model/drive/bad_items.h"
#include "model/formats/bags/packed_message.h"
#include "model/formats/files/random_access_file.h"
#include "model/formats/files/system_words.h"

namespace remount::bags {
namespace {

constexpr std::uint64_t kLongestValue = std::uint64_t{1} << 30;
constexpr std::uint64_t kPageBytes = 65536;  // the largest that there is

using Statement = std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)>;

Statement prepare(sqlite3* database, const char* sql) {
  sqlite3_stmt* statement = nullptr;
  sqlite3_prepare_v2(database, sql, -1, &statement, nullptr);
  return {statement, sqlite3_finalize};
}

std::string text_of(sqlite3_stmt* row, int column) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(row, column));
  return text ? std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(row, column))) : std::string();
}

/// A path as the URI that sqlite3_open_v2 wants.
std::string uri_of(const std::filesystem::path& path, const char* options) {
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(path).string()) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '/' ||
                       c == '-' || c == '_' || c == '.';
    char escaped[8];
    std::snprintf(escaped, sizeof escaped, "%%%02X", byte);
    uri += plain ? std::string(1, c) : std::string(escaped);
  }
  return uri + options;
}

/// True where the file has fewer pages than its header counts (SQLite's format: page size at byte 16, count at 28).
bool is_cut(const formats::RandomAccessFile& file) {
  if (file.size() < 100) return true;
  const std::string head = file.read(0, 100);
  const auto big_endian = [&](std::size_t at, std::size_t count) {
    std::uint64_t value = 0;
    for (std::size_t i = at; i < at + count; ++i) value = value << 8 | static_cast<unsigned char>(head[i]);
    return value;
  };
  const std::uint64_t page_bytes = big_endian(16, 2) == 1 ? 65536 : big_endian(16, 2);
  const bool counted = big_endian(24, 4) == big_endian(92, 4);
  return counted && page_bytes * big_endian(28, 4) > file.size();
}

}  // namespace

bool is_sqlite(std::string_view head) { return head.starts_with(std::string_view("SQLite format 3\0", 16)); }

SqliteBag::SqliteBag(const BagInput& input, Progress& progress) : input_(input), database_(nullptr, sqlite3_close) {
  files_ = {input.given};
  const std::filesystem::path& database = input.path();
  const formats::RandomAccessFile file(database);  // refuses what is no regular file, which SQLite would wait for
  // Beside a recording that was interrupted lies a log of what is not in the file yet.
  std::error_code none;
  const std::uintmax_t log_bytes = std::filesystem::file_size(database.string() + "-wal", none);
  has_log_ = !none && log_bytes > 0;
  file_bytes_ = file.size() + (has_log_ ? log_bytes : 0);
  const bool cut = is_cut(file);
  open_database(database, cut);
  if (has_log_ && !can_be_read()) copy_aside(cut, progress);
  if (progress.cancelled()) return;
  read_topics();
  read_rows(cut, progress);
  sort_topics();
}

SqliteBag::~SqliteBag() = default;

void SqliteBag::fail(Message what) const {
  if (database_)
    what = say::bag_database_says(std::move(what), formats::library_words(sqlite3_errmsg(database_.get())));
  throw Error(ErrorCode::Format, files_[0].string(), std::move(what));
}

void SqliteBag::open_database(const std::filesystem::path& path, bool cut) {
  // Without a log the file is read as it is, so that nothing is written beside it.
  sqlite3* database = nullptr;
  const int code = sqlite3_open_v2(uri_of(path, has_log_ ? "?mode=ro" : "?mode=ro&immutable=1").c_str(), &database,
                                   SQLITE_OPEN_READONLY | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX, nullptr);
  database_.reset(database);
  if (code != SQLITE_OK) fail(say::bag_database_not_opened());
  // No value is longer than the file, but for those that are computed.
  sqlite3_limit(database, SQLITE_LIMIT_LENGTH, static_cast<int>(std::min(kLongestValue, file_bytes_ + kPageBytes)));
  // A hostile schema must not run anything: a view has rows without end.
  sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  // SQLite refuses a file that is shorter than its header says, but for those who mean to repair it.
  if (cut) sqlite3_exec(database, "PRAGMA writable_schema = ON", nullptr, nullptr, nullptr);
}

bool SqliteBag::can_be_read() const {
  const Statement rows = prepare(database_.get(), "SELECT count(*) FROM sqlite_master");
  const int code = rows ? sqlite3_step(rows.get()) : sqlite3_errcode(database_.get());
  return code != SQLITE_CANTOPEN && code != SQLITE_READONLY && code != SQLITE_IOERR;
}

/// SQLite makes an index of the log beside it, which a folder that cannot be written refuses.
void SqliteBag::copy_aside(bool cut, Progress& progress) {
  const std::filesystem::path database = input_.path();
  input_.unpacked =
      std::make_shared<const UnpackedFile>(UnpackedFile::WithLog{database, database.string() + "-wal"}, progress);
  if (progress.cancelled()) return;
  open_database(input_.path(), cut);
  findings_.push_back(drive::make_finding(drive::Severity::Note, "bag-copied", files_[0].string(), say::bag_copied()));
}

/// By types. Only later versions of rosbag2 write them down.
std::map<std::string, std::string, std::less<>> SqliteBag::read_definitions() {
  std::map<std::string, std::string, std::less<>> definitions;
  const Statement rows =
      prepare(database_.get(), "SELECT topic_type, encoding, encoded_message_definition FROM message_definitions");
  while (rows && sqlite3_step(rows.get()) == SQLITE_ROW)
    if (text_of(rows.get(), 1) == "ros2msg")
      definitions[text_of(rows.get(), 0)] = kept_definition(text_of(rows.get(), 0), text_of(rows.get(), 2));
  return definitions;
}

void SqliteBag::read_topics() {
  const std::map<std::string, std::string, std::less<>> definitions = read_definitions();
  const Statement rows = prepare(database_.get(), "SELECT id, name, type, serialization_format FROM topics");
  if (!rows) fail(say::bag_no_table("topics"));
  while (sqlite3_step(rows.get()) == SQLITE_ROW) {
    const std::string type = text_of(rows.get(), 2);
    const auto definition = definitions.find(type);
    const std::size_t index = topic(text_of(rows.get(), 1), type,
                                    text_of(rows.get(), 3) == "cdr" ? MessageEncoding::Cdr : MessageEncoding::Other,
                                    definition == definitions.end() ? std::string_view() : definition->second);
    topic_of_id_.emplace_back(sqlite3_column_int64(rows.get(), 0), index);
  }
  std::sort(topic_of_id_.begin(), topic_of_id_.end());
}

void SqliteBag::read_rows(bool cut, Progress& progress) {
  // In the order of the table, without the messages themselves: these lie on pages of their own.
  const Statement rows = prepare(database_.get(), "SELECT id, topic_id, timestamp FROM messages");
  if (!rows) fail(say::bag_no_table("messages"));
  std::size_t unknown = 0;
  int code = SQLITE_DONE;
  while (!progress.cancelled() && (code = sqlite3_step(rows.get())) == SQLITE_ROW) {
    if (entry_count() % 20'000 == 0) progress.report(say::stage_reading_the_index, entry_count(), 0);
    const std::int64_t id = sqlite3_column_int64(rows.get(), 1);
    const auto found = std::lower_bound(topic_of_id_.begin(), topic_of_id_.end(), std::pair{id, std::size_t{0}});
    if (found == topic_of_id_.end() || found->first != id) {
      ++unknown;
      continue;
    }
    BagEntry entry;
    entry.log_time_ns = sqlite3_column_int64(rows.get(), 2);
    entry.offset = static_cast<std::uint64_t>(sqlite3_column_int64(rows.get(), 0));
    add_entry(found->second, entry, file_bytes_, files_[0].string());
  }
  const bool stopped = code != SQLITE_DONE && !progress.cancelled();
  const bool damaged = stopped || cut;
  const Message why =
      stopped ? formats::library_words(sqlite3_errmsg(database_.get())) : say::bag_shorter_than_database();
  if (entry_count() == 0 && !progress.cancelled())
    throw Error(ErrorCode::Format, files_[0].string(),
                damaged ? say::bag_database_not_readable(why) : say::bag_database_empty());
  if (damaged || unknown > 0)
    findings_.push_back(drive::make_finding(drive::Severity::Warning, "bag-damaged", files_[0].string(),
                                            damaged ? say::bag_database_damaged(why, entry_count(), unknown)
                                                    : say::bag_messages_of_no_topic(entry_count(), unknown)));
}

std::string SqliteBag::message(const BagEntry& entry, std::size_t at_most) const {
  const std::scoped_lock lock(mutex_);
  const auto row = static_cast<std::int64_t>(entry.offset);
  const std::string where = files_[0].string() + ": message " + std::to_string(row);
  sqlite3_blob* opened = nullptr;
  const int code = sqlite3_blob_open(database_.get(), "main", "messages", "data", row, 0, &opened);
  const std::unique_ptr<sqlite3_blob, int (*)(sqlite3_blob*)> blob(opened, sqlite3_blob_close);
  if (code != SQLITE_OK) throw Error(ErrorCode::Format, where, formats::library_words(sqlite3_errmsg(database_.get())));
  const auto bytes = static_cast<std::uint64_t>(sqlite3_blob_bytes(blob.get()));
  if (bytes > file_bytes_) throw Error(ErrorCode::Format, where, say::bag_row_too_large(Bytes{bytes}));
  const auto read = [&](std::uint64_t count) {
    std::string data(count, '\0');
    if (sqlite3_blob_read(blob.get(), data.data(), static_cast<int>(count), 0) != SQLITE_OK)
      throw Error(ErrorCode::Format, where, formats::library_words(sqlite3_errmsg(database_.get())));
    return data;
  };
  return message_content({bytes, read, file_bytes_, where}, at_most);
}

}  // namespace remount::bags
