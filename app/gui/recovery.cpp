#include "app/gui/recovery.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QUuid>
#include <algorithm>

#include "algorithms/core/error.h"
#include "model/io/atomic_save.h"
#include "model/io/parse_document.h"

namespace remount {
namespace {

constexpr std::string_view kFormat = "remount-recovery/1";
constexpr int kMost = 1000000000;
const QString kLock = QStringLiteral("lock"), kNote = QStringLiteral("note.yaml"), kWork = QStringLiteral("work");

struct Words {
  Q_DECLARE_TR_FUNCTIONS(remount::recovery)
};

QString generation_path(const QString& base, int generation) {
  return base + QStringLiteral(".autosave-%1").arg(generation);
}

QString base_of(const QString& path) { return path.left(path.lastIndexOf(QStringLiteral(".autosave-"))); }

std::vector<AutosaveGeneration> generations_of(const QString& base) {
  std::vector<AutosaveGeneration> found;
  for (int i = 1; i <= RecoveryNotes::kGenerations; ++i) {
    const QFileInfo file(generation_path(base, i));
    if (file.isFile() && file.size() > 0) found.push_back({file.filePath(), file.lastModified()});
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.saved > b.saved; });
  return found;
}

void remove_generations(const QString& base) {
  if (base.isEmpty()) return;
  for (int i = 1; i <= RecoveryNotes::kGenerations; ++i) QFile::remove(generation_path(base, i));
}

QString own_base(const QString& folder) { return QDir(folder).filePath(kWork); }

/// The base of the autosaves that a note names; throws Error where it is damaged.
QString read_note(const QString& folder, AutosaveSummary& summary) {
  const std::string path = QDir(folder).filePath(kNote).toStdString();
  const DocumentNode document = read_document(path);
  const DocumentView root(document, path);
  if (root.at("format").string() != kFormat) root.at("format").fail("is not " + std::string(kFormat));
  summary.project_path = QString::fromStdString(root.at("project").string());
  for (const DocumentView& item : root.at("sessions").items())
    summary.sessions << QString::fromStdString(item.string());
  summary.pairs = static_cast<int>(root.at("pairs").integer(0, kMost));
  summary.decisions = static_cast<int>(root.at("decisions").integer(0, kMost));
  summary.status = QString::fromStdString(root.at("status").string());
  return QString::fromStdString(root.at("autosaves").string());
}

RecoveryOffer read_offer(const QString& folder) {
  RecoveryOffer offer;
  offer.folder = folder;
  QString base = own_base(folder);
  try {
    base = read_note(folder, offer.summary);
  } catch (const Error&) {
    // The autosaves in the folder itself are found without it; one beside a project was noted before it was relied on.
  }
  offer.generations = generations_of(base);
  if (offer.generations.empty()) offer.generations = generations_of(own_base(folder));
  return offer;
}

}  // namespace

RecoveryNotes::RecoveryNotes(const QString& data_folder)
    : folder_(QDir(data_folder).filePath("recovery/" + QUuid::createUuid().toString(QUuid::WithoutBraces))) {
  if (!QDir().mkpath(folder_))
    throw Error(ErrorCode::Io, folder_.toStdString(),
                Words::tr("cannot be made: work is not saved until you save it").toStdString());
  lock_ = std::make_unique<QLockFile>(QDir(folder_).filePath(kLock));
  lock_->setStaleLockTime(0);  // held as long as the process lives, however long that is
  // Unlocked notes would be offered to the next window as those of a crash.
  if (!lock_->tryLock(0))
    throw Error(ErrorCode::Io, folder_.toStdString(),
                Words::tr("cannot be locked: work is not saved until you save it").toStdString());
}

RecoveryNotes::~RecoveryNotes() = default;

QString RecoveryNotes::rotated(const QString& base) {
  const QDateTime now = QDateTime::currentDateTimeUtc();
  const QString newest = generation_path(base, 1);
  const bool first = !generation_began_.isValid() || base != base_;
  if (!used_.contains(base)) used_ << base;
  if (first || generation_began_.secsTo(now) >= kGenerationAge_s) {
    generation_began_ = now;
    if (QFileInfo::exists(newest)) {
      QFile::remove(generation_path(base, kGenerations));
      for (int i = kGenerations - 1; i >= 1; --i) QFile::rename(generation_path(base, i), generation_path(base, i + 1));
    }
  }
  return newest;
}

QString RecoveryNotes::next_path(const QString& project_path) {
  const bool ours = project_path == base_ || generations_of(project_path).empty();
  return project_path.isEmpty() || !ours ? next_path_in_notes() : rotated(project_path);
}

QString RecoveryNotes::next_path_in_notes() { return rotated(own_base(folder_)); }

void write_note(const QString& folder, const QString& autosave_path, const AutosaveSummary& summary) {
  const QString base = base_of(autosave_path);
  DocumentNode root = DocumentNode::map();
  root.add("format", DocumentNode::string(kFormat));
  root.add("project", DocumentNode::string(summary.project_path.toStdString()));
  root.add("autosaves", DocumentNode::string(base.toStdString()));
  DocumentNode& sessions = root.add("sessions", DocumentNode::sequence());
  for (const QString& session : summary.sessions) sessions.add(DocumentNode::string(session.toStdString()));
  root.add("pairs", DocumentNode::integer(summary.pairs));
  root.add("decisions", DocumentNode::integer(summary.decisions));
  root.add("status", DocumentNode::string(summary.status.toStdString()));
  save_atomically(QDir(folder).filePath(kNote).toStdString(), to_yaml(root));
}

void RecoveryNotes::adopt(const QString& path) {
  const QString base = base_of(path);
  if (base != base_) remove_generations(base_);
  base_ = base;
}

void RecoveryNotes::clear() {
  for (const QString& base : used_) remove_generations(base);
  used_.clear();
  QFile::remove(QDir(folder_).filePath(kNote));
  base_.clear();
  generation_began_ = {};
}

std::vector<RecoveryOffer> find_recoveries(const QString& data_folder) {
  std::vector<RecoveryOffer> offers;
  const QDir folder(QDir(data_folder).filePath("recovery"));
  for (const QString& name : folder.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    const QString notes = folder.filePath(name);
    QLockFile lock(QDir(notes).filePath(kLock));
    lock.setStaleLockTime(0);
    if (!lock.tryLock(0)) continue;  // its window is open
    const RecoveryOffer offer = read_offer(notes);
    lock.unlock();
    if (offer.generations.empty())
      QDir(notes).removeRecursively();
    else
      offers.push_back(offer);
  }
  std::stable_sort(offers.begin(), offers.end(), [](const auto& a, const auto& b) {
    return a.generations.front().saved > b.generations.front().saved;
  });
  return offers;
}

void discard(const RecoveryOffer& offer) {
  for (const AutosaveGeneration& generation : offer.generations) QFile::remove(generation.path);
  QDir(offer.folder).removeRecursively();
}

QString age_text(const QDateTime& then, const QDateTime& now) {
  const qint64 seconds = then.secsTo(now);
  if (seconds < 60) return Words::tr("less than a minute ago");
  if (seconds < 3600) return Words::tr("%n minute(s) ago", nullptr, static_cast<int>(seconds / 60));
  if (seconds < 24 * 3600) return Words::tr("%n hour(s) ago", nullptr, static_cast<int>(seconds / 3600));
  return QLocale().toString(then.toLocalTime(), QLocale::ShortFormat);
}

}  // namespace remount
