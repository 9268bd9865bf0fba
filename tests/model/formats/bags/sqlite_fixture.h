// Bags of ROS 2 in SQLite, as rosbag2 makes them.
#pragma once

#include <sqlite3.h>

#include "model/formats/bags/chunk_codec.h"
#include "tests/model/formats/bags/bag_fixtures.h"

namespace remount::bags {

inline void run(sqlite3* database, const std::string& sql) {
  char* problem = nullptr;
  ASSERT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, &problem), SQLITE_OK) << problem;
}

inline constexpr const char* kRosbag2Tables =
    "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,"
    " serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);"
    "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL,"
    " data BLOB NOT NULL);"
    "CREATE INDEX timestamp_idx ON messages (timestamp ASC);";

/// The tables that rosbag2 makes. @param topics names and types; messages name them by their place from 0
inline void write_database(const fs::path& path, const std::vector<std::pair<std::string, std::string>>& topics,
                           const std::vector<TestMessage>& messages, bool packed = false) {
  fs::create_directories(path.parent_path());
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
  run(database, std::string(kRosbag2Tables) + "BEGIN;");
  for (const auto& [name, type] : topics)
    run(database, "INSERT INTO topics(name, type, serialization_format, offered_qos_profiles) VALUES('" + name +
                      "', '" + type + "', 'cdr', '')");
  sqlite3_stmt* insert = nullptr;
  ASSERT_EQ(sqlite3_prepare_v2(database, "INSERT INTO messages(topic_id, timestamp, data) VALUES(?, ?, ?)", -1, &insert,
                               nullptr),
            SQLITE_OK);
  for (const TestMessage& message : messages) {
    const std::string data = packed ? pack_chunk(ChunkCompression::Zstd, message.bytes) : message.bytes;
    sqlite3_bind_int64(insert, 1, message.topic + 1);
    sqlite3_bind_int64(insert, 2, message.time_ns);
    sqlite3_bind_blob(insert, 3, data.data(), static_cast<int>(data.size()), SQLITE_TRANSIENT);
    ASSERT_EQ(sqlite3_step(insert), SQLITE_DONE);
    sqlite3_reset(insert);
  }
  sqlite3_finalize(insert);
  run(database, "COMMIT");
  sqlite3_close(database);
}

/// With the topics of test_messages.
inline void write_database(const fs::path& path, const std::vector<TestMessage>& messages, bool packed = false) {
  write_database(path, {{"/a", "test_msgs/msg/Text"}, {"/b", "test_msgs/msg/Text"}}, messages, packed);
}

}  // namespace remount::bags
