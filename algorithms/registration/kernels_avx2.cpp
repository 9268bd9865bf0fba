// Compiled with -mavx2: nothing in here may call inline functions that other files share, or the linker might take the
// AVX2 version of one for a processor without it.
#ifdef __x86_64__
#include "algorithms/registration/kernels_body.h"

namespace remount::registration {

const Kernels kAvx2Kernels{match, accumulate, fit_normals};

}  // namespace remount::registration
#endif
