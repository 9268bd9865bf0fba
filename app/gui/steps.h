// What the step bar says about the state of the work.
#pragma once

#include <array>

#include "app/gui/workbench.h"
#include "widgets/panels/step_bar.h"

namespace remount {

std::array<StepInfo, kStepCount> describe_steps(const Workbench& workbench);

}  // namespace remount
