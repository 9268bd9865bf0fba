#include "model/formats/sessions/line_stamps.h"

#include "messages/general.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/text_file.h"

namespace remount::formats {

std::vector<std::optional<std::int64_t>> read_line_stamps(const std::filesystem::path& path,
                                                          std::optional<std::int64_t> (*parse)(std::string_view text),
                                                          const Message& expected, drive::BadItems& bad) {
  const std::string text = read_text_file(path);
  std::vector<std::optional<std::int64_t>> stamps;
  LineReader lines(text);
  for (std::string_view line; lines.next(line);) {
    stamps.push_back(parse(trim(line)));
    if (!stamps.back() && !trim(line).empty()) bad.add(say::of_file(at_line(path, lines.line_number()), expected));
  }
  while (!stamps.empty() && !stamps.back()) stamps.pop_back();
  return stamps;
}

}  // namespace remount::formats
