// A report of a calibration for people: what was found, how sure it is, from what, and with which settings.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/report/charts.h"
#include "model/report/plot_chart.h"
#include "model/results/result_file.h"

namespace remount::report {

struct ReportPicture {
  std::string caption;
  std::string png;  ///< bytes
};

struct Report {
  results::ResultFile file;
  std::string lidar;                    ///< of a vehicle with several; empty: the only one
  std::string created;                  ///< "2026-11-22 05:00:00 UTC"; empty: not said
  std::vector<ReportTrack> tracks;      ///< of the sessions; none where only a result is known
  std::vector<ReportPicture> pictures;  ///< of pairs
  Message no_pictures;                  ///< why there are none; empty where there are
};

/// The reader's language, and how the parts that are no text come into the page.
struct ReportStyle {
  Language language = Language::English;
  std::function<std::string(const Drawing&)> chart;          ///< HTML of a chart; unset: inline SVG
  std::function<std::string(const ReportPicture&)> picture;  ///< HTML of a picture; unset: an image within the page
};

/// One page that needs no other file, simple enough for the window's text engine to print.
std::string report_html(const Report& report, const ReportStyle& style = {});

/// What stands on it, and a page with that: for pages of several reports.
std::string report_body(const Report& report, const ReportStyle& style);
std::string report_page(const std::string& body, const ReportStyle& style);

/// Indices of the pairs to be pictured: the `worst` accepted ones with the largest residual first, then the best.
std::vector<motion::PairIndex> pairs_to_picture(const std::vector<results::PairRecord>& pairs, std::size_t worst,
                                                std::size_t best);

/// The correlation of parameters i and k; NaN where one of them is not observed.
double correlation(const calibration::CalibrationResult& result, calibration::Parameter one,
                   calibration::Parameter other);

}  // namespace remount::report
