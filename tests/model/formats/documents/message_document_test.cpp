#include "model/formats/documents/message_document.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "messages/decisions.h"
#include "messages/results.h"
#include "model/formats/documents/parse_document.h"

namespace remount::formats {
namespace {

Message every_kind() {
  const Message inner("of-file", {{"file", value_of(std::string("a \"b\".csv"))}, {"what", value_of(Message())}});
  return {"of-every-kind",
          {{"way", value_of(Length{0.1})},
           {"turn", value_of(Angle{-2.5})},
           {"time", value_of(Duration{std::nan("")})},
           {"speed", value_of(Speed{3.0})},
           {"rate", value_of(TurnRate{0.2})},
           {"change", value_of(Acceleration{9.81})},
           {"often", value_of(Frequency{10.0})},
           {"part", value_of(Share{0.5})},
           {"size", value_of(Bytes{1234567890123})},
           {"ratio", value_of(1.0 / 3.0)},
           {"many", value_of(Count(-3))},
           {"names", value_of(std::vector<std::string>{"x", "y: z"})},
           {"inner", value_of(inner)},
           {"list", value_of(std::vector<Message>{inner, Message::verbatim("words")})}}};
}

Message read_back(const Message& message, bool as_yaml) {
  DocumentNode root = DocumentNode::map();
  root.add("message", message_document(message));
  const DocumentNode parsed = as_yaml ? parse_yaml(to_yaml(root), "f") : parse_json(to_json(root), "f");
  return message_from_document(DocumentView(parsed, "f").at("message"));
}

TEST(message_document, what_was_written_reads_back_the_same) {
  for (const bool as_yaml : {true, false})
    for (const Message& message : {every_kind(), Message(), Message::verbatim("user's: words"),
                                   Message::sequence({every_kind(), Message::verbatim("and more")})})
      EXPECT_EQ(read_back(message, as_yaml), message) << (as_yaml ? "YAML" : "JSON");
}

TEST(message_document, a_plain_text_of_an_earlier_version_is_kept_as_it_is) {
  const DocumentNode parsed = parse_yaml("message: overlap too small", "f");
  const Message message = message_from_document(DocumentView(parsed, "f").at("message"));
  EXPECT_EQ(message, Message::verbatim("overlap too small"));
}

TEST(message_document, words_of_an_earlier_version_that_the_program_acts_on_are_known) {
  for (const auto& [words, message] :
       {std::pair<const char*, Message (*)()>("rejected by the user", say::rejected_by_the_user),
        std::pair<const char*, Message (*)()>("moving objects", say::reason_moving_objects),
        std::pair<const char*, Message (*)()>(
            "Preliminary: the calibration was cancelled before its end, and its sigmas do not hold.",
            say::result_preliminary)}) {
    DocumentNode root = DocumentNode::map();
    root.add("message", DocumentNode::string(words));
    EXPECT_EQ(message_from_document(DocumentView(root, "f").at("message")), message()) << words;
  }
}

TEST(message_document, what_is_no_message_is_refused_with_its_place) {
  for (const char* text :
       {"message: {code: x, arguments: {a: {length_m: wide}}}", "message: {code: x, arguments: {a: 1}}",
        "message: {arguments: {}}", "message: {code: x, arguments: {a: {count: 1, text: b}}}"}) {
    const DocumentNode parsed = parse_yaml(text, "f");
    EXPECT_THROW(message_from_document(DocumentView(parsed, "f").at("message")), Error) << text;
  }
}

TEST(message_document, messages_without_end_are_refused) {
  std::string text;
  for (int i = 0; i < 30; ++i) text += "{code: x, arguments: {a: {message: ";
  text += "end";
  for (int i = 0; i < 30; ++i) text += "}}}";
  DocumentLimits deep;
  deep.max_depth = 200;  // files are refused before that
  const DocumentNode parsed = parse_yaml("message: " + text, "f", deep);
  EXPECT_THROW(message_from_document(DocumentView(parsed, "f").at("message")), Error);
}

}  // namespace
}  // namespace remount::formats
