// What the result panel shows below its numbers: lists, and tables of what was found beside what was assumed.
#pragma once

#include <QString>
#include <QStringList>

#include "model/pipeline/pipeline.h"

namespace remount::widgets {

/// A heading and its items; empty for none.
QString html_list(const QString& title, const QStringList& items);
/// What was assumed against what was found; empty where nothing was assumed.
QString nominal_table(const pipeline::PipelineOutput& output);
/// How sharp the accumulated scans are: a check that does not use the residual. Empty where it was not made.
QString sharpness_table(const pipeline::PipelineOutput& output);

}  // namespace remount::widgets
