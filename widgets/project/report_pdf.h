// The report as PDF: the same page, laid out by Qt, with charts and pictures as images.
#pragma once

#include <QByteArray>

#include "model/report/report.h"

namespace remount::widgets {

/// A4, numbered pages, fonts embedded. May run on a worker. Empty where it could not be made; throws Error(Unsupported)
/// where no installed font has a letter of it: boxes instead of words are no report.
QByteArray report_pdf(const report::Report& report, report::ReportStyle style, const QString& title);

}  // namespace remount::widgets
