#include <sqlite3.h>

#include <system_error>

#include "algorithms/core/error.h"
#include "messages/bags.h"
#include "model/formats/bags/bag_writer.h"
#include "model/formats/files/system_words.h"

namespace remount::bags {
namespace {

namespace fs = std::filesystem;

// The tables of rosbag2_storage_sqlite3, version 3 and before.
constexpr const char* kTables =
    "PRAGMA journal_mode = OFF;"  // the file is thrown away where it does not become whole
    "PRAGMA synchronous = OFF;"
    "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,"
    " serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);"
    "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL,"
    " data BLOB NOT NULL);"
    "CREATE INDEX timestamp_idx ON messages (timestamp ASC);"
    "BEGIN;";

class SqliteWriter final : public BagWriter {
 public:
  explicit SqliteWriter(const fs::path& path) : path_(path), part_(path.string() + ".part") {
    std::error_code ignored;
    fs::remove(part_, ignored);  // of a writer that was killed
    sqlite3* database = nullptr;
    const int code = sqlite3_open_v2(part_.c_str(), &database,
                                     SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_EXRESCODE, nullptr);
    database_.reset(database);
    check(code == SQLITE_OK);
    check(sqlite3_exec(database, kTables, nullptr, nullptr, nullptr) == SQLITE_OK);
    topic_ = prepare("INSERT INTO topics VALUES(?, ?, ?, 'cdr', '')");
    message_ = prepare("INSERT INTO messages(topic_id, timestamp, data) VALUES(?, ?, ?)");
  }
  ~SqliteWriter() override {
    if (finished_) return;
    close();
    std::error_code ignored;
    fs::remove(part_, ignored);
  }

  MessageEncoding encoding() const override { return MessageEncoding::Cdr; }

  std::uint32_t add_topic(const std::string& name, const MessageDefinition& definition) override {
    sqlite3_bind_int64(topic_.get(), 1, ++topics_);
    bind(topic_, 2, name);
    bind(topic_, 3, definition.type);
    run(topic_);
    return topics_ - 1U;
  }

  void write(std::uint32_t topic, std::int64_t log_time_ns, std::string_view message) override {
    sqlite3_bind_int64(message_.get(), 1, topic + 1);
    sqlite3_bind_int64(message_.get(), 2, log_time_ns);
    check(sqlite3_bind_blob64(message_.get(), 3, message.data(), message.size(), SQLITE_STATIC) == SQLITE_OK);
    run(message_);
  }

  void finish() override {
    check(sqlite3_exec(database_.get(), "COMMIT", nullptr, nullptr, nullptr) == SQLITE_OK);
    close();
    std::error_code failed;
    fs::rename(part_, path_, failed);
    if (failed) throw Error(ErrorCode::Io, path_.string(), say::bag_not_written(formats::system_words(failed)));
    finished_ = true;
  }

 private:
  using Statement = std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)>;

  Statement prepare(const char* sql) {
    sqlite3_stmt* statement = nullptr;
    check(sqlite3_prepare_v2(database_.get(), sql, -1, &statement, nullptr) == SQLITE_OK);
    return {statement, sqlite3_finalize};
  }
  void bind(const Statement& statement, int place, const std::string& text) {
    check(sqlite3_bind_text(statement.get(), place, text.data(), static_cast<int>(text.size()), SQLITE_STATIC) ==
          SQLITE_OK);
  }
  void run(const Statement& statement) {
    check(sqlite3_step(statement.get()) == SQLITE_DONE);
    sqlite3_reset(statement.get());
  }
  void check(bool good) const {
    if (!good) throw Error(ErrorCode::Io, path_.string(), say::bag_not_written(reason()));
  }
  Message reason() const {
    return database_ ? formats::library_words(sqlite3_errmsg(database_.get())) : say::bag_out_of_memory();
  }
  void close() {
    topic_.reset();
    message_.reset();
    database_.reset();
  }

  fs::path path_, part_;
  std::unique_ptr<sqlite3, int (*)(sqlite3*)> database_{nullptr, sqlite3_close};
  Statement topic_{nullptr, sqlite3_finalize}, message_{nullptr, sqlite3_finalize};
  std::uint32_t topics_ = 0;
  bool finished_ = false;
};

}  // namespace

std::unique_ptr<BagWriter> make_sqlite_writer(const std::filesystem::path& path) {
  return std::make_unique<SqliteWriter>(path);
}

}  // namespace remount::bags
