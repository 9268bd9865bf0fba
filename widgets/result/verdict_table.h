// A sentence that says what was found, and the table of numbers behind it: the parts of the quality page.
#pragma once

#include <QColor>
#include <QLabel>
#include <QStringList>
#include <QTableWidget>

namespace remount::widgets {

enum class Verdict { Neutral, Good, Doubtful, Bad };

/// One sentence on a tint of its meaning.
class VerdictLabel : public QLabel {
  Q_OBJECT
 public:
  explicit VerdictLabel(const QString& accessible_name, QWidget* parent = nullptr);
  void show_verdict(Verdict verdict, const QString& text);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Verdict verdict_ = Verdict::Neutral;
};

/// Sentences below a table, always whole: a layout that is short of space would cut their last lines off.
class NoteLabel : public QLabel {
  Q_OBJECT
 public:
  explicit NoteLabel(QWidget* parent = nullptr);
  void show_note(const QString& text);  ///< hidden where empty

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit_height();
};

struct TableCell {
  QString text, tool_tip;
  Verdict verdict = Verdict::Neutral;
};

/// Rows of numbers that nobody edits; the first column is of words. Reached with the Tab key, read with the arrows.
class FigureTable : public QTableWidget {
  Q_OBJECT
 public:
  explicit FigureTable(const QString& accessible_name, QWidget* parent = nullptr);
  void show_rows(const QStringList& heads, const std::vector<std::vector<TableCell>>& rows);
  /// A few rows: a page with words of any width is given the height that its parts wish for, seen or not.
  QSize sizeHint() const override { return {QTableWidget::sizeHint().width(), minimumHeight()}; }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void recolor();
  void fit_height();
};

/// A dash, for what is not known, and why.
TableCell unknown_cell(const QString& why);

}  // namespace remount::widgets
