#include "algorithms/registration/kernels.h"

namespace remount::registration {

bool has_fast_kernels() {
#ifdef __x86_64__
  return __builtin_cpu_supports("avx2") != 0;
#else
  return false;
#endif
}

const Kernels& kernels(InstructionSet instructions) {
#ifdef __x86_64__
  static const bool fast = has_fast_kernels();
  if (instructions == InstructionSet::Best && fast) return kAvx2Kernels;
#endif
  (void)instructions;
  return kPortableKernels;
}

}  // namespace remount::registration
