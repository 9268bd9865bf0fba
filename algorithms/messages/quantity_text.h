// Quantities as text.
#pragma once

#include <string>
#include <string_view>

#include "algorithms/messages/catalogue.h"
#include "algorithms/messages/message.h"

namespace remount {

struct QuantityText {
  std::string digits;
  std::string_view unit;  ///< with the space before it
};

/// @param style "", for a unit and digits that suit the size, or "[+][unit][.digits]": "m.2", "+ms.1", ".3"; "g3" for
///              three significant digits. Of a number without a unit: digits alone.
QuantityText quantity_text(const Quantity& quantity, std::string_view style, Language language);

/// Whether `style` is one for that dimension: the catalogue is checked by it when it is compiled.
bool is_quantity_style(Dimension dimension, std::string_view style);

}  // namespace remount
