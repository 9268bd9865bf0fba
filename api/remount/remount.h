// All of the library.
#pragma once

// IWYU pragma: begin_exports
#include "remount/calibrate.h"
#include "remount/error.h"
#include "remount/exporters.h"
#include "remount/matrices.h"
#include "remount/progress.h"
#include "remount/registration.h"
#include "remount/result.h"
#include "remount/session.h"
#include "remount/settings.h"
#include "remount/simulation.h"
#include "remount/text.h"
#include "remount/version.h"
// IWYU pragma: end_exports
