// Lists of which some are taken out, and the numbers of the rest.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace remount {

/// Where each of `count` things stands once those that do not stay are taken out; nothing of those.
template <class Place, class Stays>
std::vector<std::optional<Place>> places_of_rest(std::size_t count, const Stays& stays) {
  std::vector<std::optional<Place>> places(count);
  Place next;
  for (Place i; i < count; ++i)
    if (stays(i)) places[i] = next++;
  return places;
}

}  // namespace remount
