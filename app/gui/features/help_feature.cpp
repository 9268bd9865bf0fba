#include "app/gui/features/help_feature.h"

#include <QApplication>
#include <QCursor>
#include <QDir>
#include <QMessageBox>

#include "app/gui/basics/language.h"
#include "app/gui/basics/sample.h"
#include "app/gui/features/project_feature.h"
#include "app/gui/shell/main_window.h"
#include "remount_version.h"
#include "widgets/basics/toolkits.h"
#include "widgets/shell/help_window.h"

namespace remount::gui {

HelpFeature::HelpFeature(MainWindow& window) : Feature(window) {
  Menus& menus = window.menus();
  QAction* sample = menus.add(MenuPlace::Help, tr("Open &sample session"), {}, [this] {
    if (auto* project = window_.feature<ProjectFeature>()) project->open_sample();
  });
  sample->setEnabled(!sample_path().isEmpty());
  menus.add(MenuPlace::Help, tr("&Help on this panel"), QKeySequence::HelpContents, [this] { show_help(); });
  menus.add(MenuPlace::Help, tr("&Keys"), {}, [this] { window_.keys().ask(); });
  menus.add(MenuPlace::Help, tr("&About Remount"), {}, [this] { show_about(); });
}

void HelpFeature::show_help() {
  QString page = window_.help_page_of(QApplication::focusWidget());
  // A click on a tab or a label gives no panel the keyboard: then it is what lies under the pointer.
  if (page == window_.help_page_of(nullptr) && !workbench_.sessions().empty())
    page = window_.help_page_of(QApplication::widgetAt(QCursor::pos()));
  show_page(page);
}

void HelpFeature::show_page(const QString& page) {
  if (!help_) {
    const QString own = ":/help/" + spoken_language();
    help_ = new widgets::HelpWindow(QDir(own).exists() ? own : QStringLiteral(":/help/en"), &window_);
  }
  help_->show_page(page);
  help_->show();
  help_->raise();
  help_->activateWindow();
}

void HelpFeature::show_about() {
  QString made_of = widgets::toolkit_versions();
  if (const QString opengl = widgets::opengl_name(); !opengl.isEmpty()) made_of += "<br>" + opengl.toHtmlEscaped();
  QMessageBox::about(&window_, tr("About Remount"),
                     tr("<b>Remount %1</b><p>Finds where a LiDAR sits on a vehicle, relative to its GNSS/INS, "
                        "from recorded drives.</p>")
                             .arg(QString::fromUtf8(kVersion)) +
                         "<p>" + made_of);
}

}  // namespace remount::gui
