#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QFont>
#include <QSignalSpy>

#include "model/checks/data_check.h"
#include "tests/widgets/support/restored.h"
#include "tests/widgets/support/sample_world.h"
#include "widgets/pairs/pair_filter.h"
#include "widgets/result/candidate_table_model.h"
#include "widgets/sessions/session_list_model.h"
#include "widgets/text/model_text.h"

namespace remount::widgets {
namespace {

pipeline::PipelineInput input_of_one_drive() {
  pipeline::PipelineInput input;
  input.sessions = {std::make_shared<const drive::Session>(testing::sample_session("drive1"))};
  return input;
}

std::shared_ptr<const pipeline::PipelineOutput> output_of_one_drive(int pairs) {
  return std::make_shared<const pipeline::PipelineOutput>(testing::sample_output(input_of_one_drive(), pairs));
}

TEST(pair_table_model, keeps_the_contract_of_item_models) {
  PairTableModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  model.show_output(output_of_one_drive(20), {"drive1"});
  model.show_output(nullptr, {});
  EXPECT_EQ(model.rowCount(), 0);
}

TEST(pair_table_model, updates_the_same_pairs_without_a_reset) {
  PairTableModel model;
  model.show_output(output_of_one_drive(20), {"drive1"});
  QSignalSpy resets(&model, &QAbstractItemModel::modelReset), changes(&model, &QAbstractItemModel::dataChanged);
  model.show_output(output_of_one_drive(20), {"drive1"});
  EXPECT_EQ(resets.count(), 0);
  EXPECT_EQ(changes.count(), 1);
  model.show_output(output_of_one_drive(21), {"drive1"});
  EXPECT_EQ(resets.count(), 1);
}

TEST(pair_table_model, shows_units_of_its_headings) {
  PairTableModel model;
  auto output = std::make_shared<pipeline::PipelineOutput>(*output_of_one_drive(5));
  output->pairs[2].residual_translation_m = 0.1234;
  output->pairs[2].rotation_rad = degrees_to_radians(12.5);
  model.show_output(output, {"drive1"});
  EXPECT_EQ(model.index(2, PairTableModel::ResidualTranslation).data().toString(), "12.3");
  EXPECT_EQ(model.index(2, PairTableModel::Rotation).data().toString(), "12.50");
  EXPECT_EQ(model.index(2, PairTableModel::SessionName).data().toString(), "drive1");
}

TEST(pair_filter, sorts_by_number_and_not_by_text) {
  PairTableModel model;
  auto output = std::make_shared<pipeline::PipelineOutput>(*output_of_one_drive(3));
  output->pairs[0].baseline_m = 10.0;
  output->pairs[1].baseline_m = 9.0;
  output->pairs[2].baseline_m = 2.0;
  model.show_output(output, {"drive1"});
  PairFilter filter;
  filter.setSourceModel(&model);
  filter.sort(PairTableModel::Baseline, Qt::AscendingOrder);
  EXPECT_EQ(filter.mapToSource(filter.index(0, 0)).row(), 2);
  EXPECT_EQ(filter.mapToSource(filter.index(2, 0)).row(), 0);
}

TEST(pair_filter, filters_by_state_and_by_text_together) {
  PairTableModel model;
  model.show_output(output_of_one_drive(50), {"drive1"});
  PairFilter filter;
  filter.setSourceModel(&model);
  PairCriteria criteria;
  const auto rows = [&](std::optional<motion::PairState> state, const QString& text) {
    criteria.state = state;
    criteria.text = text;
    filter.set_criteria(criteria);
    return filter.rowCount();
  };
  EXPECT_EQ(rows(motion::PairState::Rejected, {}), 7);
  EXPECT_EQ(rows(motion::PairState::Rejected, "SCREW"), 7);
  EXPECT_EQ(rows(motion::PairState::Rejected, "no such words"), 0);
  EXPECT_EQ(rows(std::nullopt, {}), 50);
  EXPECT_EQ(rows(std::nullopt, "17"), 1) << "a number is that pair's";
}

TEST(candidate_table_model, shows_why_a_candidate_is_out_of_range) {
  CandidateTableModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  model.show_output(output_of_one_drive(20));
  ASSERT_EQ(model.rowCount(), 12);
  EXPECT_TRUE(model.index(11, CandidateTableModel::InRange).data().toString().contains("x above 0.98 m"));
  EXPECT_EQ(model.index(0, CandidateTableModel::Rank).data().toString(), "1");
  EXPECT_NE(model.index(11, CandidateTableModel::Rank).data().toString(), "12")
      << "candidates out of range are not ranked";
}

TEST(session_list_model, lists_findings_beneath_their_session) {
  SessionListModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  model.show_sessions({std::make_shared<const drive::Session>(testing::sample_session("drive1")),
                       std::make_shared<const drive::Session>(testing::sample_session("drive2"))});
  ASSERT_EQ(model.rowCount(), 2);
  const QModelIndex second = model.index(1, 0);
  ASSERT_EQ(model.rowCount(second), 1);
  EXPECT_EQ(model.session_of(model.index(0, 0, second)), motion::SessionIndex{1});
  EXPECT_TRUE(model.index(0, 0, second).data().toString().contains("ins.csv:212"));
}

TEST(session_list_model, lists_what_is_found_out_about_a_drive_later) {
  SessionListModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  model.show_sessions({std::make_shared<const drive::Session>(testing::sample_session("drive1")),
                       std::make_shared<const drive::Session>(testing::sample_session("drive2"))});
  const int before = model.rowCount(model.index(0, 0));
  overview::DriveOverview drive;
  drive.findings = {{drive::Severity::Warning, "little-turning", std::string("drive1"),
                     Message::verbatim("The vehicle turns by 1.2 degrees in all.")}};
  model.show_drives({std::make_shared<const overview::DriveOverview>(drive), nullptr});
  ASSERT_EQ(model.rowCount(model.index(0, 0)), before + 1);
  EXPECT_EQ(model.rowCount(model.index(1, 0)), before);
  EXPECT_TRUE(model.index(before, 0, model.index(0, 0)).data().toString().contains("turns by 1.2 degrees"));
  model.show_sessions({});
  EXPECT_EQ(model.rowCount(), 0);
}

TEST(session_list_model, says_of_each_session_whether_the_result_rests_on_it) {
  const testing::LanguageFor english("en");
  pipeline::PipelineInput input;
  for (const char* name : {"drive1", "drive2"})
    input.sessions.push_back(std::make_shared<const drive::Session>(testing::sample_session(name)));
  auto output = std::make_shared<pipeline::PipelineOutput>(testing::sample_output(input, 10));
  for (motion::Pair& pair : output->pairs) {
    output->keyframes[pair.keyframe_a].session = motion::SessionIndex{1};
    pair.state = motion::PairState::Rejected;
  }
  SessionListModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  model.show_sessions(input.sessions);
  const auto said = [&](int session) { return model.index(session, 0).data().toString(); };
  EXPECT_FALSE(said(0).contains("not in the result")) << "nothing is calibrated yet";
  model.show_use(output, 2);
  EXPECT_TRUE(said(0).contains("not in the result: it has no pairs")) << said(0).toStdString();
  EXPECT_TRUE(said(1).contains("none of its 10 pairs is accepted")) << said(1).toStdString();
  output->pairs[3].state = motion::PairState::Accepted;
  model.show_use(output, 2);
  EXPECT_TRUE(said(1).contains("1 of 10 pairs accepted")) << said(1).toStdString();
  output->pairs[3].state = motion::PairState::Proposed;
  model.show_use(output, 2);
  EXPECT_FALSE(said(1).contains("not in the result")) << "one is not judged yet";
  model.show_use(output, 1);
  EXPECT_FALSE(said(1).contains("pairs")) << "it was opened since";
  model.show_use(nullptr, 0);
  EXPECT_FALSE(said(1).contains("accepted"));
}

TEST(session_list_model, a_finding_tells_its_code_what_it_means_and_what_to_do) {
  drive::Session session = testing::sample_session("drive1");
  session.findings = {
      {drive::Severity::Warning, "ins-jump", std::string("INS"), Message::verbatim("The position jumps 2 times.")}};
  SessionListModel model;
  model.show_sessions({std::make_shared<const drive::Session>(session)});
  const QString told = model.index(0, 0, model.index(0, 0)).data(Qt::ToolTipRole).toString();
  const checks::FindingKind& kind = *checks::finding_kind("ins-jump");
  for (const QString& part : {QStringLiteral("[ins-jump]"), QStringLiteral("The position jumps 2 times."),
                              model_text(kind.meaning()), model_text(kind.remedy())})
    EXPECT_TRUE(told.contains(part)) << part.toStdString() << "\n" << told.toStdString();
}

TEST(session_list_model, every_code_is_explained) {
  for (const checks::DataCheck& check : checks::data_checks())
    for (const checks::FindingKind& kind : check.kinds) {
      std::string code(kind.code);
      if (const std::size_t star = code.find('*'); star != std::string::npos) code.replace(star, 1, "of-a-stream");
      drive::Session session = testing::sample_session("drive1");
      session.findings = {
          {drive::Severity::Warning, code, std::string("a place"), Message::verbatim("Something was found there.")}};
      SessionListModel model;
      model.show_sessions({std::make_shared<const drive::Session>(session)});
      const QString told = model.index(0, 0, model.index(0, 0)).data(Qt::ToolTipRole).toString();
      for (const QString& part : {QString::fromStdString(code), model_text(kind.meaning()), model_text(kind.remedy())})
        EXPECT_TRUE(told.contains(part)) << code << ": " << part.toStdString() << "\n" << told.toStdString();
    }
}

TEST(candidate_table_model, the_row_that_became_the_result_is_marked_and_no_other) {
  auto output = std::make_shared<pipeline::PipelineOutput>(*output_of_one_drive(20));
  std::swap(output->result.candidates[0], output->result.candidates[3]);
  CandidateTableModel model;
  model.show_output(output);
  EXPECT_EQ(model.result_row(), 3);
  for (int row = 0; row < model.rowCount(); ++row) {
    const QModelIndex source = model.index(row, CandidateTableModel::Source);
    EXPECT_EQ(source.data().toString().contains("the result"), row == 3) << row;
    EXPECT_EQ(source.data(Qt::ToolTipRole).toString().contains("the result"), row == 3) << row;
    EXPECT_EQ(source.data(Qt::FontRole).value<QFont>().bold(), row == 3) << row;
  }
  output->result.status = calibration::Status::OutOfRange;
  model.show_output(std::make_shared<const pipeline::PipelineOutput>(*output));
  EXPECT_EQ(model.result_row(), -1) << "nothing was solved";
}

}  // namespace
}  // namespace remount::widgets
