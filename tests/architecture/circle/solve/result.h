#include "circle/core/rotation.h"
