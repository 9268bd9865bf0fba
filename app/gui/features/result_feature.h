// The result, and what is written of it.
#pragma once

#include "app/gui/shell/feature.h"

class QAction;

namespace remount::widgets {
class ExportDialog;
class ResultPanel;
}  // namespace remount::widgets

namespace remount::gui {

class ReportMaker;

class ResultFeature : public Feature {
  Q_OBJECT
 public:
  explicit ResultFeature(MainWindow& window);
  void show_output() override;
  void show_state() override;

 private:
  void make_actions();
  void make_report();
  void show_export();
  void follow_result(widgets::ExportDialog& dialog);
  void save_export(widgets::ExportDialog& dialog, const QString& path, const QString& text);
  void ask_for_report();
  void copy_result();
  void use_as_nominal();

  widgets::ResultPanel* result_;
  ReportMaker* report_ = nullptr;
  QAction *export_ = nullptr, *make_report_ = nullptr, *copy_ = nullptr, *use_as_nominal_ = nullptr;
};

}  // namespace remount::gui
