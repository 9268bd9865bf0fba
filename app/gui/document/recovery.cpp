#include "app/gui/document/recovery.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QUuid>
#include <algorithm>
#include <filesystem>
#include <system_error>

#include "algorithms/core/error.h"
#include "messages/window.h"
#include "model/formats/documents/parse_document.h"
#include "model/formats/files/atomic_save.h"

namespace remount::gui {
namespace {

constexpr std::string_view kFormat = "remount-recovery/1";
constexpr int kMost = 1000000000;
const QString kLock = QStringLiteral("lock"), kNote = QStringLiteral("note.yaml"), kWork = QStringLiteral("work");

struct RecoveryText {
  Q_DECLARE_TR_FUNCTIONS(remount::gui::recovery)
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
  return found;
}

/// Never a copy, as QFile::rename makes one where the file system refuses: a crash could leave half of it.
void move_generation(const QString& base, int from, int to) {
  std::error_code stays;
  std::filesystem::rename(generation_path(base, from).toStdString(), generation_path(base, to).toStdString(), stays);
}

bool leaves_room_for_autosaves(const QString& project) {
  constexpr qsizetype kLongestName = 255;
  return generation_path(QFileInfo(project).fileName(), 1).toUtf8().size() <= kLongestName;
}

void remove_generations(const QString& base) {
  if (base.isEmpty()) return;
  for (int i = 1; i <= RecoveryNotes::kGenerations; ++i) QFile::remove(generation_path(base, i));
}

QString own_base(const QString& folder) { return QDir(folder).filePath(kWork); }

/// The base of the autosaves that a note names; throws Error where it is damaged.
QString read_note(const QString& folder, AutosaveSummary& summary) {
  const std::string path = QDir(folder).filePath(kNote).toStdString();
  const formats::DocumentNode document = formats::read_document(path);
  const formats::DocumentView root(document, path);
  if (root.at("format").string() != kFormat) root.at("format").fail(say::window_recovery_format(std::string(kFormat)));
  summary.project_path = QString::fromStdString(root.at("project").string());
  for (const formats::DocumentView& item : root.at("sessions").items())
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

RecoveryNotes::RecoveryNotes(const QString& data_folder, Clock clock)
    : folder_(QDir(data_folder).filePath("recovery/" + QUuid::createUuid().toString(QUuid::WithoutBraces))),
      clock_(std::move(clock)) {
  if (!QDir().mkpath(folder_)) throw Error(ErrorCode::Io, folder_.toStdString(), say::window_recovery_not_made());
  lock_ = project::HolderLock::take(QDir(folder_).filePath(kLock).toStdString()).lock;
  // Unlocked notes would be offered to the next window as those of a crash.
  if (!lock_) throw Error(ErrorCode::Io, folder_.toStdString(), say::window_recovery_not_locked());
}

RecoveryNotes::~RecoveryNotes() = default;

QString RecoveryNotes::rotated(const QString& base) {
  const auto now = clock_();
  const QString newest = generation_path(base, 1);
  if (!used_.contains(base)) used_ << base;
  if (!generation_began_ || base != base_ || now - *generation_began_ >= std::chrono::seconds(kGenerationAge_s)) {
    generation_began_ = now;
    if (QFileInfo::exists(newest))
      for (int i = kGenerations - 1; i >= 1; --i) move_generation(base, i, i + 1);
  }
  return newest;
}

QString RecoveryNotes::next_path(const QString& project_path) {
  if (project_path.isEmpty() || !leaves_room_for_autosaves(project_path)) return next_path_in_notes();
  const bool ours = project_path == base_ || generations_of(project_path).empty();
  return ours ? rotated(project_path) : next_path_in_notes();
}

QString RecoveryNotes::next_path_in_notes() { return rotated(own_base(folder_)); }

void write_note(const QString& folder, const QString& autosave_path, const AutosaveSummary& summary) {
  const QString base = base_of(autosave_path);
  formats::DocumentNode root = formats::DocumentNode::map();
  root.add("format", formats::DocumentNode::string(kFormat));
  root.add("project", formats::DocumentNode::string(summary.project_path.toStdString()));
  root.add("autosaves", formats::DocumentNode::string(base.toStdString()));
  formats::DocumentNode& sessions = root.add("sessions", formats::DocumentNode::sequence());
  for (const QString& session : summary.sessions) sessions.add(formats::DocumentNode::string(session.toStdString()));
  root.add("pairs", formats::DocumentNode::integer(summary.pairs));
  root.add("decisions", formats::DocumentNode::integer(summary.decisions));
  root.add("status", formats::DocumentNode::string(summary.status.toStdString()));
  formats::save_atomically(QDir(folder).filePath(kNote).toStdString(), formats::to_yaml(root));
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
  generation_began_.reset();
}

std::vector<RecoveryOffer> find_recoveries(const QString& data_folder) {
  std::vector<RecoveryOffer> offers;
  const QDir folder(QDir(data_folder).filePath("recovery"));
  for (const QString& name : folder.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    const QString notes = folder.filePath(name);
    auto lock = project::HolderLock::take(QDir(notes).filePath(kLock).toStdString()).lock;
    if (!lock) continue;  // its window is open
    const RecoveryOffer offer = read_offer(notes);
    lock.reset();
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
  const bool set_back = seconds < -60;  // the clock, since then
  if (seconds < 60 && !set_back) return RecoveryText::tr("less than a minute ago");
  if (seconds < 3600 && !set_back) return RecoveryText::tr("%n minute(s) ago", nullptr, static_cast<int>(seconds / 60));
  if (seconds < 24 * 3600 && !set_back)
    return RecoveryText::tr("%n hour(s) ago", nullptr, static_cast<int>(seconds / 3600));
  return QLocale().toString(then.toLocalTime(), QLocale::ShortFormat);
}

}  // namespace remount::gui
