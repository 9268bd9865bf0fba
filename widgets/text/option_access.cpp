#include "widgets/text/option_access.h"

#include <algorithm>
#include <type_traits>

#include "algorithms/geometry/rotation.h"
#include "widgets/text/model_text.h"

namespace remount::widgets {
namespace {

/// Visits every option with one function: edit(section, OptionField without value, reference to the member).
template <class Edit>
struct FieldVisitor {
  QString section;
  Edit& edit;

  OptionField describe(const OptionInfo& info) const {
    OptionField field;
    field.section = section;
    field.name = QString::fromUtf8(info.name);
    field.unit = QString::fromUtf8(info.unit);
    field.label = info.label;
    field.help = info.help;
    field.minimum = info.minimum;
    field.maximum = info.maximum;
    return field;
  }

  template <class T>
  void operator()(const OptionInfo& info, T& member) const {
    using Value = std::remove_const_t<T>;
    OptionField field = describe(info);
    if constexpr (std::is_same_v<Value, bool>) {
      field.kind = OptionKind::Switch;
      field.value = member;
      edit(field, [&](const QVariant& v) {
        if constexpr (!std::is_const_v<T>) member = v.toBool();
      });
    } else if constexpr (std::is_integral_v<Value>) {
      field.kind = OptionKind::Integer;
      field.value = static_cast<int>(member);
      edit(field, [&](const QVariant& v) {
        if constexpr (!std::is_const_v<T>) member = static_cast<Value>(v.toInt());
      });
    } else if constexpr (std::is_floating_point_v<Value>) {
      field.value = static_cast<double>(member);
      edit(field, [&](const QVariant& v) {
        if constexpr (!std::is_const_v<T>) member = static_cast<Value>(v.toDouble());
      });
    } else {
      field.kind = OptionKind::Text;
      field.value = QString::fromStdString(member);
      edit(field, [&](const QVariant& v) {
        if constexpr (!std::is_const_v<T>) member = v.toString().toStdString();
      });
    }
  }

  template <class T>
  void choice(const OptionInfo& info, T& member, const std::vector<std::string_view>& names) const {
    OptionField field = describe(info);
    field.kind = OptionKind::Choice;
    for (std::string_view name : names) field.choices << QString::fromUtf8(name);
    field.value = static_cast<int>(member);
    edit(field, [&](const QVariant& v) {
      if constexpr (!std::is_const_v<T>) member = static_cast<std::remove_const_t<T>>(v.toInt());
    });
  }
};

template <class S, class Edit>
void visit_fields(S& settings, Edit edit) {
  settings::Settings::visit_sections(settings, [&](std::string_view section, auto& options) {
    std::remove_cvref_t<decltype(options)>::visit(options, FieldVisitor<Edit>{QString::fromUtf8(section), edit});
  });
}

bool held_in_radians(const OptionField& field) { return field.unit.section('/', 0, 0) == QLatin1String("rad"); }
bool held_in_degrees(const OptionField& field) { return field.unit.section('/', 0, 0) == QLatin1String("deg"); }

}  // namespace

bool is_angle(const OptionField& field) { return held_in_radians(field) || held_in_degrees(field); }

std::vector<OptionField> option_fields(const settings::Settings& settings) {
  std::vector<OptionField> fields;
  visit_fields(settings, [&](const OptionField& field, auto&&) { fields.push_back(field); });
  return fields;
}

bool set_option(settings::Settings& settings, const QString& section, const QString& name, const QVariant& value) {
  bool found = false;
  visit_fields(settings, [&](const OptionField& field, auto&& assign) {
    if (field.section != section || field.name != name) return;
    assign(value);
    found = true;
  });
  return found;
}

double on_screen(const OptionField& field, double value, AngleUnit unit) {
  if (held_in_radians(field) && unit == AngleUnit::Degrees) return radians_to_degrees(value);
  if (held_in_degrees(field) && unit == AngleUnit::Radians) return degrees_to_radians(value);
  return value;
}

double from_screen(const OptionField& field, double shown, AngleUnit unit) {
  double value = shown;
  if (held_in_radians(field) && unit == AngleUnit::Degrees) value = degrees_to_radians(shown);
  if (held_in_degrees(field) && unit == AngleUnit::Radians) value = radians_to_degrees(shown);
  // What is shown is rounded: the largest that can be typed is the largest there is.
  return field.maximum > field.minimum ? std::clamp(value, field.minimum, field.maximum) : value;
}

QString screen_suffix(const OptionField& field, AngleUnit unit) {
  if (field.unit.isEmpty()) return {};
  if (!is_angle(field)) return ' ' + field.unit;
  const QString per = field.unit.contains('/') ? '/' + field.unit.section('/', 1) : QString();
  return (unit == AngleUnit::Degrees ? QStringLiteral("°") : QStringLiteral(" rad")) + per;
}

QString option_label(const OptionField& field) { return model_text(field.label()); }

QString option_help(const OptionField& field) { return model_text(field.help()); }

QString option_label(const settings::Settings& settings, const QString& section, const QString& name) {
  for (const OptionField& field : option_fields(settings))
    if (field.section == section && field.name == name) return option_label(field);
  return name;
}

}  // namespace remount::widgets
