#include "widgets/import/import_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/basics/press_on_purpose.h"
#include "widgets/basics/rows.h"
#include "widgets/basics/screen_room.h"
#include "widgets/basics/shrinking_area.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wrapping_delegate.h"
#include "widgets/import/check_list.h"
#include "widgets/import/column_table.h"
#include "widgets/import/convention_form.h"
#include "widgets/sessions/drive_map.h"
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

QLabel* wrapped_label(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  return label;
}

}  // namespace

ImportDialog::ImportDialog(QWidget* parent)
    : QDialog(parent),
      head_(wrapped_label(this)),
      no_columns_(wrapped_label(this)),
      status_(wrapped_label(this)),
      columns_(new ColumnTable(this)),
      conventions_(new ConventionForm(this)),
      checks_(new CheckList),
      map_(new DriveMap(this)) {
  setWindowTitle(tr("Import a table"));
  setWindowFlag(Qt::WindowMaximizeButtonHint);
  auto* below = new QHBoxLayout;
  below->addWidget(new ShrinkingArea(checks_, {200, 90}, this), 3);
  below->addWidget(map_, 2);
  auto* right = new QWidget(this);
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(no_columns_);
  column->addWidget(columns_, 3);
  column->addWidget(conventions_, 3);
  column->addLayout(below, 4);
  auto* split = new QSplitter(this);
  split->addWidget(make_files());
  split->addWidget(right);
  split->setStretchFactor(1, 1);
  split->setSizes({260, 1000});
  split->setChildrenCollapsible(false);
  auto* all = new QVBoxLayout(this);
  all->addWidget(head_);
  all->addWidget(split, 1);
  all->addWidget(status_);
  all->addWidget(make_buttons());
  connect(columns_, &ColumnTable::role_chosen, this, [this](std::size_t place, guesses::ColumnRole role) {
    guesses::TableChoices choices = choices_;
    give_role(table_->table, choices, place, role);
    choose(choices);
  });
  connect(conventions_, &ConventionForm::edited, this, &ImportDialog::choose);
  auto* help = new QShortcut(QKeySequence::HelpContents, this);
  connect(help, &QShortcut::activated, this, &ImportDialog::help_requested);
  resize(within_screen(*this, {1320, 720}));
  show_looking({});
}

QWidget* ImportDialog::make_files() {
  auto* side = new QWidget(this);
  files_ = new QTreeWidget(side);
  files_->setHeaderHidden(true);
  files_->setRootIsDecorated(false);
  files_->setIndentation(10);
  files_->setWordWrap(true);
  files_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  files_->setItemDelegate(new WrappingDelegate(*files_));
  files_->setAccessibleName(tr("Files that were found"));
  files_->setMinimumWidth(190);
  connect(files_, &QTreeWidget::itemChanged, this, &ImportDialog::take_check);
  connect(files_, &QTreeWidget::itemClicked, this, &ImportDialog::ask_for_table);
  connect(files_, &QTreeWidget::itemActivated, this, &ImportDialog::ask_for_table);
  auto* folder = new QPushButton(tr("Add &folder…"), side);
  folder->setToolTip(tr("Scans or tables that lie elsewhere"));
  auto* more = new QPushButton(tr("Add fi&les…"), side);
  for (QPushButton* button : {folder, more}) press_on_purpose(*button);
  connect(folder, &QPushButton::clicked, this, &ImportDialog::folder_requested);
  connect(more, &QPushButton::clicked, this, &ImportDialog::files_requested);
  auto* row = new QHBoxLayout;
  row->addWidget(folder);
  row->addWidget(more);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(files_, 1);
  column->addLayout(row);
  return side;
}

QWidget* ImportDialog::make_buttons() {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  reset_ = buttons->addButton(tr("As guessed"), QDialogButtonBox::ResetRole);
  reset_->setToolTip(tr("Takes back what was changed here"));
  save_ = buttons->addButton(tr("&Save manifest…"), QDialogButtonBox::ActionRole);
  save_->setToolTip(tr("Writes what stands here as session.yaml: the folder then opens as any other session"));
  open_ = buttons->addButton(tr("Save and &open"), QDialogButtonBox::ActionRole);
  for (QPushButton* button : {reset_, save_}) press_on_purpose(*button);
  open_->setDefault(true);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(save_, &QPushButton::clicked, this, &ImportDialog::save_requested);
  connect(open_, &QPushButton::clicked, this, &ImportDialog::open_requested);
  connect(reset_, &QPushButton::clicked, this, [this] {
    left_out_.clear();
    fill_files();
    if (table_)
      choose(table_->preset);
    else
      emit edited();
  });
  return buttons;
}

void ImportDialog::show_looking(const QString& where) {
  head_->setText(where.isEmpty() ? QString() : tr("Looking at %1…").arg(where));
  data_.reset();
  table_.reset();
  whole_ = read_ = false;
  left_out_.clear();
  filling_ = true;
  files_->clear();
  filling_ = false;
  for (QWidget* widget : {static_cast<QWidget*>(columns_), static_cast<QWidget*>(conventions_)}) widget->hide();
  no_columns_->hide();
  checks_->show_text({});
  map_->show_drive(nullptr, {});
  show_note({});
  show_state();
}

void ImportDialog::show_problem(const QString& what) {
  show_looking({});
  head_->setText(severity_sign(drive::Severity::Problem) + ' ' + what);
}

QString ImportDialog::shown_path(const fs::path& path) const {
  const fs::path relative = path.lexically_relative(data_->folder);
  const bool below = !relative.empty() && *relative.begin() != "..";
  return QString::fromStdString(below ? relative.string() : path.string());
}

void ImportDialog::show_data(std::shared_ptr<const guesses::ImportData> found) {
  data_ = std::move(found);
  left_out_.clear();
  const QString opens = data_->opens_as.empty()
                            ? QString()
                            : ' ' + tr("It opens without an import, too: %1").arg(model_text(data_->opens_as));
  head_->setText(tr("Say above each column what it is; the checks below compare it with the drive at every change.") +
                 opens);
  if (data_->table) {
    show_table(*data_->table);
  } else {
    table_.reset();
    choices_ = {};
    no_columns_->setText(data_->description.ins
                             ? tr("%1 says itself what it holds: there are no columns to choose.")
                                   .arg(shown_path(data_->description.ins->file))
                             : tr("No table with columns enough for time, position and attitude was found."));
    no_columns_->show();
    columns_->hide();
    conventions_->hide();
  }
  fill_files();
  show_state();
}

void ImportDialog::show_table(const guesses::ImportTable& table) {
  table_ = table;
  choices_ = table.preset;
  no_columns_->hide();
  columns_->show_table(table);
  columns_->show_roles(choices_.roles);
  conventions_->show_table(table);
  columns_->show();
  conventions_->show();
  mark_table();
  show_state();
}

void ImportDialog::choose(const guesses::TableChoices& choices) {
  choices_ = choices;
  columns_->show_roles(choices.roles);
  conventions_->show_choices(choices);
  show_note({});
  show_state();
  emit edited();
}

QTreeWidgetItem* ImportDialog::add_heading(const QString& title) {
  auto* heading = new QTreeWidgetItem(files_, {title});
  heading->setFlags(Qt::ItemIsEnabled);
  QFont bold = files_->font();
  bold.setBold(true);
  heading->setFont(0, bold);
  heading->setExpanded(true);
  return heading;
}

void ImportDialog::fill_files() {
  filling_ = true;
  files_->clear();
  if (data_) {
    add_tables();
    add_scans();
    add_not_used();
    files_->expandAll();
  }
  filling_ = false;
  mark_table();
}

void ImportDialog::add_tables() {
  QTreeWidgetItem* heading = add_heading(tr("Motion of the INS"));
  const auto add = [&](const fs::path& file) {
    auto* item = new QTreeWidgetItem(heading, {shown_path(file)});
    item->setData(0, kFileRole, QString::fromStdString(file.string()));
    item->setToolTip(0, QString::fromStdString(file.string()));
  };
  const guesses::Description& found = data_->description;
  if (found.ins && std::ranges::find(data_->tables, found.ins->file) == data_->tables.end()) add(found.ins->file);
  for (const fs::path& file : data_->tables) add(file);
  if (heading->childCount() == 0) new QTreeWidgetItem(heading, {tr("none was found")});
}

void ImportDialog::add_scans() {
  QTreeWidgetItem* heading = add_heading(tr("Scans"));
  const std::vector<guesses::ScansGuess>& lidars = data_->description.lidars;
  for (std::size_t i = 0; i < lidars.size(); ++i) {
    auto* item = new QTreeWidgetItem(heading, {shown_path(lidars[i].directory) + '\n' + scans_words(lidars[i])});
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(0, left_out_.contains(i) ? Qt::Unchecked : Qt::Checked);
    item->setData(0, kLidarRole, qt_count(i));
  }
  if (lidars.empty()) new QTreeWidgetItem(heading, {tr("none were found: add the folder that holds them")});
}

void ImportDialog::add_not_used() {
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

/// The file in use is written boldly.
void ImportDialog::mark_table() {
  if (!data_ || files_->topLevelItemCount() == 0) return;
  filling_ = true;
  const std::string used = table_                   ? table_->file.string()
                           : data_->description.ins ? data_->description.ins->file.string()
                                                    : std::string();
  QTreeWidgetItem* heading = files_->topLevelItem(0);
  for (int i = 0; i < heading->childCount(); ++i) {
    QTreeWidgetItem* item = heading->child(i);
    const bool is_used = !used.empty() && item->data(0, kFileRole).toString().toStdString() == used;
    const QString name = shown_path(fs::path(item->data(0, kFileRole).toString().toStdString()));
    if (!item->data(0, kFileRole).toString().isEmpty())
      item->setText(0, is_used ? QStringLiteral("● ") + name : QStringLiteral("○ ") + name);
    QFont font = files_->font();
    font.setBold(is_used);
    item->setFont(0, font);
    if (is_used) files_->setCurrentItem(item);
  }
  filling_ = false;
}

void ImportDialog::take_check(QTreeWidgetItem* item) {
  if (filling_ || !item->data(0, kLidarRole).isValid()) return;
  const auto lidar = static_cast<std::size_t>(item->data(0, kLidarRole).toInt());
  if (item->checkState(0) == Qt::Checked)
    left_out_.erase(lidar);
  else
    left_out_.insert(lidar);
  show_note({});
  show_state();
  emit edited();
}

void ImportDialog::ask_for_table(QTreeWidgetItem* item) {
  const QString file = item->data(0, kFileRole).toString();
  const bool is_table = data_ && std::ranges::find(data_->tables, fs::path(file.toStdString())) != data_->tables.end();
  if (is_table && (!table_ || table_->file != fs::path(file.toStdString()))) emit table_requested(file);
}

void ImportDialog::show_checking() {
  whole_ = read_ = false;
  checks_->setEnabled(false);
  show_state();
}

void ImportDialog::show_checks(const guesses::ImportChecks& checks, const std::vector<Message>& missing) {
  checks_->setEnabled(true);
  if (table_)
    checks_->show_checks(checks);
  else
    checks_->show_text({});
  map_->show_drive(
      checks.drive.track_m.empty() ? nullptr : std::make_shared<const overview::DriveOverview>(checks.drive), {});
  QStringList lines;
  if (!table_ || checks.samples > 0)
    for (const Message& one : missing) lines << model_text(one);
  if (!lines.isEmpty()) {
    show_note(tr("It cannot be opened yet: %1").arg(lines.join(QStringLiteral("; "))));
    set_style(*status_, text_in(bad_color));
  } else if (status_->property("missing").toBool()) {
    show_note({});
  }
  status_->setProperty("missing", !lines.isEmpty());
  read_ = table_ ? checks.samples > 0 : data_ && (data_->description.ins || !data_->description.lidars.empty());
  whole_ = missing.empty() && read_;
  show_state();
}

void ImportDialog::leave_out(const std::set<std::size_t>& lidars) {
  if (lidars == left_out_) return;
  left_out_ = lidars;
  fill_files();
  show_state();
}

void ImportDialog::set_saving(bool saving) {
  saving_ = saving;
  if (saving) focus_before_saving_ = focusWidget();
  setEnabled(!saving);
  if (!saving && focus_before_saving_) focus_before_saving_->setFocus();
}

void ImportDialog::reject() {
  if (!saving_ && !held_) QDialog::reject();
}

void ImportDialog::show_note(const QString& text) {
  set_style(*status_, [](const QPalette&) { return QString(); });
  status_->setText(text);
  status_->setVisible(!text.isEmpty());
}

void ImportDialog::show_state() {
  if (!open_) return;
  open_->setEnabled(whole_);
  save_->setEnabled(read_);
  reset_->setEnabled(!left_out_.empty() || (table_ && choices_ != table_->preset));
}

}  // namespace remount::widgets
