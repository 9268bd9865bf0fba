// Offline help: contents, search, and a page for each panel.
#pragma once

#include <QDialog>
#include <vector>

class QLineEdit;
class QListWidget;
class QTextBrowser;

namespace remount::widgets {

class HelpWindow : public QDialog {
  Q_OBJECT
 public:
  /// Pages are the files "NN-name.html" of a folder, listed by their numbers.
  explicit HelpWindow(const QString& folder, QWidget* parent = nullptr);
  void show_page(const QString& name);  ///< "pairs"; the first page where there is none of that name
  QString current_page() const;
  QStringList listed_pages() const;  ///< those that contain what is searched for

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Page {
    QString name, title, html;
  };
  void show_current();
  void search(const QString& text);
  std::vector<Page> pages_;
  QLineEdit* search_;
  QListWidget* list_;
  QTextBrowser* text_;
};

}  // namespace remount::widgets
