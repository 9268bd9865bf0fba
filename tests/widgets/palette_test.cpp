// A desktop that turns dark, or light, while the program runs.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QLabel>
#include <QTextBlock>
#include <QToolButton>

#include "tests/widgets/support/restored.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/basics/gl_support.h"
#include "widgets/basics/theme.h"
#include "widgets/pairs/pair_view.h"
#include "widgets/shell/log_panel.h"

namespace remount::widgets {
namespace {

using testing::kPatience_ms;

/// A window with a calibrated drive.
struct Calibrated {
  gui::Workbench workbench{testing::sample_engine()};
  gui::MainWindow window{workbench, gui::all_features()};

  Calibrated() {
    window.resize(1280, 900);
    window.show();
    window.open_paths({"/data/drive1"});
    settle();
    workbench.calibrations().calibrate();
    settle();
    window.show_everything();
    // Buttons of the view can be pressed once there is a scene.
    const auto* measure = window.findChild<PairView*>()->findChild<QToolButton*>("measure");
    if (missing_gl_reason().isEmpty()) (void)QTest::qWaitFor([&] { return measure->isEnabled(); }, kPatience_ms);
  }
  void settle() {
    (void)QTest::qWaitFor(
        [&] {
          return !workbench.activity().opening() && !workbench.activity().calibrating() &&
                 !workbench.activity().solving();
        },
        kPatience_ms);
  }
};

QString named(const QWidget& widget) {
  QStringList names;
  for (const QWidget* above = &widget; above; above = above->parentWidget())
    names.prepend(QLatin1String(above->metaObject()->className()) + ' ' + above->objectName());
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) names << button->text();
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) names << label->text().left(40);
  return names.join(QStringLiteral(" / "));
}

/// Buttons and labels that look otherwise than the same ones of a window that was made under the present palette.
QStringList left_behind(gui::MainWindow& turned, gui::MainWindow& fresh) {
  QStringList differ;
  int compared = 0;
  const auto compare = [&](const auto& those, const auto& these) {
    EXPECT_EQ(those.size(), these.size());
    for (qsizetype i = 0; i < std::min(those.size(), these.size()); ++i) {
      if (!those[i]->isVisible() || those[i]->size() != these[i]->size()) continue;
      ++compared;
      if (those[i]->grab().toImage() != these[i]->grab().toImage()) differ << named(*those[i]);
    }
  };
  compare(turned.findChildren<QAbstractButton*>(), fresh.findChildren<QAbstractButton*>());
  compare(turned.findChildren<QLabel*>(), fresh.findChildren<QLabel*>());
  EXPECT_GE(compared, 60) << "buttons and labels that are seen";
  return differ;
}

class palette_at_run_time : public ::testing::TestWithParam<bool> {};

TEST_P(palette_at_run_time, leaves_no_button_and_no_label_in_the_old_colours) {
  const QPalette light = QApplication::palette(), dark = testing::dark_palette();
  const testing::PaletteFor before(GetParam() ? light : dark);
  Calibrated turned;
  QTest::qWait(50);
  const testing::PaletteFor after(GetParam() ? dark : light);
  QTest::qWait(50);
  Calibrated fresh;
  QTest::qWait(50);
  if (const QString folder = qEnvironmentVariable("REMOUNT_SCREENSHOT_DIR"); !folder.isEmpty()) {
    turned.window.grab().save(folder + (GetParam() ? "/40-turned-dark.png" : "/40-turned-light.png"));
    fresh.window.grab().save(folder + (GetParam() ? "/40-made-dark.png" : "/40-made-light.png"));
  }
  EXPECT_EQ(is_dark(turned.window.palette()), GetParam());
  const QStringList differ = left_behind(turned.window, fresh.window);
  EXPECT_TRUE(differ.isEmpty()) << differ.size() << " differ:\n" << differ.join('\n').toStdString();
}

TEST(palette_at_run_time_too, lines_of_the_log_follow) {
  LogPanel log;
  log.show();
  log.add(drive::Severity::Note, {}, "note");
  log.add(drive::Severity::Warning, {}, "warning");
  const testing::PaletteFor dark(testing::dark_palette());
  QTest::qWait(20);
  ASSERT_TRUE(is_dark(log.palette()));
  const auto format_of = [&](const QTextBlock& block) { return block.begin().fragment().charFormat(); };
  EXPECT_FALSE(format_of(log.document()->firstBlock()).hasProperty(QTextFormat::ForegroundBrush))
      << "notes are in the colour of all text";
  EXPECT_EQ(format_of(log.document()->lastBlock()).foreground().color(), warning_color(log.palette()));
}

TEST(palette_at_run_time_too, styles_are_made_anew) {
  QWidget parent;
  auto* label = new QLabel("?", &parent);
  set_style(*label, text_in(bad_color));
  const QString light = label->styleSheet();
  {
    const testing::PaletteFor dark(testing::dark_palette());
    QTest::qWait(20);
    EXPECT_EQ(label->styleSheet(), "color: " + bad_color(testing::dark_palette()).name());
    EXPECT_NE(label->styleSheet(), light);
  }
  QTest::qWait(20);
  EXPECT_EQ(label->styleSheet(), light);
}

INSTANTIATE_TEST_SUITE_P(to, palette_at_run_time, ::testing::Bool(),
                         [](const auto& turned) { return turned.param ? "dark" : "light"; });

}  // namespace
}  // namespace remount::widgets
