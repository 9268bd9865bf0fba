#include "widgets/import/import_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/basics/press_on_purpose.h"
#include "widgets/basics/screen_room.h"
#include "widgets/basics/shrinking_area.h"
#include "widgets/basics/theme.h"
#include "widgets/import/check_list.h"
#include "widgets/import/column_table.h"
#include "widgets/import/convention_form.h"
#include "widgets/import/found_files_tree.h"
#include "widgets/sessions/drive_map.h"
#include "widgets/text/model_text.h"

namespace remount::widgets {
namespace {

namespace fs = std::filesystem;

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
      about_table_(wrapped_label(this)),
      status_(wrapped_label(this)),
      columns_(new ColumnTable(this)),
      conventions_(new ConventionForm(this)),
      checks_(new CheckList),
      map_(new DriveMap(this)) {
  setWindowTitle(tr("Import a table"));
  setWindowFlag(Qt::WindowMaximizeButtonHint);
  map_->set_hint(tr("The drive appears here as soon as it is read."));
  auto* below = new QHBoxLayout;
  below->addWidget(new ShrinkingArea(checks_, {200, 90}, this), 3);
  below->addWidget(map_, 2);
  auto* right = new QWidget(this);
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(about_table_);
  column->addWidget(columns_, 3);
  column->addWidget(conventions_, 6);
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
  connect(checks_, &CheckList::offset_requested, this, [this](qint64 added_ns) {
    guesses::TableChoices choices = choices_;
    choices.offset_ns += added_ns;
    choose(choices);
  });
  auto* help = new QShortcut(QKeySequence::HelpContents, this);
  connect(help, &QShortcut::activated, this, &ImportDialog::help_requested);
  resize(within_screen(*this, {1320, 720}));
  show_looking({});
}

QWidget* ImportDialog::make_files() {
  auto* side = new QWidget(this);
  files_ = new FoundFilesTree(side);
  connect(files_, &FoundFilesTree::lidar_checked, this, &ImportDialog::check_lidar);
  connect(files_, &FoundFilesTree::motion_chosen, this, &ImportDialog::choose_motion,
          Qt::QueuedConnection);  // the list is made anew
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
    show_files();
    if (table_)
      choose(table_->preset);
    else
      emit edited();
  });
  return buttons;
}

void ImportDialog::show_looking(const QString& where) {
  head_->show();
  head_->setText(where.isEmpty() ? QString() : tr("Looking at %1…").arg(where));
  data_.reset();
  table_.reset();
  whole_ = read_ = false;
  left_out_.clear();
  show_files();
  for (QWidget* widget : {static_cast<QWidget*>(columns_), static_cast<QWidget*>(conventions_)}) widget->hide();
  about_table_->hide();
  checks_->show_text({});
  map_->show_drive(nullptr, {});
  show_note({});
  show_state();
}

void ImportDialog::show_problem(const QString& what) {
  show_looking({});
  head_->setText(severity_sign(drive::Severity::Problem) + ' ' + what);
}

void ImportDialog::show_data(std::shared_ptr<const guesses::ImportData> found) {
  data_ = std::move(found);
  left_out_.clear();
  if (data_->table)
    show_table(*data_->table);
  else
    show_no_table();
}

void ImportDialog::show_no_table() {
  table_.reset();
  choices_ = {};
  columns_->hide();
  conventions_->hide();
  show_files();
  show_about();
  show_state();
}

/// What is to be done; where there are no columns, why; of those of a LiDAR that they are.
void ImportDialog::show_about() {
  const guesses::Description& found = data_->description;
  QStringList head;
  if (table_)
    head << tr("Say above each column what it is; the checks below compare it with the drive at every change.");
  if (!data_->opens_as.empty()) head << tr("It opens without an import, too: %1").arg(model_text(data_->opens_as));
  head_->setText(head.join(' '));
  head_->setVisible(!head.isEmpty());
  const bool lidars = table_ && is_of_lidar(found, table_->file);
  QString about;
  if (lidars)
    about = tr("%1 was taken for the poses of a LiDAR, and cannot be both: as the motion of the INS it needs scans or "
               "poses "
               "of another LiDAR beside it.")
                .arg(files_->shown_path(table_->file));
  else if (!table_ && found.ins && found.ins->attitude)
    about = tr("Positions from %1 and attitudes from %2 are joined by their times. There are no columns to choose: "
               "what was "
               "found, and how sure it is, stands as comments in the session.yaml that is saved.")
                .arg(files_->shown_path(found.ins->file), files_->shown_path(found.ins->attitude->file));
  else if (!table_ && found.ins)
    about =
        tr("%1 says itself what it holds: there are no columns to choose.").arg(files_->shown_path(found.ins->file));
  else if (!table_ && !data_->tables.empty())
    about =
        tr("No motion of the INS was found. Add it; or choose the poses on the left, if they are those of the INS.");
  else if (!table_)
    about = tr("No table with columns enough for time, position and attitude was found.");
  about_table_->setText(about);
  about_table_->setVisible(!about.isEmpty());
  set_style(*about_table_, lidars ? text_in(warning_color) : Style([](const QPalette&) { return QString(); }));
}

void ImportDialog::show_table(const guesses::ImportTable& table) {
  table_ = table;
  choices_ = table.preset;
  columns_->show_table(table);
  columns_->show_roles(choices_.roles);
  conventions_->show_table(table);
  columns_->show();
  conventions_->show();
  show_files();
  show_about();
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

void ImportDialog::show_files() {
  const fs::path used = table_                            ? table_->file
                        : data_ && data_->description.ins ? data_->description.ins->file
                                                          : fs::path();
  files_->show_files(data_, used, left_out_);
}

void ImportDialog::check_lidar(std::size_t lidar, bool used) {
  if (used)
    left_out_.erase(lidar);
  else
    left_out_.insert(lidar);
  show_note({});
  show_state();
  emit edited();
}

/// A log has no columns: it is taken as it is.
void ImportDialog::choose_motion(const QString& file) {
  if (std::ranges::find(data_->tables, fs::path(file.toStdString())) != data_->tables.end())
    return emit table_requested(file);
  emit log_chosen();
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
  read_ = table_ ? checks.samples > 0 : data_ && data_->description.ins;
  whole_ = missing.empty() && read_;
  show_state();
}

void ImportDialog::leave_out(const std::set<std::size_t>& lidars) {
  if (lidars == left_out_) return;
  left_out_ = lidars;
  show_files();
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
