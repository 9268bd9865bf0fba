#include "app/gui/features/log_feature.h"

#include "app/gui/shell/main_window.h"
#include "widgets/shell/log_panel.h"

namespace remount::gui {
namespace {
struct KeptLog : Feature::Kept {
  QString text;
};
}  // namespace

LogFeature::LogFeature(MainWindow& window) : Feature(window), log_(new widgets::LogPanel) {
  window.add_dock({.title = tr("Log"), .name = "log", .content = log_, .help_page = "log"});
  connect(&workbench_.notices(), &Notices::logged, log_, &widgets::LogPanel::add);
  connect(&workbench_.notices(), &Notices::message, this,
          [this](drive::Severity severity, const QString& where, const QString& what) {
            if (!what.isEmpty()) log_->add(severity, where, what);
          });
}

std::unique_ptr<Feature::Kept> LogFeature::hand_over() {
  auto kept = std::make_unique<KeptLog>();
  kept->text = log_->toPlainText();
  return kept;
}

void LogFeature::take_over(Kept* kept) {
  if (const auto* log = dynamic_cast<const KeptLog*>(kept)) log_->setPlainText(log->text);
}

}  // namespace remount::gui
