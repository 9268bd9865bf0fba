// What stands above the columns of a table that nobody declared.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/formats/files/declared_table.h"

namespace remount::guesses {

/// Bytes that end a line of a terminal, or a comment of a manifest, are no part of a title.
std::string shown_title(std::string_view title);

/// As many titles as there are fields, parted as the rows are, or otherwise; empty where no way fits.
std::vector<std::string> fitting_titles(std::string_view line, const formats::TableText& text, std::size_t fields);

/// Whether a manifest can name columns by that line: as its reader takes it apart, each by a word of its own.
bool names_columns(std::string_view line, const formats::TableText& text, std::size_t fields);

/// "(time in s, position in m, …)".
bool is_remark(std::string_view line);

/// Of a text that is no UTF-8: from one of the encodings that were usual before, that by which most titles are known.
void decode_titles(std::vector<std::string>& titles, std::vector<std::string>& units);

}  // namespace remount::guesses
