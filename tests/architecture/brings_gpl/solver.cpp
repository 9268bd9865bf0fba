// Never compiled: what the law about licences is to find.
#include <ceres/ceres.h>
