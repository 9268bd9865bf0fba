// Between places in lists and the rows of Qt's models, which are int and -1 for none.
#pragma once

#include <optional>

#include "algorithms/core/index.h"

namespace remount::widgets {

/// A size as Qt counts: rows and columns of tables, and numbers in sentences, are no more than an int holds.
inline int qt_count(std::size_t size) { return static_cast<int>(size); }

template <class Counted>
int qt_row(Index<Counted> place) {
  return static_cast<int>(signed_of(place));
}

/// -1 for none.
template <class Counted>
int qt_row(const std::optional<Index<Counted>>& place) {
  return place ? qt_row(*place) : -1;
}

/// What stands in a row that there is; nothing for the -1 of Qt.
template <class Place>
std::optional<Place> at_row(int row) {
  return row < 0 ? std::nullopt : std::optional(index_at<Place>(row));
}

}  // namespace remount::widgets
