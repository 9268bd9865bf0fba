#include "widgets/import/found_files_tree.h"

#include <algorithm>

#include "widgets/basics/rows.h"
#include "widgets/basics/wrapping_delegate.h"
#include "widgets/text/model_text.h"

namespace remount::widgets {
namespace {

namespace fs = std::filesystem;

constexpr int kFileRole = Qt::UserRole, kLidarRole = Qt::UserRole + 1;

QString scans_words(const guesses::ScansGuess& scans) {
  QStringList lines;
  for (const guesses::Guess& guess : scans.guesses)
    for (const Message& evidence : guess.evidence) lines << model_text(evidence);
  return lines.join('\n');
}

}  // namespace

FoundFilesTree::FoundFilesTree(QWidget* parent) : QTreeWidget(parent) {
  setHeaderHidden(true);
  setRootIsDecorated(false);
  setIndentation(10);
  setWordWrap(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setItemDelegate(new WrappingDelegate(*this));
  setAccessibleName(tr("Files that were found"));
  setMinimumWidth(190);
  connect(this, &QTreeWidget::itemChanged, this, &FoundFilesTree::take_check);
  connect(this, &QTreeWidget::itemClicked, this, &FoundFilesTree::take_motion);
  connect(this, &QTreeWidget::itemActivated, this, &FoundFilesTree::take_motion);
}

QString FoundFilesTree::shown_path(const fs::path& path) const {
  const fs::path relative = data_ ? path.lexically_relative(data_->folder) : fs::path();
  const bool below = !relative.empty() && *relative.begin() != "..";
  return QString::fromStdString(below ? relative.string() : path.string());
}

void FoundFilesTree::show_files(std::shared_ptr<const guesses::ImportData> found, const fs::path& used,
                                const std::set<std::size_t>& left_out) {
  data_ = std::move(found);
  used_ = used;
  filling_ = true;
  clear();
  if (data_) {
    add_motions();
    add_scans(left_out);
    add_not_used();
    expandAll();
  }
  filling_ = false;
}

QTreeWidgetItem* FoundFilesTree::add_heading(const QString& title) {
  auto* heading = new QTreeWidgetItem(this, {title});
  heading->setFlags(Qt::ItemIsEnabled);
  QFont bold = font();
  bold.setBold(true);
  heading->setFont(0, bold);
  heading->setExpanded(true);
  return heading;
}

/// The file in use is written boldly.
void FoundFilesTree::add_motions() {
  QTreeWidgetItem* heading = add_heading(tr("Motion of the INS"));
  const guesses::Description& found = data_->description;
  std::vector<fs::path> files = data_->tables;
  if (found.ins && std::ranges::find(files, found.ins->file) == files.end())
    files.insert(files.begin(), found.ins->file);
  for (const fs::path& file : files) {
    const bool in_use = file == used_;
    const QString mark = in_use ? QStringLiteral("● ") : QStringLiteral("○ ");
    const QString what = is_of_lidar(found, file) ? '\n' + tr("poses of a LiDAR") : QString();
    auto* item = new QTreeWidgetItem(heading, {mark + shown_path(file) + what});
    item->setData(0, kFileRole, QString::fromStdString(file.string()));
    item->setToolTip(0, QString::fromStdString(file.string()));
    QFont font = this->font();
    font.setBold(in_use);
    item->setFont(0, font);
    if (in_use) setCurrentItem(item);
  }
  if (files.empty()) new QTreeWidgetItem(heading, {tr("none was found")});
}

void FoundFilesTree::add_scans(const std::set<std::size_t>& left_out) {
  QTreeWidgetItem* heading = add_heading(tr("Scans"));
  const std::vector<guesses::ScansGuess>& lidars = data_->description.lidars;
  for (std::size_t i = 0; i < lidars.size(); ++i) {
    auto* item = new QTreeWidgetItem(heading, {shown_path(lidars[i].directory) + '\n' + scans_words(lidars[i])});
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    const bool is_ins = lidars[i].directory == used_;
    item->setCheckState(0, left_out.contains(i) || is_ins ? Qt::Unchecked : Qt::Checked);
    item->setData(0, kLidarRole, qt_count(i));
    item->setDisabled(is_ins);
  }
  if (lidars.empty()) new QTreeWidgetItem(heading, {tr("none were found: add the folder that holds them")});
}

void FoundFilesTree::add_not_used() {
  constexpr std::size_t kMostShown = 20;
  const std::vector<guesses::NotUsed>& all = data_->description.not_used;
  QTreeWidgetItem* heading = nullptr;
  for (std::size_t i = 0; i < std::min(all.size(), kMostShown); ++i) {
    if (std::ranges::find(data_->tables, all[i].path) != data_->tables.end()) continue;  // stands above
    if (!heading) heading = add_heading(tr("Not used"));
    auto* item = new QTreeWidgetItem(heading, {shown_path(all[i].path) + '\n' + model_text(all[i].why)});
    item->setForeground(0, palette().brush(QPalette::Disabled, QPalette::Text));
  }
}

void FoundFilesTree::take_check(QTreeWidgetItem* item) {
  if (filling_ || !item->data(0, kLidarRole).isValid()) return;
  emit lidar_checked(static_cast<std::size_t>(item->data(0, kLidarRole).toInt()), item->checkState(0) == Qt::Checked);
}

void FoundFilesTree::take_motion(QTreeWidgetItem* item) {
  const QString file = item->data(0, kFileRole).toString();
  if (!file.isEmpty() && fs::path(file.toStdString()) != used_) emit motion_chosen(file);
}

}  // namespace remount::widgets
