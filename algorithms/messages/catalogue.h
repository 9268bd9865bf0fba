// The sentences that messages are made of, in all languages: what resources/messages/ holds, compiled in.
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace remount {

enum class Language { English, Chinese };
inline constexpr std::size_t kLanguages = 2;
/// As they are named in settings, on the command line and by translations of the window.
inline constexpr std::array<std::string_view, kLanguages> kLanguageTags{"en", "zh_CN"};

/// One sentence. Its places are as in resources/messages/README.md; those of the first language say how values are
/// shown.
struct CatalogueEntry {
  std::string_view code;
  std::array<std::string_view, kLanguages> text;
  bool advises = false;  ///< says itself what was expected or what to do
};

/// All of them, ordered by code.
std::span<const CatalogueEntry> catalogue();

/// @return null where there is none: a file may be of a later version
const CatalogueEntry* find_in_catalogue(std::string_view code);

class Message;

/// Whether a message says itself what was expected or what to do, so that nobody has to add it: one whose entry is
/// marked so, one that goes on after its first sentence, and one that holds such a message.
bool advises(const Message& message);

/// Codes that stand in no catalogue, for they have no words of their own, and the name of their one place.
inline constexpr std::string_view kVerbatim = "verbatim", kSequence = "sequence", kOnlyPlace = "words";

}  // namespace remount
