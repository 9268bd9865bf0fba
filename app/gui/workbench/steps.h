// What the step bar says about the state of the work.
#pragma once

#include <array>

#include "app/gui/workbench/workbench.h"
#include "widgets/shell/step_bar.h"

namespace remount::gui {

std::array<widgets::StepInfo, widgets::kStepCount> describe_steps(const Workbench& workbench);

}  // namespace remount::gui
