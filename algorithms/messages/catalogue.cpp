#include "algorithms/messages/catalogue.h"

#include <algorithm>

#include "algorithms/messages/message.h"

namespace remount {
namespace {

bool part_advises(const Argument& argument) {
  if (const auto* message = std::get_if<Message>(&argument.value)) return advises(*message);
  const auto* several = std::get_if<std::vector<Message>>(&argument.value);
  return several != nullptr && std::any_of(several->begin(), several->end(), advises);
}

}  // namespace

const CatalogueEntry* find_in_catalogue(std::string_view code) {
  const std::span<const CatalogueEntry> all = catalogue();
  const auto found = std::lower_bound(all.begin(), all.end(), code,
                                      [](const CatalogueEntry& entry, std::string_view it) { return entry.code < it; });
  return found == all.end() || found->code != code ? nullptr : &*found;
}

bool advises(const Message& message) {
  if (message.code() == kSequence) return true;
  const CatalogueEntry* entry = find_in_catalogue(message.code());
  return (entry != nullptr && entry->advises) ||
         std::any_of(message.arguments().begin(), message.arguments().end(), part_advises);
}

}  // namespace remount
