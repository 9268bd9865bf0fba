#include "app/gui/basics/ask_to_replace.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QMessageBox>

#include "widgets/basics/rows.h"

namespace remount::gui {
namespace {

struct ReplaceText {
  Q_DECLARE_TR_FUNCTIONS(remount::gui::ask_to_replace)
};

}  // namespace

bool ask_to_replace(QStringList files, QWidget& window) {
  files.removeIf([](const QString& file) { return !QFileInfo::exists(file); });
  for (QString& file : files) file = QDir::toNativeSeparators(file);
  return files.isEmpty() ||
         QMessageBox::question(
             &window, ReplaceText::tr("Replace files"),
             ReplaceText::tr("%n file(s) exist already. Replace?", nullptr, widgets::qt_count(files.size())) +
                 QStringLiteral("\n\n") + files.join('\n'),
             QMessageBox::Yes | QMessageBox::No, QMessageBox::No) == QMessageBox::Yes;
}

}  // namespace remount::gui
