// Forms, panels and the chart, each on its own.
#include <gtest/gtest.h>

#include <QAction>
#include <QDoubleSpinBox>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>
#include <numeric>

#include "messages/stages.h"
#include "tests/widgets/support/sample_world.h"
#include "widgets/forms/option_form.h"
#include "widgets/pairs/error_bar_chart.h"
#include "widgets/result/nominal_panel.h"
#include "widgets/result/range_panel.h"
#include "widgets/result/result_panel.h"
#include "widgets/shell/progress_strip.h"

namespace remount::widgets {
namespace {

TEST(tooltips, of_a_pose_show_its_axes) {
  NominalPanel panel;
  const auto spins = panel.findChildren<QDoubleSpinBox*>();
  ASSERT_EQ(spins.size(), 6);
  for (const QDoubleSpinBox* spin : spins) {
    const QString tip = spin->toolTip();
    EXPECT_TRUE(tip.contains("x forward, y left, z up")) << tip.left(200).toStdString();
    const qsizetype begin = tip.indexOf("base64,") + 7;
    const QByteArray png = QByteArray::fromBase64(tip.mid(begin, tip.indexOf('"', begin) - begin).toLatin1());
    const QImage picture = QImage::fromData(png, "PNG");
    ASSERT_FALSE(picture.isNull());
    int drawn = 0;
    for (int x = 0; x < picture.width(); ++x) drawn += picture.pixelColor(x, picture.height() / 2).alpha() > 0;
    EXPECT_GT(drawn, 4);
    EXPECT_FALSE(spin->accessibleDescription().contains('<')) << "a screen reader reads words";
  }
}

TEST(option_access, every_option_can_be_read_and_set) {
  const settings::Settings defaults;
  for (const OptionField& field : option_fields(defaults)) {
    settings::Settings changed;
    QVariant other = field.value;
    if (field.kind == OptionKind::Switch) other = !field.value.toBool();
    if (field.kind == OptionKind::Integer)
      other =
          field.value.toInt() == static_cast<int>(field.maximum) ? field.value.toInt() - 1 : field.value.toInt() + 1;
    if (field.kind == OptionKind::Real) other = 0.5 * (field.minimum + field.maximum) + 0.001;
    if (field.kind == OptionKind::Text) other = "another";
    if (field.kind == OptionKind::Choice) other = field.value.toInt() == 0 ? 1 : 0;
    ASSERT_TRUE(set_option(changed, field.section, field.name, other)) << field.name.toStdString();
    int differing = 0;
    const auto before = option_fields(defaults), after = option_fields(changed);
    for (std::size_t i = 0; i < before.size(); ++i) differing += before[i].value != after[i].value;
    EXPECT_EQ(differing, 1) << field.section.toStdString() << "." << field.name.toStdString();
  }
  settings::Settings settings;
  EXPECT_FALSE(set_option(settings, "run", "no_such_option", 1));
}

TEST(option_form, shows_a_value_without_sending_it_back) {
  settings::Settings settings;
  OptionForm form("pairing", settings);
  QSignalSpy edited(&form, &OptionForm::edited);
  settings.pairing.max_gap_s = 2.5;
  form.show_settings(settings);
  EXPECT_EQ(edited.count(), 0);
  auto* spin = form.findChild<QDoubleSpinBox*>("pairing.max_gap_s");
  ASSERT_TRUE(spin);
  EXPECT_DOUBLE_EQ(spin->value(), 2.5);
  spin->setValue(3.0);
  ASSERT_EQ(edited.count(), 1);
  EXPECT_EQ(edited[0][1].toString(), "max_gap_s");
  EXPECT_DOUBLE_EQ(edited[0][2].toDouble(), 3.0);
}

TEST(option_form, a_file_is_typed_or_looked_for) {
  settings::Settings settings;
  OptionForm form("beams", settings);
  QSignalSpy edited(&form, &OptionForm::edited);
  settings.beams.file = "/known/beams.yaml";
  form.show_settings(settings);
  auto* line = form.findChild<QLineEdit*>("beams.file");
  ASSERT_TRUE(line);
  EXPECT_EQ(line->text(), "/known/beams.yaml");
  EXPECT_EQ(edited.count(), 0);
  line->clear();
  QTest::keyClicks(line, "/a.yaml");
  QTest::keyClick(line, Qt::Key_Return);
  ASSERT_EQ(edited.count(), 1);
  EXPECT_EQ(edited[0][1].toString(), "file");
  EXPECT_EQ(edited[0][2].toString(), "/a.yaml");
  const QList<QAction*> offered = line->actions();
  ASSERT_EQ(offered.size(), 1);
  EXPECT_FALSE(offered[0]->text().isEmpty());
}

TEST(option_form, no_default_is_rounded_away) {
  const settings::Settings settings;
  for (const OptionField& field : option_fields(settings)) {
    if (field.kind != OptionKind::Real) continue;
    OptionForm form(field.section, settings);
    EXPECT_DOUBLE_EQ(form.findChild<QDoubleSpinBox*>(field.section + '.' + field.name)->value(),
                     on_screen(field, field.value.toDouble()))
        << field.name.toStdString();
  }
}

TEST(option_form, labels_spell_abbreviations_as_people_do) {
  const settings::Settings settings;
  EXPECT_EQ(option_label(settings, "fusion", "imu_yaw_deg"), "IMU yaw");
  EXPECT_EQ(option_label(settings, "measured", "ins_height_m"), "INS height");
  EXPECT_EQ(option_label(settings, "registration", "max_rmse_m"), "Max RMSE");
  EXPECT_EQ(option_label(settings, "objects", "min_points"), "Min points") << "no letters within a word";
  for (const OptionField& field : option_fields(settings::Settings{}))
    for (const char* wrong : {"Imu", "Ins", "Gnss", "Lidar", "rmse", "imu", "gnss"})
      EXPECT_FALSE(option_label(field).split(' ').contains(QLatin1String(wrong))) << option_label(field).toStdString();
}

TEST(range_panel, shows_degrees_and_sends_radians) {
  RangePanel panel;
  QSignalSpy edited(&panel, &RangePanel::edited);
  auto* spin = panel.findChild<QDoubleSpinBox*>("range.yaw_min_rad");
  ASSERT_TRUE(spin);
  spin->setValue(-90.0);
  ASSERT_EQ(edited.count(), 1);
  EXPECT_EQ(edited[0][1].toString(), "yaw_min_rad");
  EXPECT_NEAR(edited[0][2].toDouble(), -0.5 * kPi, 1e-9);
}

TEST(range_panel, the_default_is_half_a_turn_to_each_side_and_typing_it_is_every_angle) {
  RangePanel panel;
  for (const char* name : {"range.yaw_min_rad", "range.roll_min_rad"})
    EXPECT_EQ(panel.findChild<QDoubleSpinBox*>(name)->text().toStdString(), "-180.00°");
  auto* largest = panel.findChild<QDoubleSpinBox*>("range.yaw_max_rad");
  EXPECT_EQ(largest->text().toStdString(), "180.00°");
  QSignalSpy edited(&panel, &RangePanel::edited);
  largest->setValue(90.0);
  largest->setValue(200.0);
  ASSERT_EQ(edited.count(), 2);
  EXPECT_EQ(edited[1][2].toDouble(), calibration::SearchRange{}.yaw_max_rad) << "no rounding";
}

TEST(range_panel, angles_can_be_shown_and_typed_in_radians) {
  RangePanel panel;
  settings::Settings settings;
  settings.range.yaw_max_rad = 0.5;
  panel.show_settings(settings);
  QSignalSpy edited(&panel, &RangePanel::edited);
  panel.set_angle_unit(AngleUnit::Radians);
  EXPECT_EQ(edited.count(), 0) << "showing is not editing";
  auto* spin = panel.findChild<QDoubleSpinBox*>("range.yaw_max_rad");
  EXPECT_EQ(spin->text().toStdString(), "0.500000 rad");
  EXPECT_TRUE(panel.findChild<QDoubleSpinBox*>("range.x_max_m")->text().endsWith(" m"));
  spin->setValue(0.25);
  ASSERT_EQ(edited.count(), 1);
  EXPECT_DOUBLE_EQ(edited[0][2].toDouble(), 0.25);
  spin->setValue(10.0);
  EXPECT_EQ(edited[1][2].toDouble(), calibration::SearchRange{}.yaw_max_rad)
      << "the most that can be typed is every angle";
  panel.set_angle_unit(AngleUnit::Degrees);
  EXPECT_TRUE(spin->text().endsWith("°")) << spin->text().toStdString();
}

TEST(option_form, options_held_in_degrees_follow_the_unit_too) {
  const settings::Settings settings;
  OptionForm form("solve", settings);
  form.set_angle_unit(AngleUnit::Radians, settings);
  auto* spin = form.findChild<QDoubleSpinBox*>("solve.max_rotation_sigma_deg");
  EXPECT_TRUE(spin->text().endsWith(" rad")) << spin->text().toStdString();
  EXPECT_NEAR(spin->value(), degrees_to_radians(settings.solve.max_rotation_sigma_deg), 1e-6);
  QSignalSpy edited(&form, &OptionForm::edited);
  spin->setValue(0.01);
  ASSERT_EQ(edited.count(), 1);
  EXPECT_NEAR(edited[0][2].toDouble(), radians_to_degrees(0.01), 1e-9);
}

TEST(option_form, angles_are_shown_in_degrees_and_sent_in_radians) {
  OptionForm form("range", settings::Settings{});
  QSignalSpy edited(&form, &OptionForm::edited);
  auto* spin = form.findChild<QDoubleSpinBox*>("range.pitch_max_rad");
  EXPECT_TRUE(spin->text().startsWith("180.0") && spin->text().endsWith("°")) << spin->text().toStdString();
  spin->setValue(90.0);
  spin->setValue(180.0);
  ASSERT_EQ(edited.count(), 2);
  EXPECT_NEAR(edited[0][2].toDouble(), 0.5 * kPi, 1e-12);
  EXPECT_EQ(edited[1][2].toDouble(), kPi);
}

TEST(nominal_panel, sends_what_it_shows_and_unknown_as_nothing) {
  NominalPanel panel;
  std::vector<std::optional<RigidTransform>> sent;
  QObject::connect(&panel, &NominalPanel::nominal_edited, [&](const auto& nominal) { sent.push_back(nominal); });
  const RigidTransform shown =
      rigid_from_six({1.2, -0.3, 0.5, degrees_to_radians(-90.0), degrees_to_radians(2.0), degrees_to_radians(1.0)});
  panel.show_nominal(shown);
  EXPECT_TRUE(sent.empty());
  panel.findChild<QDoubleSpinBox*>("nominal.x")->setValue(1.3);
  ASSERT_EQ(sent.size(), 1U);
  ASSERT_TRUE(sent[0]);
  EXPECT_LT(rotation_angle_between_rad(*sent[0], shown), 1e-9);
  EXPECT_NEAR(sent[0]->translation().x(), 1.3, 1e-12);
  panel.findChildren<QRadioButton*>().at(0)->click();
  ASSERT_EQ(sent.size(), 2U);
  EXPECT_FALSE(sent[1]);
}

TEST(error_bar_chart, a_click_finds_its_pair_and_the_arrows_the_next) {
  pipeline::PipelineInput input;
  input.sessions = {std::make_shared<const drive::Session>(testing::sample_session("drive1"))};
  ErrorBarChart chart;
  chart.resize(600, 200);
  chart.show_output(std::make_shared<const pipeline::PipelineOutput>(testing::sample_output(input, 50)));
  std::vector<motion::PairIndex> pairs(50);
  std::iota(pairs.begin(), pairs.end(), motion::PairIndex{0});
  chart.show_pairs(pairs);
  QSignalSpy clicked(&chart, &ErrorBarChart::pair_clicked);
  int last = -1;
  for (int x = 0; x < 600; ++x) {
    const int pair = qt_row(chart.pair_at({x, 100}));
    if (pair < 0) continue;
    EXPECT_TRUE(pair == last || pair == last + 1) << "at " << x << ": " << pair << " after " << last;
    last = pair;
  }
  EXPECT_EQ(last, 49);
  chart.show_selected(motion::PairIndex{20});
  QTest::keyClick(&chart, Qt::Key_Right);
  QTest::keyClick(&chart, Qt::Key_Left);
  ASSERT_EQ(clicked.count(), 2);
  EXPECT_EQ(clicked[0][0].value<motion::PairIndex>(), motion::PairIndex{21});
  EXPECT_EQ(clicked[1][0].value<motion::PairIndex>(), motion::PairIndex{19});
  chart.grab();  // paints
}

TEST(result_panel, never_prints_a_sigma_for_what_is_not_observed) {
  calibration::CalibrationResult result;
  result.status = calibration::Status::Degenerate;
  result.set_observed(~calibration::ParameterSet{calibration::Parameter::Z},
                      Message::verbatim("not shown by this drive"));
  result.covariance.setIdentity();
  result.covariance *= 1e-6;
  const QStringList lines = result_as_text(result).split('\n');
  ASSERT_EQ(lines.size(), 8);
  EXPECT_TRUE(lines[2].startsWith("x = ") && lines[2].contains("±")) << lines[2].toStdString();
  EXPECT_TRUE(lines[4].startsWith("z = ") && !lines[4].contains("±")) << lines[4].toStdString();
}

TEST(result_panel, tells_what_was_measured_by_hand_and_that_sessions_disagree) {
  pipeline::PipelineOutput output;
  output.result.status = calibration::Status::Ok;
  output.result.set_observed(calibration::ParameterSet::all(), {});
  output.result.covariance = 1e-4 * Matrix6d::Identity();
  const auto texts = [&] {
    ResultPanel panel;
    panel.show_output(std::make_shared<const pipeline::PipelineOutput>(output), nullptr);
    QStringList all;
    for (const QLabel* label : panel.findChildren<QLabel*>()) all << label->text();
    return all;
  };
  EXPECT_TRUE(texts().filter("*").isEmpty() && texts().filter("scatter").isEmpty());
  output.result.known[calibration::Parameter::Z].measured = true;
  output.result.session_disagreement = 1.4;
  EXPECT_EQ(texts().filter("± 0.0100 m *").size(), 1) << "z";
  EXPECT_EQ(texts().filter("* with a value measured by hand").size(), 1);
  EXPECT_EQ(texts().filter("The sessions scatter 1.4 times as much").size(), 1);
  output.result.status = calibration::Status::Degenerate;
  output.result.set_observed({}, Message::verbatim("not shown by this drive"));
  EXPECT_TRUE(texts().filter("scatter").isEmpty()) << "nothing is known";
}

TEST(result_panel, says_what_was_calibrated_and_in_which_frame) {
  pipeline::PipelineOutput output;
  output.result.status = calibration::Status::Degenerate;
  ResultPanel panel;
  const auto says = [&](calibration::BodyFrame reference, calibration::BodyFrame sensor, const QString& title) {
    output.result.mounting.reference = reference;
    output.result.mounting.sensor = sensor;
    panel.show_output(std::make_shared<const pipeline::PipelineOutput>(output), nullptr);
    const auto labels = panel.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) { return label->text() == title; });
  };
  EXPECT_TRUE(says(calibration::BodyFrame::Vehicle, calibration::BodyFrame::Antenna, "X: antenna in vehicle"));
  EXPECT_TRUE(says(calibration::BodyFrame::Vehicle, calibration::BodyFrame::Lidar, "X: sensor in vehicle"));
  EXPECT_TRUE(says(calibration::BodyFrame::Machine, calibration::BodyFrame::Lidar, "X: LiDAR in machine"));
  EXPECT_TRUE(says(calibration::BodyFrame::Antenna, calibration::BodyFrame::Lidar, "X: LiDAR from antenna"));
  EXPECT_TRUE(says(calibration::BodyFrame::Ins, calibration::BodyFrame::Lidar, "X: LiDAR in INS"));
}

TEST(result_panel, a_clock_offset_is_left_out_and_taken_in_by_one_click) {
  pipeline::PipelineOutput output;
  output.result.status = calibration::Status::Ok;
  output.result.set_observed(calibration::ParameterSet::all(), {});
  output.result.covariance = 1e-4 * Matrix6d::Identity();
  ResultPanel panel;
  const auto button = [&]() -> QPushButton* {
    for (QPushButton* one : panel.findChildren<QPushButton*>())
      if (one->text().contains("clock offset")) return one;
    return nullptr;
  };
  const auto show = [&](double offset_s, bool applied) {
    output.result.time_offset = {offset_s, 1e-4, applied};
    output.result.session_time_offset_s = {offset_s};
    output.result.session_time_offset_sigma_s = {1e-4};
    panel.show_output(std::make_shared<const pipeline::PipelineOutput>(output), nullptr);
  };
  QSignalSpy asked(&panel, &ResultPanel::clock_offset_asked);
  show(0.0001, false);
  ASSERT_NE(button(), nullptr);
  EXPECT_TRUE(button()->isHidden()) << "the clocks agree";
  show(0.03, true);
  ASSERT_FALSE(button()->isHidden());
  button()->click();
  show(0.03, false);
  ASSERT_FALSE(button()->isHidden());
  button()->click();
  ASSERT_EQ(asked.count(), 2);
  EXPECT_FALSE(asked[0][0].toBool()) << "without";
  EXPECT_TRUE(asked[1][0].toBool()) << "with";
}

TEST(progress_strip, says_how_long_so_that_it_is_seen_to_count_down) {
  EXPECT_EQ(remaining_text(0.6), "about 1 s left in this step");
  EXPECT_EQ(remaining_text(70.0), "about 70 s left in this step");
  EXPECT_EQ(remaining_text(158.0), "about 2 min 30 s left in this step");
}

TEST(progress_strip, counts_down_while_steps_come_evenly_and_says_nothing_while_none_comes) {
  ProgressStrip strip;
  strip.start("Calibrating");
  const auto seconds_left = [&] {
    static const QRegularExpression number("about (\\d+) s left");
    for (const QLabel* label : strip.findChildren<QLabel*>())
      if (const auto match = number.match(label->text()); match.hasMatch()) return match.captured(1).toInt();
    return 0;
  };
  int last_s = 1000, lower = 0;
  for (qulonglong done = 0; done < 80; ++done) {
    strip.show_progress(say::stage_registering_pairs(), done, 200);
    QTest::qWait(100);
    const int left_s = seconds_left();
    if (left_s == 0) continue;
    EXPECT_LE(left_s, last_s);
    lower += left_s < last_s ? 1 : 0;
    last_s = left_s;
  }
  EXPECT_GE(lower, 3) << "counted down to " << last_s << " s";
  EXPECT_TRUE(QTest::qWaitFor([&] { return seconds_left() == 0; }, 15000)) << "nothing comes any more";
}

}  // namespace
}  // namespace remount::widgets
