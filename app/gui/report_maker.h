// Makes the report of the present result: pictures on this thread, one a turn of the event loop, the rest on workers.
#pragma once

#include <QObject>
#include <functional>
#include <vector>

#include "app/gui/workbench.h"
#include "model/report/report.h"

namespace remount {

class ReportMaker : public QObject {
  Q_OBJECT
 public:
  explicit ReportMaker(Workbench& workbench, QObject* parent = nullptr);

  bool busy() const { return busy_; }
  /// Writes `html_path`, and the PDF of the same name beside it. Does nothing without a result.
  void make(const QString& html_path);

 signals:
  void progressed(const QString& what);
  void finished(const QString& html_path, const QString& pdf_path);
  void failed(const QString& where, const QString& what);

 private:
  void next_picture();
  void take_clouds(std::size_t pair, const PairClouds& clouds);
  void write();
  QString caption(std::size_t pair, const QString& alignment) const;

  Workbench& workbench_;
  Report report_;
  PipelineInput input_;
  OutputPtr output_;
  std::vector<std::size_t> pairs_;  // still to be pictured
  QString html_path_;
  bool busy_ = false;
  JobRunner jobs_;
};

/// Words of a report in the language of the window.
ReportStyle report_style();

}  // namespace remount
