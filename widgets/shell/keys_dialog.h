// Keys of the window's actions: seen, changed, put back.
#pragma once

#include <QDialog>
#include <QKeySequence>
#include <vector>

class QKeySequenceEdit;
class QLabel;
class QPushButton;

namespace remount::widgets {

struct KeyBinding {
  QString id;    ///< as it is saved; empty: the key is fixed, and only watched for conflicts
  QString text;  ///< of the action
  QKeySequence key, standard;
};

/// Pairs of actions that have the same key, in words; empty where none have.
QStringList key_conflicts(const std::vector<KeyBinding>& bindings);

class KeysDialog : public QDialog {
  Q_OBJECT
 public:
  explicit KeysDialog(const std::vector<KeyBinding>& bindings, QWidget* parent = nullptr);
  const std::vector<KeyBinding>& bindings() const { return bindings_; }
  void set_key(const QString& id, const QKeySequence& key);  ///< as if it had been typed

 private:
  QWidget* make_rows();
  QKeySequenceEdit* make_editor(std::size_t binding);
  QWidget* make_buttons();
  void reset();
  void check();
  std::vector<KeyBinding> bindings_;
  std::vector<QKeySequenceEdit*> editors_;  // null where the key is fixed
  QLabel* conflicts_;
  QPushButton* ok_ = nullptr;
};

}  // namespace remount::widgets
