#include "widgets/vehicle/lidars_panel.h"

#include <gtest/gtest.h>

#include <QHeaderView>
#include <QTabWidget>
#include <QTableView>
#include <QTextBrowser>

#include "model/pipeline/pipeline.h"
#include "model/results/vehicle_file.h"

namespace remount::widgets {
namespace {

/// Four LiDARs whose numbers are as long as they become.
std::vector<LidarEntry> four_lidars() {
  const auto output = std::make_shared<pipeline::PipelineOutput>();
  calibration::CalibrationResult& result = output->result;
  result.status = calibration::Status::Ok;
  result.set_observed(calibration::ParameterSet::all(), {});
  result.covariance = Matrix6d::Identity() * 4e-6;
  result.mounting.reference_from_sensor = rigid_from_six({-1.6, -0.1, 0.8, 3.1, -0.07, -0.02});
  std::vector<LidarEntry> lidars;
  for (const char* name : {"top", "left", "front", "rear"}) {
    LidarEntry& lidar = lidars.emplace_back();
    lidar.name = name;
    lidar.standing = LidarEntry::Standing::Together;
    lidar.output = output;
  }
  return lidars;
}

TEST(lidars_panel, marks_lidars_that_contradict_each_other) {
  LidarsPanel panel;
  std::vector<LidarEntry> lidars = four_lidars();
  lidars[3].problem = "what it and left saw";
  panel.show_lidars(lidars);
  const auto state = [&](int row, int role) { return panel.model()->index(row, LidarTableModel::State).data(role); };
  EXPECT_EQ(state(0, Qt::DisplayRole).toString(), "Solved, with the others");
  EXPECT_EQ(state(3, Qt::DisplayRole).toString(), "✕ contradicts: Solved");
  EXPECT_NE(state(3, Qt::ForegroundRole), state(0, Qt::ForegroundRole));
  EXPECT_EQ(state(3, Qt::ToolTipRole).toString(), "what it and left saw");
  lidars[0].standing = LidarEntry::Standing::Alone;
  panel.show_lidars(lidars);
  EXPECT_TRUE(state(0, Qt::ToolTipRole).toString().contains("not been solved together"));
  const auto file = std::make_shared<results::VehicleFile>();
  VehicleVerdict verdict;
  verdict.file = file;
  panel.show_verdict(verdict);
  EXPECT_EQ(panel.pages()->tabText(2), "Against each other");
  file->findings = {{drive::Severity::Note, "a-note", std::string("top"), Message::verbatim("a note")},
                    {drive::Severity::Problem, "lidars-contradict", std::string("rear"), Message::verbatim("apart")}};
  panel.show_verdict(verdict);
  EXPECT_EQ(panel.pages()->tabText(2), "✕ Against each other");
  const QString words = static_cast<QTextBrowser*>(panel.pages()->widget(2))->toPlainText();
  EXPECT_TRUE(words.contains("✕ rear: apart")) << words.toStdString();
  EXPECT_LT(words.indexOf("rear: apart"), words.indexOf("top: a note")) << "the gravest first";
}

TEST(lidars_panel, has_room_for_all_numbers_beside_the_other_panels) {
  LidarsPanel panel;
  panel.show_lidars(four_lidars());
  panel.table()->resizeColumnsToContents();
  const int needed = panel.table()->horizontalHeader()->length(), line = panel.table()->rowHeight(0);
  std::printf("  four LiDARs need %d px, a row %d px\n", needed, line);
  EXPECT_LE(needed, 735) << "what the panel has in a window of 1440 px";
  EXPECT_GE(line, 2 * panel.table()->fontMetrics().lineSpacing());
}

}  // namespace
}  // namespace remount::widgets
