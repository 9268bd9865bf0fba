// Large tables in JSON, row by row.
#include "model/formats/documents/table_rows.h"

#include <gtest/gtest.h>

#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

class table_rows : public ::testing::Test {
 protected:
  TableRows rows_of(const std::string& text) { return TableRows(folder_.write("t.json", text)); }
  /// Of all rows.
  std::string tokens_of(const std::string& text) {
    TableRows rows = rows_of(text);
    std::string tokens;
    while (rows.next()) tokens += rows.text("token") + " ";
    return tokens;
  }
  TemporaryFolder folder_;
};

TEST_F(table_rows, values_are_found_by_their_keys_in_any_notation) {
  TableRows rows = rows_of(
      " [\r\n{ \"token\" : \"a\\/b\\\"c\", \"more\": {\"deep\": [1, {\"x\": \"}]\"}]}, \"n\":-12,\"list\": [ 1.5,-2e3 "
      ", 3 ],"
      "\"none\": null, \"empty\": []}\n,\n{\"token\":\"\"}] \n");
  ASSERT_TRUE(rows.next());
  EXPECT_EQ(rows.text("token"), "a/b\"c");
  EXPECT_EQ(rows.integer("n"), -12);
  EXPECT_EQ(rows.numbers("list", 3), (std::vector<double>{1.5, -2000.0, 3.0}));
  EXPECT_ERROR(rows.numbers("list", 4), "list is no list of 4 numbers");
  EXPECT_ERROR(rows.numbers("none", 1), "none is no list");
  EXPECT_ERROR(rows.integer("token"), "token is no whole number");
  EXPECT_ERROR(rows.text("n"), "n is no text");
  EXPECT_ERROR(rows.text("deep"), "the row has no deep");
  ASSERT_TRUE(rows.next());
  EXPECT_EQ(rows.text("token"), "");
  EXPECT_FALSE(rows.next());
  EXPECT_FALSE(rows.next());
}

TEST_F(table_rows, empty_tables_have_no_rows) {
  EXPECT_EQ(tokens_of("[]"), "");
  EXPECT_EQ(tokens_of("[ \n ]\n"), "");
}

TEST_F(table_rows, behind_a_row_that_is_none_the_next_is_read) {
  const std::string long_text(100'000, 'a');
  TableRows rows =
      rows_of("[\n{\"token\": \"a\"},\n{\"token\" \"b\"},\n{\"token\": \"" + long_text + "\"},\n{\"token\": \"d\"}\n]");
  ASSERT_TRUE(rows.next());
  EXPECT_ERROR(rows.next(), "t.json:3: expected a row");
  EXPECT_ERROR(rows.next(), "t.json:4: the row is longer than");
  ASSERT_TRUE(rows.next());
  EXPECT_EQ(rows.text("token"), "d");
  EXPECT_ERROR(rows.text("name"), "t.json:5: the row has no name");
  EXPECT_FALSE(rows.next());
  EXPECT_FALSE(rows.is_no_table());
  TableRows cut = rows_of("[{\"token\": \"a\"},{\"token\": \"b");
  ASSERT_TRUE(cut.next());
  EXPECT_ERROR(cut.next(), "ends within a row");
  EXPECT_FALSE(cut.next()) << "nothing can follow";
  TableRows none = rows_of("{}");
  EXPECT_ERROR(none.next(), "expected a list");
  EXPECT_TRUE(none.is_no_table());
  EXPECT_FALSE(none.next());
}

TEST_F(table_rows, what_is_no_table_is_refused_with_its_place) {
  EXPECT_ERROR(tokens_of(""), "expected a list of rows");
  EXPECT_ERROR(tokens_of("{\"token\": \"a\"}"), "t.json: byte 0: expected a list of rows");
  EXPECT_ERROR(tokens_of("[{\"token\": \"a\"}"), "expected a row");
  EXPECT_ERROR(tokens_of("[{\"token\": \"a\"} {\"token\": \"b\"}]"), "byte 16: expected a row");
  EXPECT_ERROR(tokens_of("[{\"token\": \"a\"},]"), "expected a row");
  EXPECT_ERROR(tokens_of("[1, 2]"), "byte 1: expected a row");
  EXPECT_ERROR(tokens_of("[{\"token\": \"a"), "byte 1: the file ends within a row");
  EXPECT_ERROR(tokens_of("[{\"token\" \"a\"}]"), "expected a row");
  EXPECT_ERROR(tokens_of("[{\"token\": }]"), "expected a row");
  EXPECT_ERROR(tokens_of("[{token: 1}]"), "expected a row");
  EXPECT_ERROR(tokens_of("[{]"), "expected a row");
  EXPECT_ERROR(tokens_of("[{\"token\": \"" + std::string(100'000, 'a') + "\"}]"), "the row is longer than");
}

}  // namespace
}  // namespace remount::formats
