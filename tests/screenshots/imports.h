// The page that imports a table, as pictures for people to look at.
#pragma once

#include "tests/screenshots/tour.h"

namespace remount::testing {

/// Of each session of the request, which no reader knows: what the window says, the page, and the
/// manifest that comes of it. False where there is
/// none.
bool take_imports(const TourRequest& request);

}  // namespace remount::testing
