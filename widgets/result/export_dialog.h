// Choose a format, see the text and its direction, copy or save it.
#pragma once

#include <QDialog>
#include <functional>
#include <vector>

class QLabel;
class QListWidget;
class QPlainTextEdit;
class QPushButton;
class QVBoxLayout;

namespace remount::widgets {

struct ExportFormat {
  QString id, title;
  QString direction;    ///< "LiDAR -> INS", in words
  QString file_name;    ///< suggested
  bool folder = false;  ///< several files, which a folder is asked for
};

/// What a format makes of the result; nothing to copy or save where there is a problem.
struct ExportText {
  QString text;
  QString problem{};    ///< why there is none, and what to choose instead
  QString direction{};  ///< where it is another than the format's own
};

class ExportDialog : public QDialog {
  Q_OBJECT
 public:
  using TextOf = std::function<ExportText(const QString& id)>;
  ExportDialog(std::vector<ExportFormat> formats, TextOf text_of, QWidget* parent = nullptr);
  /// What the texts depend on beside the result, above them.
  void add_form(QWidget* form);
  /// What is to be known before anything is written; empty for nothing.
  void show_warning(const QString& warning);
  /// What became of the last copy or save; until there is another text.
  void show_outcome(const QString& text, bool failed);
  /// While the result is still being solved, nothing is copied or saved.
  void set_final(bool is_final);
  QString current_id() const;
  QString current_text() const;  ///< empty where the format cannot hold the result
  void choose(const QString& id);
  /// Shows the text of the chosen format as it is now.
  void show_current();

 signals:
  void copied(const QString& id);
  void save_requested(const QString& id, const QString& path, const QString& text);

 private:
  void ask_where();

  std::vector<ExportFormat> formats_;
  TextOf text_of_;
  QListWidget* list_;
  QPlainTextEdit* preview_;
  QLabel *direction_, *warning_, *outcome_;
  QVBoxLayout* forms_;
  QPushButton *copy_ = nullptr, *save_ = nullptr;
  QString text_;
  bool final_ = true;
};

}  // namespace remount::widgets
