// A table that no reader knows, made a session: what lies there, what each column is, whether that goes with the data.
#pragma once

#include <QDialog>
#include <QPointer>
#include <memory>
#include <set>

#include "model/guesses/table_import.h"

class QLabel;
class QPushButton;

namespace remount::widgets {

class CheckList;
class ColumnTable;
class ConventionForm;
class DriveMap;
class FoundFilesTree;

/// Shows values and says what was asked for; whoever owns it looks at files, checks and saves.
class ImportDialog : public QDialog {
  Q_OBJECT
 public:
  explicit ImportDialog(QWidget* parent = nullptr);

  void show_looking(const QString& where);  ///< until there is something
  void show_problem(const QString& what);   ///< nothing could be looked at
  void show_data(std::shared_ptr<const guesses::ImportData> found);
  void show_table(const guesses::ImportTable& table);  ///< another of the tables
  void show_no_table();                                ///< the log that was found
  void show_checking();
  void show_checks(const guesses::ImportChecks& checks, const std::vector<Message>& missing);
  void show_note(const QString& text);  ///< above the buttons, until something is changed
  void leave_out(const std::set<std::size_t>& lidars);
  /// While a manifest is written, nothing can be changed, and the page cannot be closed.
  void set_saving(bool saving);
  /// While a dialog over the page asks something, the page, which owns it, cannot be closed.
  void set_held(bool held) { held_ = held; }

  guesses::ImportChoice choice() const { return {table_, choices_, left_out_}; }
  CheckList& checks() const { return *checks_; }
  ColumnTable& columns() const { return *columns_; }
  ConventionForm& conventions() const { return *conventions_; }

 public slots:
  void choose(const guesses::TableChoices& choices);
  void reject() override;

 signals:
  void edited();  ///< choice() is another
  void table_requested(const QString& file);
  void log_chosen();        ///< that was found for the motion, which has no columns
  void folder_requested();  ///< to look at more
  void files_requested();
  void save_requested();
  void open_requested();
  void help_requested();

 private:
  QWidget* make_files();
  QWidget* make_buttons();
  void show_about();
  void show_files();
  void check_lidar(std::size_t lidar, bool used);
  void choose_motion(const QString& file);
  void show_state();

  std::shared_ptr<const guesses::ImportData> data_;
  std::optional<guesses::ImportTable> table_;
  guesses::TableChoices choices_;
  std::set<std::size_t> left_out_;
  bool whole_ = false, read_ = false;  ///< whole: it can be opened; read: there is something to save
  bool saving_ = false, held_ = false;
  QPointer<QWidget> focus_before_saving_;

  QLabel *head_, *about_table_, *status_;
  FoundFilesTree* files_ = nullptr;
  ColumnTable* columns_;
  ConventionForm* conventions_;
  CheckList* checks_;
  DriveMap* map_;
  QPushButton *reset_ = nullptr, *save_ = nullptr, *open_ = nullptr;
};

}  // namespace remount::widgets
