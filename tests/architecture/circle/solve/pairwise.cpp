#include "circle/search/candidates.h"
