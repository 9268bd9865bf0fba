// One import of a table: looks at the files, checks what is chosen, saves and opens, all of it in the background.
#pragma once

#include <QObject>
#include <QStringList>
#include <functional>
#include <memory>
#include <optional>

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

  /// @param meant the table that is asked for; empty for none
  void look_at(const QStringList& paths, const QString& meant);
  /// Where a manifest goes that nobody gives another place.
  QString usual_place() const;
  /// Asks before a file is replaced. @param saved is called with the path once it is written
  void save(const QString& path, std::function<void()> saved = {});

 signals:
  void open_requested(const QString& manifest);
  void saved(const QString& manifest);

 private:
  template <class Made>
  void start(std::function<Made(Progress&)> make, std::function<void(const Made&)> take);
  void cancel();
  void check();
  void take_table(const QString& file);
  void ask_for_folder();
  void ask_for_files();
  void ask_for_place();
  void save_and_open();
  void fail(const JobFailure& failure);

  Workbench& workbench_;
  widgets::ImportDialog& dialog_;
  QStringList paths_;
  QString meant_, saved_;  ///< saved: the manifest that has what stands in the dialog; empty for none
  std::shared_ptr<const guesses::ImportData> data_;
  int job_ = 0, turn_ = 0;
};

}  // namespace remount::gui
