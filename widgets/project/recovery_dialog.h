// Offers work that a window left behind when it ended without closing.
#pragma once

#include <QDialog>
#include <QStringList>
#include <vector>

namespace remount::widgets {

struct RecoveryEntry {
  QString title;            ///< the project's name, or that it never had one
  QString contents;         ///< what is in it, in words
  QStringList generations;  ///< when each was saved; newest first
};

class RecoveryDialog : public QDialog {
  Q_OBJECT
 public:
  explicit RecoveryDialog(const std::vector<RecoveryEntry>& entries, QWidget* parent = nullptr);

 signals:
  void restore_requested(int entry, int generation);  ///< the dialog closes
  void discard_requested(int entry);                  ///< the entry disappears; the dialog closes after the last

 private:
  QWidget* make_entry(int index, const RecoveryEntry& entry);
  void drop(QWidget* entry);
  int left_ = 0;
};

}  // namespace remount::widgets
