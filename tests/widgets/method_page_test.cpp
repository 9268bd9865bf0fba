// The page of the methods: the chooser, figures and plots, ways in space, results compared.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableWidget>
#include <QToolButton>

#include "messages/parameters.h"
#include "messages/plots.h"
#include "messages/quantities.h"
#include "model/report/plot_chart.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/basics/gl_support.h"
#include "widgets/charts/plot_view.h"
#include "widgets/map/path_view.h"
#include "widgets/methods/method_view.h"
#include "widgets/result/comparison_view.h"
#include "widgets/result/verdict_table.h"

namespace remount::widgets {
namespace {

using testing::kPatience_ms;

/// A rising half circle, another that drifts off it, and fixes; far from the origin, as coordinates of a country are.
calibration::Plot trajectory() {
  calibration::Plot plot{
      say::plot_trajectory_before_and_after(), say::plot_axis_east(), say::plot_axis_north(), true, {}};
  calibration::Curve before{say::plot_curve_laid_odometry(), {}, {}, {}, false, {}},
      after{say::plot_curve_aligned(), {}, {}, {}, false, {}},
      fixes{say::plot_curve_gnss_fixes(), {}, {}, {}, true, {}};
  for (int i = 0; i <= 100; ++i) {
    const double angle = 0.01 * kPi * i, x = 4e5 + 50.0 * std::cos(angle), y = 3e6 + 50.0 * std::sin(angle);
    for (calibration::Curve* curve : {&before, &after, &fixes}) {
      curve->x.push_back(x);
      curve->y.push_back(curve == &before ? y - 0.1 * i : y);
      curve->z.push_back(0.05 * i);
    }
  }
  plot.curves = {before, after, fixes};
  return plot;
}

/// Around the pixels of a colour.
QRect place_of_color(const QImage& image, const QColor& color) {
  const auto near = [](int a, int b) { return std::abs(a - b) < 12; };
  QRect place;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QColor pixel = image.pixelColor(x, y);
      if (near(pixel.red(), color.red()) && near(pixel.green(), color.green()) && near(pixel.blue(), color.blue()))
        place |= QRect(x, y, 1, 1);
    }
  return place;
}

class method_page : public testing::WindowFixture {
 protected:
  method_page() : testing::WindowFixture(2) {}
  /// As after a calibration by the method.
  void take_result_of(const std::string& method, bool in_space) {
    pipeline::PipelineOutput output = *workbench_.outcome().output();
    output.method = method;
    output.pairs.clear();
    output.keyframes.clear();
    output.quantities = {{"scale", say::quantity_scale(), 1.0042, 0.0003, "", true},
                         {"slew radius", say::quantity_slew_radius(), 2.5, 0.01, "m", false}};
    output.plots = {trajectory(),
                    {say::plot_height_along_the_way(),
                     say::plot_axis_way(),
                     say::plot_axis_z(),
                     false,
                     {{say::parameter_z(), {0, 1}, {0, 1}, {}, false, {}}}}};
    if (!in_space)
      for (calibration::Curve& curve : output.plots[0].curves) curve.z.clear();
    output.result.mounting.reference_from_sensor.translation().x() += 1.0;
    project::Project project;
    project.basis.session_count = 1;
    workbench_.document().restore(workbench_.sessions().all(), project,
                                  std::make_shared<const pipeline::PipelineOutput>(output));
    window_.show_everything();
  }
  QTabWidget& pages() { return *qobject_cast<QTabWidget*>(child<PathView>().parentWidget()->parentWidget()); }
  QString said(const QWidget& widget) {
    QStringList texts;
    for (const QLabel* label : widget.findChildren<QLabel*>())
      if (!label->isHidden()) texts << label->text();
    return texts.join('\n');
  }
};

TEST_F(method_page, the_chooser_edits_the_settings_and_follows_them) {
  QComboBox* chooser = nullptr;
  for (auto* box : window_.findChildren<QComboBox*>())
    if (box->accessibleName() == "Method") chooser = box;
  ASSERT_TRUE(chooser);
  EXPECT_EQ(chooser->count(), 5);
  emit chooser->activated(1);
  EXPECT_EQ(workbench_.setup().settings().run.method, method_registry::MethodChoice("trajectory"));
  workbench_.history().stack().undo();
  EXPECT_EQ(chooser->currentIndex(), 0);
  EXPECT_TRUE(chooser->toolTip().startsWith("Needs: ")) << chooser->toolTip().toStdString();
}

TEST_F(method_page, shows_figures_plots_and_ways_of_the_method_and_compares_its_result) {
  show();
  calibrate_drive();
  trigger("Ctrl+Shift+D");
  EXPECT_EQ(child<PathView>().plot_count(), 0) << "pairs have views of their own";
  EXPECT_TRUE(said(child<PathView>()).contains("\"Pair\"") || !child<PathView>().has_gl());
  take_result_of("trajectory", true);
  EXPECT_TRUE(said(child<MethodView>()).contains("Trajectory")) << said(child<MethodView>()).toStdString();
  auto& figures = *child<MethodView>().findChild<FigureTable*>();
  ASSERT_EQ(figures.rowCount(), 2);
  EXPECT_EQ(figures.item(0, 1)->text(), "1.0042 ± 0.0003");
  EXPECT_TRUE(figures.item(1, 1)->text().contains("not observed"));
  EXPECT_TRUE(child<PlotView>().accessibleDescription().contains("Height along the way"));
  EXPECT_EQ(child<PathView>().plot_count(), 1) << "one of the two has heights";
  const auto& comparison = child<ComparisonView>();
  EXPECT_EQ(comparison.findChild<FigureTable*>()->rowCount(), 2) << "pairs, and the trajectory a metre beside";
  EXPECT_TRUE(comparison.findChild<VerdictLabel*>()->text().contains("differ by more than they claim"));
  photograph(window_, "30-method");
  take_result_of("slew", false);
  EXPECT_EQ(child<PathView>().plot_count(), 0);
}

TEST_F(method_page, a_way_is_drawn_in_space_and_a_click_tells_its_points) {
  if (!missing_gl_reason().isEmpty())
    GTEST_SKIP() << "needs a display with OpenGL: " << missing_gl_reason().toStdString();
  show();
  calibrate_drive();
  trigger("Ctrl+Shift+D");
  auto& view = child<PathView>();
  pages().setCurrentWidget(&view);
  take_result_of("trajectory", true);
  ASSERT_TRUE(view.shows_scene());
  QTest::qWait(100);
  view.look(scene::StandardView::Top);
  const QImage top = view.canvas()->grab().toImage();
  const QRect before = place_of_color(top, QColor(QString::fromLatin1(report::curve_color(0))));
  const calibration::Plot plot = trajectory();
  const Eigen::Vector3d first(plot.curves[0].x[0], plot.curves[0].y[0], plot.curves[0].z[0]);
  const auto place = [&](std::size_t point) {
    const calibration::Curve& after = plot.curves[1];
    return view.place_of(Eigen::Vector3d(after.x[point], after.y[point], after.z[point]) - first);
  };
  for (const std::size_t point : {0U, 50U, 100U})
    EXPECT_TRUE(QRectF(view.canvas()->rect()).contains(place(point))) << "the whole way is framed: " << point;
  EXPECT_GT(before.width(), top.height() / 4) << "of " << top.height() << ": the drifting way is drawn";
  EXPECT_GT(before.height(), top.height() / 8) << "of " << top.height();
  EXPECT_GT(place(0).x(), place(100).x()) << "as in the flat plot, x runs to the right";
  EXPECT_LT(place(50).y(), place(0).y()) << "and y up";
  for (const QToolButton* button : view.findChildren<QToolButton*>())
    EXPECT_NE(button->text(), "Shading") << "lines are not shaded";
  view.click(place(50));
  EXPECT_TRUE(view.readout().contains("y 3000050.000, z 2.500 m")) << view.readout().toStdString();
  EXPECT_TRUE(view.readout().contains("aligned") || view.readout().contains("GNSS fixes"))
      << view.readout().toStdString();
  view.look(scene::StandardView::Left);
  EXPECT_NE(view.canvas()->grab().toImage(), top);
  EXPECT_TRUE(said(view).contains("GNSS&nbsp;fixes") || said(view).contains("GNSS fixes"));
  photograph(window_, "31-method-in-space");
}

}  // namespace
}  // namespace remount::widgets
