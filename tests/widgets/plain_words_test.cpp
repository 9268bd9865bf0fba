// What a newcomer asks is answered on the page itself, in words.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <set>

#include "algorithms/messages/render.h"
#include "app/gui/basics/language.h"
#include "app/gui/workbench/steps.h"
#include "app/gui/workbench/wording.h"
#include "messages/stages.h"
#include "model/methods/calibrate.h"
#include "model/results/result_words.h"
#include "tests/widgets/support/restored.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/forms/choice_words.h"
#include "widgets/forms/option_form.h"
#include "widgets/pairs/pair_table_model.h"
#include "widgets/quality/clearance_view.h"
#include "widgets/quality/sharpness_view.h"
#include "widgets/result/candidate_plot.h"
#include "widgets/result/candidate_table_model.h"
#include "widgets/result/candidates_panel.h"
#include "widgets/result/hold_out_view.h"
#include "widgets/result/result_panel.h"
#include "widgets/sessions/drive_timeline.h"

namespace remount::widgets {
namespace {

using testing::kPatience_ms;

/// Texts that stand on a widget now, whether or not its window is open.
QString said(const QWidget& widget) {
  QStringList texts;
  for (const QLabel* label : widget.findChildren<QLabel*>())
    if (label->isVisibleTo(&widget)) texts << label->text();
  return texts.join('\n');
}

TEST(sharpness_words, say_whether_the_order_of_the_rows_matters) {
  SharpnessView view;
  view.show_sharpness({{calibration::MountingSource::Result, {-2.466, 0.0175, 900}},
                       {calibration::MountingSource::pair(motion::PairIndex{54}), {-2.472, 0.0170, 900}}});
  EXPECT_TRUE(said(view).contains("No row is clearly sharper")) << said(view).toStdString();
  EXPECT_TRUE(said(view).contains("5 % (here 0.9 mm)")) << said(view).toStdString();
  view.show_sharpness({{calibration::MountingSource::Result, {-2.466, 0.0175, 900}},
                       {calibration::MountingSource::pair(motion::PairIndex{54}), {-2.472, 0.0100, 900}}});
  EXPECT_TRUE(said(view).contains("Clearly sharper than the result: candidate: pair 54")) << said(view).toStdString();
  view.show_sharpness({{calibration::MountingSource::Result, {-2.466, 0.0175, 90}},
                       {calibration::MountingSource::pair(motion::PairIndex{54}), {-2.472, 0.0100, 90}}});
  EXPECT_TRUE(said(view).contains("Fewer than 200 places")) << said(view).toStdString();
  view.show_message("nothing");
  EXPECT_FALSE(said(view).contains("Fewer than"));
}

TEST(status_words, an_inconsistent_result_gives_its_own_reason_and_no_other) {
  for (const char* reason :
       {"The clocks of LiDAR and INS are apart: scans were compared with the motion of another instant.",
        "The INS contradicts itself: a column of its log is not what it is taken for."}) {
    calibration::CalibrationResult result;
    result.status = calibration::Status::Inconsistent;
    result.message = Message::verbatim(reason);
    EXPECT_FALSE(status_title(result).contains("pairs")) << status_title(result).toStdString();
    EXPECT_TRUE(result_as_text(result).contains(reason)) << result_as_text(result).toStdString();
  }
}

TEST(status_words, each_failure_has_a_title_of_its_own_and_its_reason_is_copied) {
  QStringList titles;
  for (const calibration::Status status :
       {calibration::Status::TooFewPairs, calibration::Status::TooLittleData, calibration::Status::NoUsableData,
        calibration::Status::NotConverged, calibration::Status::OutOfRange, calibration::Status::Inconsistent,
        calibration::Status::Cancelled}) {
    calibration::CalibrationResult result;
    result.conclude(status, Message::verbatim("for this reason"));
    titles << status_title(result);
    EXPECT_TRUE(result_as_text(result).contains("for this reason")) << result_as_text(result).toStdString();
    EXPECT_NE(render(results::status_word(status), Language::Chinese), english(results::status_word(status)));
    EXPECT_EQ(english(results::status_word(status)), to_string(status));
  }
  EXPECT_EQ(titles.removeDuplicates(), 0) << titles.join("; ").toStdString();
}

TEST(hold_out_words, explain_the_dash_once) {
  HoldOutView view;
  view.show_hold_out(testing::sample_hold_out(3), {"monday", "tuesday", "friday"});
  EXPECT_TRUE(said(view).contains("–: no number")) << said(view).toStdString();
  EXPECT_EQ(said(view).count("tuesday alone does not observe z."), 1) << said(view).toStdString();
  pipeline::HoldOut nothing = testing::sample_hold_out(2);
  for (pipeline::SessionAlone& alone : nothing.sessions)
    alone.result.set_observed({}, Message::verbatim("not shown by this drive"));
  for (pipeline::SessionDifference& difference : nothing.differences)
    difference.sigma.fill(std::numeric_limits<double>::quiet_NaN());
  view.show_hold_out(nothing, {"monday", "friday"});
  EXPECT_TRUE(said(view).contains("No two of them observe the same parameter")) << said(view).toStdString();
  pipeline::HoldOut all = testing::sample_hold_out(2);
  for (pipeline::SessionAlone& alone : all.sessions) alone.result.set_observed(calibration::ParameterSet::all(), {});
  view.show_hold_out(all, {"monday", "friday"});
  EXPECT_FALSE(said(view).contains("–: ")) << "where there is no dash there is nothing to explain";
}

TEST(clearance_words, explain_a_dash_where_there_is_one) {
  VehicleScan scan;
  const auto show = [&scan](ClearanceView& view) {
    scan.before = scan.after;
    view.show_scan("scan", std::make_shared<const MeasuredScan>(measure_scan(scan, view.box())));
  };
  ClearanceView view;
  scan.after = {{8.0F, 0.0F, 0.5F}};
  show(view);
  EXPECT_TRUE(said(view).contains("–: no point")) << said(view).toStdString();
  scan.after = {{8.0F, 0.0F, 0.5F}, {-8.0F, 0.0F, 0.5F}, {0.0F, 5.0F, 0.5F}, {0.0F, -5.0F, 0.5F}};
  show(view);
  EXPECT_FALSE(said(view).contains("–: no point"));
}

TEST(choices, have_words_in_every_language_and_keys_in_files_only) {
  const testing::LanguageFor as_before;
  for (const QString language : {"en", "zh_CN"}) {
    gui::speak(language, false);
    for (const OptionField& field : option_fields(settings::Settings{}))
      for (const QString& key : field.choices) {
        const QString words = choice_words(field, key);
        EXPECT_NE(words, key) << field.section.toStdString() << '.' << field.name.toStdString();
        if (language == QLatin1String("en")) continue;
        gui::speak("en", false);
        const QString english = choice_words(field, key);
        gui::speak(language, false);
        EXPECT_TRUE(words != english || english.contains("PCL")) << english.toStdString();
      }
  }
  gui::speak("en", false);
  const OptionForm form("run", settings::Settings{});
  const auto* method = form.findChild<QComboBox*>("run.method");
  ASSERT_TRUE(method);
  EXPECT_EQ(method->itemText(0), "Pairs of keyframes") << "as in Set-up";
  EXPECT_TRUE(method->itemData(0, Qt::ToolTipRole).toString().contains("pairwise"));
}

class plain_words : public testing::WindowFixture {};

TEST_F(plain_words, the_result_says_what_x_is_and_keeps_its_jargon_for_tool_tips) {
  calibrate_drive();
  const auto& result = child<ResultPanel>();
  EXPECT_TRUE(said(result).contains("X: LiDAR in INS")) << said(result).toStdString();
  bool explained = false;
  for (const QLabel* label : result.findChildren<QLabel*>())
    explained |= label->toolTip().startsWith("X is the mounting");
  EXPECT_TRUE(explained);
  EXPECT_FALSE(said(result).contains("Frobenius")) << said(result).toStdString();
  const PairTableModel model;
  EXPECT_FALSE(model.headerData(PairTableModel::Screw, Qt::Horizontal, Qt::DisplayRole).toString().contains("Screw"));
  EXPECT_TRUE(
      model.headerData(PairTableModel::Screw, Qt::Horizontal, Qt::ToolTipRole).toString().contains("screw test"));
}

TEST_F(plain_words, a_result_that_is_not_the_first_candidate_says_why) {
  calibrate_drive();
  auto& panel = child<CandidatesPanel>();
  pipeline::PipelineOutput output = *workbench_.outcome().output();
  ASSERT_GE(output.result.candidates.size(), 3U);
  for (calibration::Candidate& candidate : output.result.candidates) candidate.ins_from_lidar.translation().x() += 0.1;
  output.result.candidates[2].ins_from_lidar = output.result.mounting.reference_from_sensor;
  panel.show_output(std::make_shared<const pipeline::PipelineOutput>(output));
  EXPECT_TRUE(said(panel).contains("The result has rank 3")) << said(panel).toStdString();
  EXPECT_EQ(panel.attitude()->title(0), "pitch over yaw [°]");
}

TEST_F(plain_words, an_edit_of_an_option_is_called_as_the_form_calls_it) {
  workbench_.setup().edit_option("pairing", "max_gap_s", 3.0);
  EXPECT_EQ(workbench_.history().stack().undoText(), "change Max gap");
}

TEST_F(plain_words, a_drive_says_what_the_colours_of_its_fix_mean) {
  window_.open_paths({"/data/drive1"});
  ASSERT_TRUE(settle());
  auto& timeline = child<DriveTimeline>();
  overview::DriveOverview drive;
  drive.duration_s = 10.0;
  drive.stretches = {{0.0, motion::InsQuality::Unknown, 0.05, 0.01, 3.0},
                     {5.0, motion::InsQuality::Good, 0.05, 0.01, 3.0}};
  timeline.show_drive(std::make_shared<const overview::DriveOverview>(drive));
  EXPECT_TRUE(timeline.quality_legend().contains("not stated")) << timeline.quality_legend().toStdString();
  EXPECT_TRUE(timeline.quality_legend().contains("good"));
  EXPECT_FALSE(timeline.quality_legend().contains("degraded")) << "none of it is";
}

TEST_F(plain_words, while_calibrating_only_the_step_that_runs_says_so) {
  window_.open_paths({"/data/drive1"});
  ASSERT_TRUE(settle());
  *hold_at_ = 5;
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return workbench_.activity().stage() == say::stage_registering_pairs(); }, kPatience_ms));
  const auto steps = gui::describe_steps(workbench_);
  EXPECT_EQ(steps[static_cast<std::size_t>(Step::Pairs)].state, StepState::Done);
  EXPECT_EQ(steps[static_cast<std::size_t>(Step::Align)].state, StepState::Running);
  EXPECT_EQ(steps[static_cast<std::size_t>(Step::Align)].detail, "registering pairs");
  for (const Step later : {Step::Review, Step::Solve, Step::Check, Step::Export})
    EXPECT_EQ(steps[static_cast<std::size_t>(later)].state, StepState::Waiting);
  EXPECT_TRUE(gui::next_hint(workbench_).contains("when all of it is done"))
      << gui::next_hint(workbench_).toStdString();
  *hold_at_ = -1;
  EXPECT_TRUE(settle());
}

}  // namespace
}  // namespace remount::widgets
