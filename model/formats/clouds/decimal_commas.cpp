#include "model/formats/clouds/decimal_commas.h"

#include <algorithm>
#include <cctype>

#include "model/formats/files/input_file.h"

namespace remount::formats {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// A comma between two digits, and only one.
bool has_decimal_comma(std::string_view field) {
  const std::size_t comma = field.find(',');
  return comma != std::string_view::npos && comma > 0 && comma + 1 < field.size() && is_digit(field[comma - 1]) &&
         is_digit(field[comma + 1]) && field.find(',', comma + 1) == std::string_view::npos;
}

/// Behind the comma of a decimal there is no blank, behind that of a number there is.
bool is_spaced(std::string_view line) {
  bool between = false;
  std::size_t commas = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    if (line[i] != ',') continue;
    ++commas;
    if ((line[i + 1] == ' ') != between) return false;
    between = !between;
  }
  return commas > 1;
}

}  // namespace

std::string_view decimal_comma_in(std::string_view line) {
  std::vector<std::string_view> fields;
  for (const bool by_semicolons : {true, false}) {
    if (by_semicolons)
      split_csv(line, fields, ';');
    else
      split_blanks(line, fields);
    for (const std::string_view field : fields)
      if (has_decimal_comma(field)) return field;
  }
  return {};
}

void DecimalCommas::add(std::string_view line) {
  split_csv(line, fields_);
  const bool halves = fields_.size() >= 6 && fields_.size() % 2 == 0 && fields_.size() <= kMost;
  possible_ = possible_ && halves && (rows_ == 0 || fields_.size() == before_.size());
  for (std::size_t i = 0; possible_ && i < fields_.size(); ++i) look_at(i);
  spaced_ = spaced_ && is_spaced(line);
  before_ = fields_;
  ++rows_;
}

void DecimalCommas::look_at(std::size_t i) {
  const std::string_view field = fields_[i];
  const bool decimals = i % 2 == 1;
  const std::string_view digits = !decimals && !field.empty() && field.front() == '-' ? field.substr(1) : field;
  possible_ = !digits.empty() && std::all_of(digits.begin(), digits.end(), is_digit);
  if (!possible_ || !decimals) return;
  zeros_in_front_ = zeros_in_front_ || (field.size() > 1 && field.front() == '0');
  width_ = width_ == 0 ? field.size() : width_;
  one_width_ = one_width_ && field.size() == width_;
  if (rows_ > 0 && before_[i] != field) varies_[i / 2] = true;
}

bool DecimalCommas::proved() const {
  constexpr std::size_t kManyRows = 10;
  const auto all_vary = [&] {
    return std::all_of(varies_.begin(), varies_.begin() + static_cast<std::ptrdiff_t>(before_.size() / 2),
                       [](bool varies) { return varies; });
  };
  return possible_ && rows_ > 0 && (zeros_in_front_ || spaced_ || (one_width_ && rows_ >= kManyRows && all_vary()));
}

}  // namespace remount::formats
