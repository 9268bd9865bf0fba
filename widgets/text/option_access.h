// Settings as a list of named values: what forms are generated from.
#pragma once

#include <QString>
#include <QStringList>
#include <QVariant>
#include <vector>

#include "algorithms/core/options.h"
#include "model/settings/settings.h"

namespace remount::widgets {

enum class OptionKind { Switch, Integer, Real, Text, Choice };

struct OptionField {
  QString section;  ///< "range"
  QString name;     ///< "x_min_m"
  QString unit;
  OptionText label = nullptr, help = nullptr;  ///< makers: the language may change while this is kept
  OptionKind kind = OptionKind::Real;
  double minimum = 0.0, maximum = 0.0;
  QStringList choices;
  QVariant value;  ///< bool, int, double, QString, or the index of a choice
};

/// Every option with its present value, in the order of the sections.
std::vector<OptionField> option_fields(const settings::Settings& settings);

/// Sets one option; false where there is none of that name.
bool set_option(settings::Settings& settings, const QString& section, const QString& name, const QVariant& value);

enum class AngleUnit { Degrees, Radians };

/// Whether the option is an angle (or a rate of one), in whatever unit files hold it.
bool is_angle(const OptionField& field);

/// Angles are shown in the unit that the user prefers, whatever files hold; other units stay. For a number of this
/// option, its suffix (" m", "°", " rad"), and back.
double on_screen(const OptionField& field, double value, AngleUnit unit = AngleUnit::Degrees);
double from_screen(const OptionField& field, double shown, AngleUnit unit = AngleUnit::Degrees);
QString screen_suffix(const OptionField& field, AngleUnit unit = AngleUnit::Degrees);

/// "Max gap", in the language of the window.
QString option_label(const OptionField& field);
/// What it means, likewise.
QString option_help(const OptionField& field);
/// Of the option with that name; the name itself where there is none.
QString option_label(const settings::Settings& settings, const QString& section, const QString& name);

}  // namespace remount::widgets
