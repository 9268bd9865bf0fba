// Keeps unsaved work on disk: right after each edit, and again every minute until that has succeeded.
#pragma once

#include <QObject>
#include <QTimer>
#include <vector>

#include "app/gui/document/recovery.h"
#include "app/gui/jobs/job_runner.h"
#include "app/gui/workbench/workbench.h"

namespace remount::gui {

class Autosave : public QObject {
  Q_OBJECT
 public:
  Autosave(Workbench& workbench, const QString& data_folder, QObject* parent = nullptr);
  ~Autosave() override;

  /// Opens what a crashed window left (found()). Its files are removed once this window has saved them for itself.
  void restore(const RecoveryOffer& offer, const AutosaveGeneration& generation);
  /// The window closes, and the user has decided what becomes of unsaved work.
  void finish();
  bool writing() const { return job_ != 0; }              ///< or at other work on the disk
  int saved_revision() const { return saved_revision_; }  ///< what is safe, in a project or an autosave

 signals:
  void found(const std::vector<gui::RecoveryOffer>& offers);  ///< soon after the start, where there are any
  void saved(const QString& path);
  void failed(const QString& where, const QString& what);  ///< once until it succeeds again
  /// The project's folder cannot be written; work is kept in this folder of the user's until the project is saved.
  void moved(const QString& where, const QString& what, const QString& folder);

 private:
  void take_over(const ProjectToOpen& request, bool whole);
  void begin(std::unique_ptr<RecoveryNotes> notes);
  void look();
  void clear();
  void show_life();
  void write();
  /// `discarded`: so many of restored_ have been removed, the first.
  void written(const QString& path, int revision, std::ptrdiff_t discarded);
  void could_not(const JobFailure& failure);
  AutosaveSummary summary() const;

  Workbench& workbench_;
  std::unique_ptr<RecoveryNotes> notes_;  // null where there is no place for them
  std::vector<RecoveryOffer> restoring_, restored_;
  QTimer soon_, again_, beats_;
  int job_ = 0, saved_revision_ = 0;
  bool finished_ = false, in_notes_ = false, complained_ = false;
  std::unique_ptr<JobRunner> jobs_ = std::make_unique<JobRunner>();
};

}  // namespace remount::gui
