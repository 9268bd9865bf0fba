#include "model/formats/documents/finding_document.h"

#include <gtest/gtest.h>

#include "algorithms/core/error.h"
#include "messages/places.h"
#include "model/formats/documents/parse_document.h"

namespace remount::formats {
namespace {

std::vector<drive::Finding> read(const std::string& text) {
  const DocumentNode list = parse_yaml(text, "findings.yaml");
  return findings_from_document(DocumentView(list, "findings.yaml"));
}

TEST(finding_document, findings_come_back_as_they_were) {
  const std::vector<drive::Finding> findings{
      {drive::Severity::Note, "a", std::string("drive"), Message::verbatim("Said.")},
      {drive::Severity::Warning, "b", std::string("ins.csv:3"), Message::verbatim("\"quoted\"")},
      {drive::Severity::Problem, "c", {}, Message::verbatim("2")},
      {drive::Severity::Note, "d", say::place_lidar_and_gnss(), Message::verbatim("3")}};
  const std::vector<drive::Finding> again = read(to_yaml(findings_document(findings)));
  ASSERT_EQ(again.size(), findings.size());
  for (std::size_t i = 0; i < findings.size(); ++i) {
    EXPECT_EQ(again[i].severity, findings[i].severity);
    EXPECT_EQ(again[i].code, findings[i].code);
    EXPECT_EQ(again[i].where, findings[i].where) << drive::english(findings[i].where);
    EXPECT_EQ(again[i].explanation, findings[i].explanation);
  }
}

TEST(finding_document, files_say_where_in_english_with_the_code_beside_it) {
  const std::string yaml = to_yaml(findings_document({{drive::Severity::Note, "a", say::place_scans(), {}}}));
  EXPECT_NE(yaml.find("where: scans\n"), std::string::npos) << yaml;
  EXPECT_NE(yaml.find("place: place-scans\n"), std::string::npos) << yaml;
  EXPECT_EQ(read("- {severity: note, code: a, where: scans, explanation: b}\n").at(0).where, std::string("scans"))
      << "of a former version: as it was written";
}

TEST(finding_document, severities_of_earlier_projects_are_numbers) {
  const auto with_severity = [](const std::string& severity) {
    return "- {severity: " + severity + ", code: a, where: b, explanation: c}\n";
  };
  EXPECT_EQ(read(with_severity("1")).at(0).severity, drive::Severity::Warning);
  EXPECT_EQ(read(with_severity("problem")).at(0).severity, drive::Severity::Problem);
  for (const char* wrong : {"3", "-1", "dire", "[]", ""}) EXPECT_THROW(read(with_severity(wrong)), Error) << wrong;
}

}  // namespace
}  // namespace remount::formats
