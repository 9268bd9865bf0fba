// Which of the two builds of the inner loops is used.
#pragma once

namespace remount::registration {

/// The results are the same; tests compare them.
enum class InstructionSet { Best, Portable };

}  // namespace remount::registration
