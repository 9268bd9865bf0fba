// What the window calls the conventions of a table.
#pragma once

#include <QString>
#include <vector>

#include "model/guesses/import_checks.h"
#include "model/guesses/table_import.h"

namespace remount::widgets {

QString style_words(guesses::AttitudeStyle style);
QString place_unit_words(formats::PlaceUnit unit);
QString time_unit_words(std::int64_t unit_ns);
QString time_scale_words(formats::TimeScale scale);
QString date_order_words(formats::DateOrder order);

/// What is otherwise: "x: north (y), y: east (x), heading, from north clockwise". Empty where nothing is.
QString difference_words(const guesses::SampledTable& table, const guesses::TableChoices& from,
                         const guesses::TableChoices& to);

/// What a guess rests on, a sentence a line; of one that is open first what keeps it so.
QString evidence_words(const guesses::Guess& guess);

}  // namespace remount::widgets
