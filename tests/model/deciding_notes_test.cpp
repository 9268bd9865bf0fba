#include "model/deciding_notes.h"

#include <gtest/gtest.h>

#include "model/project.h"

namespace remount {
namespace {

TEST(deciding_notes, reach_the_result_file_and_other_notes_do_not) {
  PipelineInput input;
  PipelineOutput output;
  output.findings = {{Severity::Note, kRecording, "a", "Taken for the recording: turn."},
                     {Severity::Note, "nominal-found", "b", "Of no consequence."},
                     {Severity::Warning, "anything", "c", "Always."}};
  const ResultFile file = make_result_file(input, output, {});
  ASSERT_EQ(file.findings.size(), 2u);
  EXPECT_EQ(file.findings[0].code, kRecording);
  EXPECT_EQ(file.findings[1].code, "anything");
}

}  // namespace
}  // namespace remount
