#include "widgets/forms/option_changes.h"

#include <QCoreApplication>

#include "model/project/project.h"
#include "widgets/forms/choice_words.h"
#include "widgets/text/option_access.h"
#include "widgets/text/section_words.h"

namespace remount::widgets {
namespace {

struct ChangeText {
  Q_DECLARE_TR_FUNCTIONS(remount::widgets::option_changes)
};

QString value_text(const OptionField& field) {
  switch (field.kind) {
    case OptionKind::Switch:
      return field.value.toBool() ? ChangeText::tr("on") : ChangeText::tr("off");
    case OptionKind::Integer:
      return field.value.toString() + screen_suffix(field);
    case OptionKind::Real:
      return QString::number(on_screen(field, field.value.toDouble()), 'g', 7) + screen_suffix(field);
    case OptionKind::Choice:
      return choice_words(field, field.choices.value(field.value.toInt()));
    case OptionKind::Text:
      break;
  }
  return field.value.toString().isEmpty() ? QStringLiteral("–") : field.value.toString();
}

}  // namespace

QStringList setting_changes(const settings::Settings& then, const settings::Settings& now) {
  const std::vector<OptionField> before = option_fields(then), after = option_fields(now);
  QStringList changes;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const OptionField &old = before[i], &present = after[i];
    if (old.value != present.value && project::affects_result(old.section.toStdString(), old.name.toStdString()))
      changes << ChangeText::tr("%1 (%2): %3, now %4")
                     .arg(option_label(old), section_title(old.section), value_text(old), value_text(present));
  }
  return changes;
}

}  // namespace remount::widgets
