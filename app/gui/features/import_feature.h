// Tables that no reader knows: where somebody is stuck, the window offers to say what their columns are.
#pragma once

#include <QPointer>

#include "app/gui/features/import/import_controller.h"
#include "app/gui/shell/feature.h"
#include "widgets/import/import_dialog.h"

namespace remount::gui {

class ImportFeature : public Feature {
  Q_OBJECT
 public:
  explicit ImportFeature(MainWindow& window);
  /// Shows the page for a folder, or for a file and what lies beside it.
  void import(const QString& path);
  bool may_close(const std::function<void()>& again) override;
  ImportController* controller() const { return controller_; }  ///< of the page that is shown; null where none is

 private:
  void offer(const QString& path);  ///< behind the last message
  void ask_for_table();
  widgets::ImportDialog* make_dialog();
  void open(const QString& manifest);

  QPointer<widgets::ImportDialog> dialog_;
  QPointer<ImportController> controller_;
  QMetaObject::Connection closing_;  ///< what waits for a save to end
  QString opening_;                  ///< the manifest behind which the page closes
};

}  // namespace remount::gui
