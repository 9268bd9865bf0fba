// Words for the choices of options; files and the command line have keys.
#pragma once

#include "widgets/text/option_access.h"

namespace remount::widgets {

/// "Pairs of keyframes" for "pairwise": the same words as elsewhere in the window. The key itself where there are none.
QString choice_words(const OptionField& field, const QString& key);

}  // namespace remount::widgets
