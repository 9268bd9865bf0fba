#include "tests/screenshots/imports.h"

#include <QDir>
#include <QFileInfo>
#include <QTest>
#include <cstdio>

#include "app/gui/basics/language.h"
#include "app/gui/features/import_feature.h"
#include "app/gui/window_host.h"
#include "widgets/import/check_list.h"
#include "widgets/import/found_files_tree.h"
#include "widgets/import/import_dialog.h"

namespace remount::testing {
namespace {

constexpr int kLong_ms = 120000, kSaved_ms = 5000, kLateDrawing_ms = 700;

class ImportTour {
 public:
  explicit ImportTour(const TourRequest& request) : request_(request) {}

  bool take() {
    host_.window().resize(request_.size);
    host_.window().show();
    if (!QTest::qWaitForWindowExposed(&host_.window(), kLong_ms)) return false;
    for (const QString& session : request_.sessions)
      if (!take_one(session)) return false;
    return true;
  }

 private:
  bool take_one(const QString& session) {
    gui::MainWindow& window = host_.window();
    const QString name = QFileInfo(session).fileName();
    window.open_paths({session});
    (void)QTest::qWaitFor([&] { return !workbench_.activity().opening(); }, kLong_ms);
    save(window, name + "-offered");
    window.feature<gui::ImportFeature>()->import(session);
    auto* dialog = window.findChild<widgets::ImportDialog*>();
    if (!dialog) return false;
    dialog->resize(request_.size - QSize(40, 60));
    auto& files = *dialog->findChild<widgets::FoundFilesTree*>();
    if (!QTest::qWaitFor([&] { return files.topLevelItemCount() > 0; }, kLong_ms)) return false;
    save(*dialog, name + "-import");
    if (!dialog->choice().table) emit files.itemClicked(files.topLevelItem(0)->child(0), 0);
    const auto checked = [&] {
      return dialog->choice().table && dialog->checks().isEnabled() && !dialog->checks().text().isEmpty();
    };
    if (!QTest::qWaitFor(checked, kLong_ms)) return false;
    take_wrong(*dialog, name);
    if (!QTest::qWaitFor(checked, kLong_ms)) return false;
    save(*dialog, name + "-checked");
    const QString manifest = QDir(request_.folder).filePath(name + "-session.yaml");
    window.feature<gui::ImportFeature>()->controller()->save(manifest);
    if (QTest::qWaitFor([&] { return QFileInfo::exists(manifest); }, kSaved_ms)) save(*dialog, name + "-saved");
    dialog->close();
    QTest::qWait(kLateDrawing_ms);  // until it is gone
    return true;
  }
  /// Angles the other way round, then a column too few; and back.
  void take_wrong(widgets::ImportDialog& dialog, const QString& name) {
    const guesses::TableChoices as_it_was = dialog.choice().choices;
    guesses::TableChoices wrong = as_it_was;
    wrong.negated = {true, true, false};
    wrong.attitude = guesses::AttitudeStyle::Heading;
    dialog.choose(wrong);
    QTest::qWait(kLateDrawing_ms);
    save(dialog, name + "-wrong");
    wrong.roles.front() = guesses::ColumnRole::Ignored;
    dialog.choose(wrong);
    QTest::qWait(kLateDrawing_ms);
    save(dialog, name + "-lacks");
    dialog.choose(as_it_was);
  }
  void save(QWidget& widget, const QString& name) {
    QTest::qWait(kLateDrawing_ms);
    if (!widget.grab().save(QDir(request_.folder).filePath(name + ".png")))
      std::fprintf(stderr, "%s is not saved\n", qPrintable(name));
  }

  TourRequest request_;
  gui::Workbench workbench_{gui::model_engine()};
  gui::WindowHost host_{workbench_};
};

}  // namespace

bool take_imports(const TourRequest& request) {
  QDir().mkpath(request.folder);
  gui::speak(request.language, false);
  return ImportTour(request).take();
}

}  // namespace remount::testing
