#include "model/formats/files/system_words.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <cstring>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "model/formats/documents/parse_document.h"
#include "model/formats/files/input_file.h"

namespace remount::formats {
namespace {

TEST(system_words, are_the_systems_own_in_english_and_not_in_chinese) {
  for (const int number : {ENOENT, EACCES, EPERM, ENOSPC, EDQUOT, EIO, EROFS, EISDIR, ENOTDIR, ENAMETOOLONG, ESTALE,
                           ELOOP, EMFILE, EFBIG, ENOMEM, EBUSY}) {
    const Message said = system_words(number);
    EXPECT_EQ(english(said), std::strerror(number));
    EXPECT_NE(render(said, Language::Chinese), std::strerror(number)) << number;
    EXPECT_EQ(system_words(std::error_code(number, std::generic_category())), said);
  }
}

TEST(system_words, that_are_not_in_the_catalogue_stay_as_they_are) {
  EXPECT_EQ(system_words(EXDEV), Message::verbatim(std::strerror(EXDEV)));
  EXPECT_EQ(library_words("a word of a later version"), Message::verbatim("a word of a later version"));
}

TEST(system_words, reach_the_errors_of_readers_in_chinese) {
  const auto told = [](auto&& read) {
    try {
      read();
    } catch (const Error& error) {
      return render(error.what_happened(), Language::Chinese);
    }
    return std::string("nothing");
  };
  EXPECT_NE(told([] { read_regular_file("/there/is/no/such/file", 10); }).find("没有这个文件或文件夹"),
            std::string::npos);
  const std::string of_yaml = told([] { parse_yaml("a: b: c", "f"); });
  EXPECT_NE(of_yaml.find("映射的值不合法"), std::string::npos) << of_yaml;
}

}  // namespace
}  // namespace remount::formats
