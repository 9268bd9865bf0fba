#include "model/formats/documents/finding_document.h"

#include <gtest/gtest.h>

#include "algorithms/core/error.h"
#include "model/formats/documents/parse_document.h"

namespace remount {
namespace {

std::vector<Finding> read(const std::string& text) {
  const DocumentNode list = parse_yaml(text, "findings.yaml");
  return findings_from_document(DocumentView(list, "findings.yaml"));
}

TEST(finding_document, findings_come_back_as_they_were) {
  const std::vector<Finding> findings{{Severity::Note, "a", "drive", "Said."},
                                      {Severity::Warning, "b", "ins.csv:3", "\"quoted\""},
                                      {Severity::Problem, "c", "", "2"}};
  const std::vector<Finding> again = read(to_yaml(findings_document(findings)));
  ASSERT_EQ(again.size(), findings.size());
  for (std::size_t i = 0; i < findings.size(); ++i) {
    EXPECT_EQ(again[i].severity, findings[i].severity);
    EXPECT_EQ(again[i].code, findings[i].code);
    EXPECT_EQ(again[i].where, findings[i].where);
    EXPECT_EQ(again[i].explanation, findings[i].explanation);
  }
}

TEST(finding_document, severities_of_earlier_projects_are_numbers) {
  const auto with_severity = [](const std::string& severity) {
    return "- {severity: " + severity + ", code: a, where: b, explanation: c}\n";
  };
  EXPECT_EQ(read(with_severity("1")).at(0).severity, Severity::Warning);
  EXPECT_EQ(read(with_severity("problem")).at(0).severity, Severity::Problem);
  for (const char* wrong : {"3", "-1", "dire", "[]", ""}) EXPECT_THROW(read(with_severity(wrong)), Error) << wrong;
}

}  // namespace
}  // namespace remount
