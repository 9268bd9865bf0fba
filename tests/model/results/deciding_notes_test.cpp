#include "model/results/deciding_notes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "model/pipeline/position_lag.h"
#include "model/project/project.h"

namespace remount::results {
namespace {

TEST(deciding_notes, reach_the_result_file_and_other_notes_do_not) {
  pipeline::PipelineInput input;
  pipeline::PipelineOutput output;
  output.findings = {
      {drive::Severity::Note, kRecording, std::string("a"), Message::verbatim("Taken for the recording: turn.")},
      {drive::Severity::Note, "nominal-found", std::string("b"), Message::verbatim("Of no consequence.")},
      {drive::Severity::Warning, "anything", std::string("c"), Message::verbatim("Always.")}};
  const ResultFile file = project::make_result_file(input, output, {});
  ASSERT_EQ(file.findings.size(), 2u);
  EXPECT_EQ(file.findings[0].code, kRecording);
  EXPECT_EQ(file.findings[1].code, "anything");
}

/// The sources of the model that make findings: not what lists their codes.
std::string sources_of_findings() {
  std::ostringstream text;
  const std::filesystem::path model = std::filesystem::path(REMOUNT_SOURCE_DIR) / "model";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(model)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() == ".cpp" && name != "deciding_notes.cpp" &&
        entry.path().parent_path().filename() != "checks")
      text << std::ifstream(entry.path()).rdbuf();
  }
  return text.str();
}

TEST(deciding_notes, are_each_made_somewhere_and_listed_once) {
  const std::string sources = sources_of_findings();
  ASSERT_GT(sources.size(), 100'000u);
  const auto named = [](std::string_view code) -> std::string {
    if (code == kRecording) return "kRecording";
    if (code == kOdometryByWheels) return "kOdometryByWheels";
    if (code == kCloserKeyframes) return "kCloserKeyframes";
    if (code == kScansGathered) return "kScansGathered";
    if (code == kPairsChosen) return "kPairsChosen";
    if (code == kMendedBeams) return "kMendedBeams";
    if (code == pipeline::kPositionsApart) return "kPositionsApart";
    return '"' + std::string(code) + '"';
  };
  for (const std::string_view code : kDecidingNotes) {
    EXPECT_NE(sources.find(named(code)), std::string::npos) << code << " is made nowhere";
    EXPECT_EQ(std::count(kDecidingNotes.begin(), kDecidingNotes.end(), code), 1) << code;
    EXPECT_TRUE(is_deciding({drive::Severity::Note, std::string(code), {}, {}})) << code;
  }
  EXPECT_EQ(sources.find("\"utm-poses\""), std::string::npos) << "this one was, and is what the search would miss";
}

}  // namespace
}  // namespace remount::results
