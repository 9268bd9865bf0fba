#include "algorithms/messages/catalogue.h"

#include <algorithm>

namespace remount {

const CatalogueEntry* find_in_catalogue(std::string_view code) {
  const std::span<const CatalogueEntry> all = catalogue();
  const auto found = std::lower_bound(all.begin(), all.end(), code,
                                      [](const CatalogueEntry& entry, std::string_view it) { return entry.code < it; });
  return found == all.end() || found->code != code ? nullptr : &*found;
}

}  // namespace remount
