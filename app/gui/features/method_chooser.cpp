#include "app/gui/features/method_chooser.h"

#include "model/method_registry/calibration_method.h"
#include "widgets/text/model_text.h"

namespace remount::gui {

MethodChooser::MethodChooser(Workbench& workbench) : workbench_(workbench) {
  setAccessibleName(tr("Method"));
  for (const method_registry::CalibrationMethod* method : method_registry::calibration_methods()) {
    addItem(widgets::model_text(method->title()));
    setItemData(count() - 1, tr("Needs: %1").arg(widgets::model_text(method->needs())), Qt::ToolTipRole);
  }
  connect(this, &QComboBox::activated, this, [this](int method) {
    workbench_.setup().edit_option(QStringLiteral("run"), QStringLiteral("method"), method);
  });
  connect(&workbench_.setup(), &Setup::settings_changed, this, &MethodChooser::show_choice);
  show_choice();
}

void MethodChooser::show_choice() {
  const int method = static_cast<int>(workbench_.setup().settings().run.method);
  setCurrentIndex(method);
  setToolTip(itemData(method, Qt::ToolTipRole).toString());
}

}  // namespace remount::gui
