#include "algorithms/registration/kernels_body.h"

namespace remount::registration {

const Kernels kPortableKernels{match, accumulate, fit_normals};

}  // namespace remount::registration
