// Makes the report of the present result: pictures are drawn on this thread, one a turn of the event loop; the rest is
// made on workers.
#pragma once

#include <QObject>
#include <functional>
#include <vector>

#include "app/gui/workbench/workbench.h"
#include "model/report/report.h"
#include "widgets/project/report_pdf.h"
#include "widgets/scene/pair_picture.h"

namespace remount::gui {

class ReportMaker : public QObject {
  Q_OBJECT
 public:
  using MakePdf = std::function<QByteArray(const report::Report&, report::ReportStyle, const QString& title)>;

  explicit ReportMaker(Workbench& workbench, QObject* parent = nullptr, MakePdf make_pdf = widgets::report_pdf);

  bool busy() const { return busy_; }
  /// Writes `html_path`, and the PDF of the same name beside it. Does nothing without a result, or while it is busy.
  /// Where the map is still being compared under the result, waits for that; fails where the result does not last so
  /// long.
  void make(const QString& html_path);

 signals:
  void progressed(const QString& what);
  void finished(const QString& html_path, const QString& pdf_path);
  void failed(const QString& where, const QString& what);

 private:
  /// A picture that only has to be drawn.
  struct Sitting {
    motion::PairIndex pair;
    scene::PairAlignment alignment;
    scene::PairSceneDataPtr data;
    scene::PairTransforms transforms;
  };

  void go_on();
  void begin();
  void next_pair();
  void draw_next();
  void write();
  QString caption(motion::PairIndex pair, scene::PairAlignment alignment) const;

  Workbench& workbench_;
  MakePdf make_pdf_;
  report::Report report_;
  pipeline::PipelineInput input_;
  OutputPtr output_;
  std::shared_ptr<const pipeline::PairSource> source_;
  std::vector<motion::PairIndex> pairs_;                        // still to be pictured
  std::unique_ptr<scene::PairPainter> painter_;                 // null while nothing is drawn
  std::vector<Sitting> sittings_;                               // of the present pair, still to be drawn
  std::vector<std::pair<std::string, scene::RgbImage>> drawn_;  // with captions
  QString html_path_;
  bool busy_ = false, waiting_ = false;
  int of_solution_ = 0;  // while it waits: what it was asked of
  JobRunner jobs_;
};

/// Where the page goes for a name as typed, which may be that of the PDF or have no suffix.
QString html_beside(const QString& typed_path);

/// Where the PDF of a page goes.
QString pdf_beside(const QString& html_path);

/// Behind the message that it is saved: the button that shows it.
void offer_to_open_report(Notices& notices, const QString& html_path);

/// Words of a report in the language of the window.
report::ReportStyle report_style();

}  // namespace remount::gui
