// What the window can do.
#pragma once

#include <vector>

#include "app/gui/shell/feature.h"

namespace remount::gui {

/// In the order of their docks, views and actions.
std::vector<MakeFeature> all_features();

}  // namespace remount::gui
