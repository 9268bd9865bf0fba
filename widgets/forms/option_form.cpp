#include "widgets/forms/option_form.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStyle>
#include <algorithm>
#include <cmath>

#include "widgets/basics/wheel_scrolls.h"
#include "widgets/forms/choice_words.h"
#include "widgets/text/readable.h"

namespace remount::widgets {

int decimals_for(const OptionField& field, AngleUnit unit) {
  if (is_angle(field) && unit == AngleUnit::Radians) return 6;
  double smallest = field.minimum > 0.0 ? field.minimum : 0.001;
  // A default finer than that is not rounded away.
  if (field.value.toDouble() > 0.0) smallest = std::min(smallest, std::abs(field.value.toDouble()));
  return std::clamp(static_cast<int>(std::ceil(-std::log10(smallest))), 2, 6);
}

void show_in_editor(QWidget& editor, const OptionField& field, AngleUnit unit) {
  const QSignalBlocker quiet(&editor);
  if (auto* box = qobject_cast<QCheckBox*>(&editor)) box->setChecked(field.value.toBool());
  if (auto* spin = qobject_cast<QSpinBox*>(&editor)) spin->setValue(field.value.toInt());
  if (auto* spin = qobject_cast<QDoubleSpinBox*>(&editor))
    spin->setValue(on_screen(field, field.value.toDouble(), unit));
  if (auto* line = qobject_cast<QLineEdit*>(&editor)) line->setText(field.value.toString());
  if (auto* combo = qobject_cast<QComboBox*>(&editor)) combo->setCurrentIndex(field.value.toInt());
}

OptionForm::OptionForm(const QString& section, const settings::Settings& settings, QWidget* parent)
    : QWidget(parent), section_(section) {
  auto* layout = new QFormLayout(this);
  for (const OptionField& field : option_fields(settings)) {
    if (field.section != section_) continue;
    QWidget* editor = make_editor(field);
    if (!qobject_cast<QLineEdit*>(editor)) let_wheel_scroll(*editor);
    editor->setToolTip(option_help(field));
    editor->setAccessibleName(option_label(field));
    editor->setAccessibleDescription(option_help(field));
    editor->setObjectName(section_ + '.' + field.name);
    show_in_editor(*editor, field);
    layout->addRow(field.kind == OptionKind::Switch ? QString() : option_label(field), editor);
    if (QWidget* label = layout->labelForField(editor)) label->setToolTip(option_help(field));
    editors_[field.name] = editor;
  }
}

void OptionForm::show_settings(const settings::Settings& settings) {
  for (const OptionField& field : option_fields(settings)) {
    if (field.section != section_) continue;
    const auto editor = editors_.find(field.name);
    if (editor != editors_.end()) show_in_editor(*editor->second, field, angle_unit_);
  }
}

void OptionForm::set_limits(QDoubleSpinBox& spin, const OptionField& field) const {
  const auto shown = [&](double value) { return on_screen(field, value, angle_unit_); };
  spin.setDecimals(decimals_for(field, angle_unit_));
  spin.setRange(shown(field.minimum), shown(field.maximum));
  spin.setSingleStep(std::max(std::pow(10.0, -spin.decimals()), 0.1 * std::abs(shown(field.value.toDouble()))));
  spin.setSuffix(screen_suffix(field, angle_unit_));
}

void OptionForm::set_angle_unit(AngleUnit unit, const settings::Settings& settings) {
  angle_unit_ = unit;
  for (const OptionField& field : option_fields(settings)) {
    const auto editor = editors_.find(field.name);
    if (field.section != section_ || !is_angle(field) || editor == editors_.end()) continue;
    auto* spin = qobject_cast<QDoubleSpinBox*>(editor->second);
    if (!spin) continue;
    const QSignalBlocker quiet(spin);
    set_limits(*spin, field);
  }
  show_settings(settings);
}

QWidget* OptionForm::make_editor(const OptionField& field) {
  const auto send = [this, name = field.name](const QVariant& value) { emit edited(section_, name, value); };
  const QString suffix = screen_suffix(field);
  switch (field.kind) {
    case OptionKind::Switch: {
      auto* box = new QCheckBox(option_label(field), this);
      keep_box_visible(*box);
      connect(box, &QCheckBox::toggled, this, send);
      return box;
    }
    case OptionKind::Integer: {
      auto* spin = new QSpinBox(this);
      spin->setRange(static_cast<int>(field.minimum), static_cast<int>(field.maximum));
      spin->setSuffix(suffix);
      spin->setKeyboardTracking(false);
      connect(spin, &QSpinBox::valueChanged, this, send);
      return spin;
    }
    case OptionKind::Real: {
      auto* spin = new QDoubleSpinBox(this);
      set_limits(*spin, field);
      spin->setKeyboardTracking(false);
      connect(spin, &QDoubleSpinBox::valueChanged, this,
              [this, send, field](double shown) { send(from_screen(field, shown, angle_unit_)); });
      return spin;
    }
    case OptionKind::Choice: {
      auto* combo = new QComboBox(this);
      for (const QString& key : field.choices) {
        combo->addItem(choice_words(field, key));
        combo->setItemData(combo->count() - 1, tr("In files: %1").arg(key), Qt::ToolTipRole);
      }
      connect(combo, &QComboBox::currentIndexChanged, this, send);
      return combo;
    }
    case OptionKind::Text:
      break;
  }
  auto* line = new QLineEdit(this);
  const bool is_file = field.name == QLatin1String("file");
  // Projects and results keep it, wherever they are opened.
  const auto meant = [is_file](const QString& text) {
    return is_file && !text.isEmpty() ? QFileInfo(text).absoluteFilePath() : text;
  };
  connect(line, &QLineEdit::editingFinished, this, [line, send, meant] { send(meant(line->text())); });
  if (is_file) offer_files(*line, field);
  return line;
}

void OptionForm::offer_files(QLineEdit& line, const OptionField& field) {
  QAction* choose = line.addAction(style()->standardIcon(QStyle::SP_DialogOpenButton), QLineEdit::TrailingPosition);
  choose->setText(tr("Choose a file"));
  connect(choose, &QAction::triggered, this, [this, &line, field] {
    const QString path = QFileDialog::getOpenFileName(this, option_label(field), line.text());
    if (path.isEmpty()) return;
    line.setText(path);
    emit edited(section_, field.name, path);
  });
}

}  // namespace remount::widgets
