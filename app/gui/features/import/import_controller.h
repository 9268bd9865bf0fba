// One import of a table: looks at the files, checks what is chosen, saves and opens, all of it in the background.
#pragma once

#include <QObject>
#include <QStringList>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "app/gui/jobs/job_runner.h"
#include "model/guesses/table_import.h"

namespace remount::widgets {
class ImportDialog;
}  // namespace remount::widgets

namespace remount::gui {

class Workbench;

/// Lives as long as its dialog.
class ImportController : public QObject {
  Q_OBJECT
 public:
  ImportController(Workbench& workbench, widgets::ImportDialog& dialog);
  ~ImportController() override;

  /// What was chosen so far stays where its table is found again. @param meant the tables that are asked for, the first
  /// that is one is shown; empty for none
  void look_at(const QStringList& paths, const QStringList& meant);
  /// Where a manifest goes that nobody gives another place.
  QString usual_place() const;
  /// Asks before a file is replaced, and says so where it is that of an open session. The page is locked until it is
  /// written. @param saved is called with the path once it is written
  void save(const QString& path, std::function<void()> saved = {});
  bool saving() const { return save_.job != 0; }
  /// Whether a manifest has what stands in the dialog.
  bool is_saved() const { return !saved_.isEmpty(); }

 signals:
  void open_requested(const QString& manifest);
  void saved(const QString& manifest);
  void save_ended();  ///< written or not

 private:
  /// A job, of which the answer counts where no other was started in its place.
  struct Task {
    int job = 0, turn = 0;
  };
  /// What was chosen of a table, for columns of these titles.
  struct KeptChoices {
    guesses::TableChoices choices;
    std::vector<std::string> titles;
  };
  using Failed = std::function<void(const JobFailure&)>;
  template <class Made>
  void start(Task ImportController::*task, std::function<Made(Progress&)> make, std::function<void(const Made&)> take,
             Failed failed);
  void cancel(Task& task);
  template <class Answer>
  Answer ask(const std::function<Answer()>& question);
  void keep_choices();
  void put_kept_back();
  void take_data(const guesses::ImportData& data);
  void tell_not_looked_at(const JobFailure& failure);
  void check_soon();
  void check();
  void take_table(const QString& file);
  void take_log();
  void ask_for_folder();
  void ask_for_files();
  void ask_for_place();
  void save_and_open();
  bool tells_that_it_is_open(const QString& manifest);
  void end_save();

  Workbench& workbench_;
  widgets::ImportDialog& dialog_;
  QStringList paths_, asked_paths_;  ///< that data_ is of, and those that are looked at
  QString saved_;                    ///< the manifest that has what stands in the dialog; empty for none
  std::shared_ptr<const guesses::ImportData> data_;
  Task work_, save_;      ///< looking, reading and checking follow each other; edits stop a check and never a save
  bool reading_ = false;  ///< work_ looks at files or reads a table, behind which a check follows
  int edits_ = 0;
  QTimer until_check_;
  // What was chosen before files were looked at anew, or another table was read.
  std::map<std::filesystem::path, KeptChoices> kept_;
  std::set<std::filesystem::path> kept_left_out_;
  std::optional<guesses::ImportTable> kept_table_;
};

}  // namespace remount::gui
