#include "widgets/sessions/topics_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/basics/press_on_purpose.h"
#include "widgets/basics/rows.h"
#include "widgets/basics/screen_room.h"
#include "widgets/basics/theme.h"
#include "widgets/text/model_text.h"
#include "widgets/text/sentences.h"
#include "widgets/text/topic_role_words.h"

namespace remount::widgets {
namespace {

enum Column { Topic, Type, Messages, Rate, ServesAs, UsedAs, Why, ColumnCount };

drive::TopicChoice in_use(const std::vector<drive::OfferedTopic>& topics) {
  std::vector<drive::SessionTopic> listed;
  for (const drive::OfferedTopic& offered : topics) listed.push_back(offered.topic);
  return drive::choice_in_use(listed);
}

QString text_of(const std::string& text) { return QString::fromStdString(text); }

}  // namespace

TopicsDialog::TopicsDialog(const QString& recording, std::vector<drive::OfferedTopic> topics, QWidget* parent)
    : QDialog(parent),
      topics_(std::move(topics)),
      suggested_(in_use(topics_)),
      table_(make_table()),
      problem_(new QLabel(this)) {
  setWindowTitle(tr("Topics of %1").arg(recording));
  auto* head = new QLabel(tr("Which topics is the session made of? The most likely ones are selected; the table says "
                             "what speaks for each. A project keeps the choice."),
                          this);
  head->setWordWrap(true);
  const auto lidars = std::ranges::count_if(
      topics_, [](const drive::OfferedTopic& offered) { return offered.use("lidar") != nullptr; });
  if (lidars > 1)
    head->setText(one_text({head->text(), tr("Of several LiDARs choose the one that is shown first: the panel “LiDARs” "
                                             "calibrates all of them together.")}));
  auto* grid = new QGridLayout;
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(2, 1);
  for (const std::string_view role : drive::kTopicRoles) add_row(*grid, role);
  problem_->setWordWrap(true);
  problem_->setAccessibleName(tr("What prevents it"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  reset_ = buttons->addButton(tr("As it was"), QDialogButtonBox::ResetRole);
  press_on_purpose(*reset_);
  reset_->setToolTip(tr("Selects again what was selected when this was opened"));
  open_ = buttons->addButton(tr("Open"), QDialogButtonBox::AcceptRole);
  open_->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(reset_, &QPushButton::clicked, this, [this] {
    for (const auto& [role, topic] : suggested_) choose(role, topic);
  });
  auto* column = new QVBoxLayout(this);
  column->addWidget(head);
  column->addLayout(grid);
  column->addWidget(problem_);
  column->addWidget(table_, 1);
  column->addWidget(buttons);
  fill_table();
  show_choice();
  resize(within_screen(*this, {1020, 560}));
  if (!rows_.empty()) rows_.front().topics->setFocus();
}

void TopicsDialog::add_row(QGridLayout& grid, std::string_view role) {
  if (std::none_of(topics_.begin(), topics_.end(),
                   [&](const drive::OfferedTopic& offered) { return offered.use(role); }))
    return;
  auto* topics = new QComboBox(this);
  for (const drive::OfferedTopic& offered : topics_)
    if (offered.use(role)) topics->addItem(text_of(offered.topic.name), text_of(offered.topic.name));
  topics->addItem(tr("none"), text_of(std::string(drive::kNoTopic)));
  topics->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  topics->setAccessibleName(tr("Topic that serves as %1").arg(role_name(role)));
  auto* label = new QLabel(role_label(role), this);
  label->setBuddy(topics);
  auto* why = new QLabel(this);
  why->setWordWrap(true);
  const int line = qt_count(rows_.size());
  grid.addWidget(label, line, 0);
  grid.addWidget(topics, line, 1);
  grid.addWidget(why, line, 2);
  rows_.push_back({std::string(role), topics, why});
  const auto suggested = suggested_.find(role);
  choose(role, suggested == suggested_.end() ? std::string(drive::kNoTopic) : suggested->second);
  connect(topics, &QComboBox::currentIndexChanged, this, &TopicsDialog::show_choice);
}

QTreeWidget* TopicsDialog::make_table() {
  auto* table = new QTreeWidget(this);
  table->setColumnCount(ColumnCount);
  table->setHeaderLabels({tr("Topic"), tr("Type"), tr("Messages"), tr("Rate"), tr("Can serve as"), tr("Serves as"),
                          tr("What speaks for or against it")});
  table->setRootIsDecorated(false);
  table->setUniformRowHeights(true);
  table->setAllColumnsShowFocus(true);
  table->setAlternatingRowColors(true);
  table->setAccessibleName(tr("All topics of the recording"));
  return table;
}

void TopicsDialog::fill_table() {
  for (const drive::OfferedTopic& offered : topics_) {
    const drive::SessionTopic& topic = offered.topic;
    QStringList roles, reasons;
    for (const drive::TopicUse& use : offered.uses) {
      roles << role_name(use.role);
      const QString why = model_text(use.why);
      reasons << (offered.uses.size() > 1 ? tr("%1: %2").arg(role_name(use.role), why) : why);
    }
    if (!offered.unusable.empty()) reasons << tr("cannot be used: %1").arg(model_text(offered.unusable));
    auto* item = new QTreeWidgetItem(table_);
    item->setText(Topic, text_of(topic.name));
    item->setText(Type, text_of(topic.type));
    item->setText(Messages, QString::number(topic.count));
    item->setText(Rate, topic.rate_hz > 0.0 ? tr("%1 Hz").arg(topic.rate_hz, 0, 'f', 1) : QString());
    item->setText(ServesAs, roles.join(QStringLiteral(", ")));
    item->setText(Why, reasons.join(QStringLiteral("; ")));
    for (const int number : {Messages, Rate}) item->setTextAlignment(number, Qt::AlignRight | Qt::AlignVCenter);
    for (int column = 0; column < ColumnCount; ++column) {
      item->setToolTip(column, item->text(column));
      if (offered.uses.empty()) item->setForeground(column, palette().brush(QPalette::Disabled, QPalette::Text));
    }
  }
  table_->setCurrentItem(table_->topLevelItem(0));
}

void TopicsDialog::choose(std::string_view role, const std::string& topic) {
  if (const Row* chosen = row(role)) chosen->topics->setCurrentIndex(chosen->topics->findData(text_of(topic)));
}

const TopicsDialog::Row* TopicsDialog::row(std::string_view role) const {
  const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const Row& row) { return row.role == role; });
  return found == rows_.end() ? nullptr : &*found;
}

const drive::OfferedTopic* TopicsDialog::chosen(std::string_view role) const {
  const Row* row = this->row(role);
  const std::string name = row ? row->topics->currentData().toString().toStdString() : std::string();
  const auto found = std::find_if(topics_.begin(), topics_.end(), [&](const drive::OfferedTopic& offered) {
    return offered.topic.name == name && offered.use(role);
  });
  return found == topics_.end() ? nullptr : &*found;
}

bool TopicsDialog::completes_ins() const {
  const drive::OfferedTopic* ins = chosen("ins");
  return ins && ins->use("ins")->needs_position;
}

drive::TopicChoice TopicsDialog::choice() const {
  drive::TopicChoice choice;
  for (const Row& row : rows_)
    if (row.role != "ins-position" || completes_ins())
      choice.emplace(row.role, row.topics->currentData().toString().toStdString());
  return choice;
}

QString TopicsDialog::problem() const {
  if (chosen("lidar") && chosen("lidar") == chosen("ins"))
    return tr("One topic cannot be LiDAR and INS: a motion that is compared with itself tells nothing.");
  if (completes_ins() && !chosen("ins-position"))
    return row("ins-position") ? tr("An orientation alone is no INS: choose the topic that gives its position.")
                               : tr("An orientation alone is no INS, and no topic here gives its position: choose "
                                    "another INS, or none.");
  return {};
}

void TopicsDialog::show_choice() {
  for (const Row& row : rows_) {
    const drive::OfferedTopic* topic = chosen(row.role);
    const bool in_place = row.role != "ins-position" || completes_ins();
    row.topics->setEnabled(in_place);
    row.why->setEnabled(in_place);
    row.why->setText(!in_place ? tr("the INS gives its position itself")
                     : topic   ? model_text(topic->use(row.role)->why)
                               : tr("left out"));
  }
  for (std::size_t i = 0; i < topics_.size(); ++i) {
    QStringList used;
    for (const auto& [role, name] : choice())
      if (chosen(role) == &topics_[i]) used << role_name(role);
    if (topics_[i].use(drive::kNominalRole)) used << role_name(drive::kNominalRole);
    QTreeWidgetItem* item = table_->topLevelItem(static_cast<int>(i));
    if (!item) continue;
    item->setText(UsedAs, used.join(QStringLiteral(", ")));
    QFont font = table_->font();
    font.setBold(!used.isEmpty());
    for (const int column : {Topic, UsedAs}) item->setFont(column, font);
  }
  const QString why_not = problem();
  set_style(*problem_, text_in(bad_color));
  problem_->setText(why_not.isEmpty() ? QString() : severity_sign(drive::Severity::Problem) + ' ' + why_not);
  problem_->setVisible(!why_not.isEmpty());
  if (open_) open_->setEnabled(why_not.isEmpty());
  if (reset_) reset_->setEnabled(choice() != suggested_);
  for (int column = 0; column < ColumnCount; ++column) table_->resizeColumnToContents(column);
}

}  // namespace remount::widgets
