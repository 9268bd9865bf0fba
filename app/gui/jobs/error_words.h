// Errors for the user: what, where, and what to try; in the language of the window.
#pragma once

#include "algorithms/core/error.h"
#include "app/gui/jobs/job_runner.h"

namespace remount::gui {

/// What happened, followed by what to try where the error does not say so itself.
JobFailure failure_of(const Error& error);

/// The same for any exception of a job.
JobFailure failure_of(const std::exception& error);

/// "scan0.pcd: cannot be read"; what happened alone where there is no place.
QString in_words(const JobFailure& failure);

}  // namespace remount::gui
