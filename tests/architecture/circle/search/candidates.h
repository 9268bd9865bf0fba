#include "circle/solve/result.h"
