#include "app/gui/document/project_keeper.h"

#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>

#include "algorithms/core/index.h"
#include "app/gui/workbench/wording.h"
#include "widgets/basics/file_dialogs.h"
#include "widgets/project/recovery_dialog.h"
#include "widgets/sessions/missing_sessions_dialog.h"

namespace remount::gui {

// Without its namespace below: lupdate takes that of a returned type for a part of the function's name.
using widgets::RecoveryEntry;

ProjectKeeper::ProjectKeeper(Workbench& workbench, QWidget& window)
    : QObject(&window), workbench_(workbench), window_(window) {
  connect(&workbench_.sessions(), &SessionList::session_opened, this, &ProjectKeeper::add_recent);
  connect(&workbench_.document(), &ProjectDocument::saved, this, &ProjectKeeper::add_recent);
  connect(&workbench_.document(), &ProjectDocument::opened, this, [this](const ProjectToOpen& request) {
    if (!request.recovered) add_recent(request.path);
  });
  connect(&workbench_.document(), &ProjectDocument::sessions_missing, this, &ProjectKeeper::ask_for_sessions);
  connect(&workbench_.document(), &ProjectDocument::held, this, &ProjectKeeper::ask_how_to_open);
  connect(&workbench_.document(), &ProjectDocument::lost, this,
          [this](const QString& path, const project::LockHolder& holder) {
            workbench_.notices().say(
                drive::Severity::Warning, path,
                tr("was taken over by another window: %1.\nHere it is read-only from now on. Save your work under "
                   "another name (File, Save project as).")
                    .arg(holder_text(holder)));
          });
}

void ProjectKeeper::add_recent(const QString& path) {
  recent_.add(path);
  emit recent_changed();
}

void ProjectKeeper::ask_how_to_open(const ProjectToOpen& request, const project::LockHolder& holder,
                                    bool on_another_computer) {
  const QString path = request.recovered ? request.belongs_to : request.path;
  auto* dialog =
      new QMessageBox(QMessageBox::Question, tr("The project is open in another window"),
                      tr("%1 is open in another window:\n%2.").arg(QDir::toNativeSeparators(path), holder_text(holder)),
                      QMessageBox::Cancel, &window_);
  dialog->setObjectName(QStringLiteral("held-project"));
  dialog->setTextFormat(Qt::PlainText);  // the names come from a file that anybody may have written
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  QString explanation = tr(
      "Read-only shows the file as it was saved last; what you change is saved under another name. A copy is work of "
      "your own that has no file yet.");
  if (on_another_computer)
    explanation +=
        QStringLiteral("\n\n") +
        tr("If that computer was switched off or lost its connection, take the project over: the window there "
           "can save it under another name only.");
  dialog->setInformativeText(explanation);
  const auto offer = [&](const QString& text, QMessageBox::ButtonRole role, ProjectToOpen::Access access) {
    QPushButton* button = dialog->addButton(text, role);
    connect(button, &QPushButton::clicked, this, [this, request, access] {
      ProjectToOpen again = request;
      again.access = access;
      workbench_.document().open(again);
    });
    return button;
  };
  dialog->setDefaultButton(offer(tr("Open &read-only"), QMessageBox::AcceptRole, ProjectToOpen::Access::ReadOnly));
  offer(tr("Open a &copy"), QMessageBox::AcceptRole, ProjectToOpen::Access::Copy);
  if (on_another_computer) offer(tr("&Take over"), QMessageBox::DestructiveRole, ProjectToOpen::Access::TakeOver);
  dialog->open();
}

void ProjectKeeper::keep_in(const QString& data_folder) {
  put_autosave(std::make_unique<Autosave>(workbench_, data_folder));
}

void ProjectKeeper::put_autosave(std::unique_ptr<Autosave> autosave) {
  autosave_ = std::move(autosave);
  if (!autosave_) return;
  connect(autosave_.get(), &Autosave::found, this, &ProjectKeeper::offer);
  connect(autosave_.get(), &Autosave::failed, this, [this](const QString& where, const QString& what) {
    workbench_.notices().say(
        drive::Severity::Warning, where,
        tr("Unsaved work cannot be kept safe automatically: %1\nSave the project (Ctrl+S) where there is room.")
            .arg(what));
  });
  connect(autosave_.get(), &Autosave::moved, this,
          [this](const QString& where, const QString& what, const QString& folder) {
            workbench_.notices().say(
                drive::Severity::Warning, where,
                tr("The project's folder cannot be written: %1\nYour work is kept safe in %2 instead. Bring the "
                   "disk back, or save the project elsewhere (File, Save project as).")
                    .arg(what, QDir::toNativeSeparators(folder)));
          });
}

std::unique_ptr<Autosave> ProjectKeeper::take_autosave() {
  if (autosave_) disconnect(autosave_.get(), nullptr, this, nullptr);
  return std::move(autosave_);
}

void ProjectKeeper::finish() {
  if (autosave_) autosave_->finish();
}

RecoveryEntry describe(const RecoveryOffer& offer, const QDateTime& now) {
  RecoveryEntry entry;
  const AutosaveSummary& summary = offer.summary;
  entry.title = summary.project_path.isEmpty() ? ProjectKeeper::tr("Never saved as a project") : summary.project_path;
  QStringList names;
  for (const QString& session : summary.sessions) names << QFileInfo(session).fileName();
  QStringList parts;
  parts << (names.isEmpty() ? ProjectKeeper::tr("no sessions")
                            : ProjectKeeper::tr("Sessions: %1").arg(names.join(", ")));
  if (summary.pairs > 0) parts << ProjectKeeper::tr("a calibration with %n pair(s)", nullptr, summary.pairs);
  if (summary.decisions > 0) parts << ProjectKeeper::tr("%n decision(s) of yours", nullptr, summary.decisions);
  entry.contents = parts.join(QStringLiteral("; ")) + '.';
  for (const AutosaveGeneration& generation : offer.generations)
    entry.generations << ProjectKeeper::tr("saved %1 (%2)")
                             .arg(age_text(generation.saved, now),
                                  QLocale().toString(generation.saved.toLocalTime().time(), QLocale::ShortFormat));
  return entry;
}

void ProjectKeeper::offer(const std::vector<RecoveryOffer>& offers) {
  std::vector<RecoveryEntry> entries;
  for (const RecoveryOffer& found : offers) entries.push_back(describe(found, QDateTime::currentDateTimeUtc()));
  auto* dialog = new widgets::RecoveryDialog(entries, &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &widgets::RecoveryDialog::restore_requested, this, [this, offers](int entry, int generation) {
    const RecoveryOffer& chosen = offers.at(index_at(entry));
    autosave_->restore(chosen, chosen.generations.at(index_at(generation)));
  });
  connect(dialog, &widgets::RecoveryDialog::discard_requested, this,
          [offers](int entry) { discard(offers.at(index_at(entry))); });
  dialog->open();
}

void ProjectKeeper::ask_for_sessions(const ProjectToOpen& request, const QStringList& missing) {
  auto* dialog = new widgets::MissingSessionsDialog(
      QFileInfo(request.recovered ? request.belongs_to : request.path).fileName(), missing, &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &widgets::MissingSessionsDialog::locate_requested, this,
          [this, dialog, missing](int row) { locate(*dialog, missing, row); });
  connect(dialog, &widgets::MissingSessionsDialog::open_requested, this,
          [this, dialog, request, missing](bool without) {
            ProjectToOpen again = request;
            again.without_missing = without;
            for (qsizetype i = 0; i < missing.size(); ++i)
              if (const QString found = dialog->found().at(i); !found.isEmpty())
                again.moved[missing.at(i).toStdString()] = found.toStdString();
            workbench_.document().open(again);
          });
  dialog->open();
}

void ProjectKeeper::locate(widgets::MissingSessionsDialog& dialog, const QStringList& missing, int row) {
  if (row < 0) return;
  const QString was = missing.at(row);
  const QString title = tr("Where is %1 now?").arg(QFileInfo(was).fileName());
  const QString path = QFileInfo(was).suffix().isEmpty()
                           ? widgets::ask_for_folder(&dialog, title, widgets::FileKind::Recordings)
                           : widgets::ask_for_file(&dialog, title, widgets::FileKind::Recordings);
  if (path.isEmpty()) return;
  dialog.show_found(row, path);
  for (int other = 0; other < missing.size(); ++other) {
    if (!dialog.found().at(other).isEmpty()) continue;
    const std::filesystem::path there =
        project::relocate(missing.at(other).toStdString(), was.toStdString(), path.toStdString());
    if (!there.empty()) dialog.show_found(other, QString::fromStdString(there.string()));
  }
}

void ProjectKeeper::fill_recent_menu(QMenu& menu) {
  menu.clear();
  const QStringList paths = recent_.paths(), labels = recent_.labels();
  for (qsizetype i = 0; i < paths.size(); ++i) {
    QAction* action = menu.addAction(QString(labels.at(i)).replace('&', "&&"));
    action->setToolTip(paths.at(i));
    connect(action, &QAction::triggered, this, [this, path = paths.at(i)] { emit open_requested({path}); });
  }
  if (paths.isEmpty()) {
    menu.addAction(tr("Nothing opened yet"))->setEnabled(false);
    return;
  }
  menu.addSeparator();
  connect(menu.addAction(tr("Forget these")), &QAction::triggered, this, [this] {
    recent_.clear();
    emit recent_changed();
  });
}

}  // namespace remount::gui
