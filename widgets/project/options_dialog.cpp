#include "widgets/project/options_dialog.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <algorithm>

#include "widgets/basics/press_on_purpose.h"
#include "widgets/basics/screen_room.h"
#include "widgets/basics/theme.h"
#include "widgets/text/model_text.h"
#include "widgets/text/section_words.h"

namespace remount::widgets {
namespace {

bool all_default(const settings::Settings& settings) {
  const std::vector<OptionField> present = option_fields(settings), standard = option_fields(settings::Settings{});
  return std::equal(present.begin(), present.end(), standard.begin(), standard.end(),
                    [](const OptionField& a, const OptionField& b) { return a.value == b.value; });
}

}  // namespace

OptionsDialog::OptionsDialog(const settings::Settings& settings, QWidget* parent)
    : QDialog(parent), problems_(new QLabel(this)) {
  setWindowTitle(tr("Options"));
  auto* sections = new QListWidget(this);
  sections->setAccessibleName(tr("Sections"));
  sections->setMaximumWidth(190);
  auto* pages = new QStackedWidget(this);
  QStringList seen;
  for (const OptionField& field : option_fields(settings)) {
    if (seen.contains(field.section)) continue;
    seen << field.section;
    sections->addItem(section_title(field.section));
    auto* form = new OptionForm(field.section, settings, this);
    connect(form, &OptionForm::edited, this, &OptionsDialog::edited);
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(form);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    pages->addWidget(scroll);
    forms_.push_back(form);
  }
  connect(sections, &QListWidget::currentRowChanged, pages, &QStackedWidget::setCurrentIndex);
  sections->setCurrentRow(0);
  auto* note =
      new QLabel(tr("Search range and solution apply at once; the other options apply to the next calibration. "
                    "Every change can be undone (Ctrl+Z)."),
                 this);
  note->setWordWrap(true);
  problems_->setWordWrap(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close | QDialogButtonBox::RestoreDefaults, this);
  defaults_ = buttons->button(QDialogButtonBox::RestoreDefaults);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  // Enter belongs to the field that is being edited: it presses no button here.
  for (QPushButton* button : {buttons->button(QDialogButtonBox::Close), defaults_}) press_on_purpose(*button);
  connect(defaults_, &QPushButton::clicked, this, &OptionsDialog::defaults_requested);
  auto* grid = new QGridLayout(this);
  grid->addWidget(sections, 0, 0);
  grid->addWidget(pages, 0, 1);
  grid->addWidget(problems_, 1, 0, 1, 2);
  grid->addWidget(note, 2, 0, 1, 2);
  grid->addWidget(buttons, 3, 0, 1, 2);
  grid->setColumnStretch(1, 1);
  resize(within_screen(*this, {680, 580}));
  show_settings(settings);
}

void OptionsDialog::show_settings(const settings::Settings& settings) {
  for (OptionForm* form : forms_) form->show_settings(settings);
  defaults_->setEnabled(!all_default(settings));
  QStringList problems;
  for (const Message& problem : settings.check()) problems << model_text(problem);
  problems_->setVisible(!problems.isEmpty());
  set_style(*problems_, text_in(bad_color));
  problems_->setText(problems.join('\n'));
}

void OptionsDialog::set_angle_unit(AngleUnit unit, const settings::Settings& settings) {
  for (OptionForm* form : forms_) form->set_angle_unit(unit, settings);
}

}  // namespace remount::widgets
