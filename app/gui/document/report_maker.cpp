#include "app/gui/document/report_maker.h"

#include <QBuffer>
#include <QDesktopServices>
#include <QImage>
#include <QThread>
#include <QTimer>
#include <QUrl>
#include <future>
#include <initializer_list>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "messages/window.h"
#include "model/formats/files/atomic_save.h"
#include "model/formats/files/current_time.h"
#include "model/overview/session_report.h"
#include "model/project/project.h"
#include "widgets/basics/gl_support.h"
#include "widgets/text/model_text.h"

namespace remount::gui {
namespace {

constexpr int kWidth = 900, kHeight = 440;
constexpr std::size_t kWorstShown = 3, kBestShown = 1;

std::string png_of(const scene::RgbImage& picture) {
  const QImage image(picture.rgb.data(), picture.width, picture.height, 3 * picture.width, QImage::Format_RGB888);
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return bytes.toStdString();
}

/// The text engine starts timers, which only a thread of Qt's own has. What is thrown there is thrown here.
QByteArray on_qt_thread(const std::function<QByteArray()>& make) {
  std::packaged_task<QByteArray()> task(make);
  const std::unique_ptr<QThread> thread(QThread::create([&task] { task(); }));
  thread->start();
  thread->wait();
  return task.get_future().get();
}

QString without_suffix(const QString& path, std::initializer_list<QLatin1String> suffixes) {
  for (const QLatin1String suffix : suffixes)
    if (path.endsWith(suffix, Qt::CaseInsensitive)) return path.chopped(suffix.size());
  return path;
}

QString without_html(const QString& path) {
  return without_suffix(path, {QLatin1String(".html"), QLatin1String(".htm")});
}

}  // namespace

QString html_beside(const QString& typed_path) {
  const QString page = without_suffix(typed_path, {QLatin1String(".pdf")});
  return without_html(page) == page ? page + QStringLiteral(".html") : page;
}

QString pdf_beside(const QString& html_path) { return without_html(html_path) + QStringLiteral(".pdf"); }

void offer_to_open_report(Notices& notices, const QString& html_path) {
  notices.offer(ReportMaker::tr("Open the report"),
                [html_path] { QDesktopServices::openUrl(QUrl::fromLocalFile(html_path)); });
}

report::ReportStyle report_style() {
  report::ReportStyle style;
  style.language = widgets::window_language();
  return style;
}

ReportMaker::ReportMaker(Workbench& workbench, QObject* parent, MakePdf make_pdf)
    : QObject(parent), workbench_(workbench), make_pdf_(std::move(make_pdf)) {
  connect(&workbench_.outcome(), &Outcome::changed, this, &ReportMaker::go_on);
  connect(&workbench_, &Workbench::state_changed, this, &ReportMaker::go_on);
}

void ReportMaker::make(const QString& html_path) {
  if (busy_ || !workbench_.outcome().output()) return;
  busy_ = true;
  html_path_ = html_path;
  of_solution_ = workbench_.outcome().solution();
  waiting_ = workbench_.map_checks().checking();
  if (waiting_) return emit progressed(tr("The report is written as soon as the map is compared."));
  begin();
}

void ReportMaker::go_on() {
  if (!waiting_) return;
  if (workbench_.outcome().solution() != of_solution_ || workbench_.activity().solving() ||
      workbench_.activity().calibrating()) {
    waiting_ = busy_ = false;
    return emit failed(html_path_, tr("The report is not written: the result changed while it waited for the "
                                      "comparison of the map. Ask for it again."));
  }
  if (workbench_.map_checks().checking()) return;
  waiting_ = false;
  begin();
}

void ReportMaker::begin() {
  output_ = workbench_.outcome().output();
  input_ = workbench_.outcome().input();
  source_ = workbench_.engine().open_pairs(input_, output_);
  report_ = {};
  report_.file = project::make_result_file(input_, *output_, workbench_.outcome().input_files());
  report_.created = formats::now_in_utc();
  pairs_.clear();
  drawn_.clear();
  if (const QString reason = widgets::missing_gl_reason(); !reason.isEmpty())
    report_.no_pictures = say::window_no_pictures(reason.toStdString());
  else
    pairs_ = report::pairs_to_picture(report_.file.pairs, kWorstShown, kBestShown);
  next_pair();
}

void ReportMaker::next_pair() {
  if (pairs_.empty()) {
    write();
    return;
  }
  const motion::PairIndex pair = pairs_.front();
  pairs_.erase(pairs_.begin());
  emit progressed(tr("Report: picture of pair %1…").arg(pair));
  jobs_.start(
      [this, pair, output = output_, source = source_](Progress& progress) -> JobRunner::Deliver {
        const auto clouds = std::make_shared<const pipeline::PairClouds>(source->load(pair, progress));
        const scene::PairSceneDataPtr data =
            clouds->has_points() ? scene::prepare_pair_scene(clouds, progress) : nullptr;
        return [this, pair, data, transforms = scene::pair_transforms(*output, pair)] {
          if (data) {
            sittings_ = {{pair, scene::PairAlignment::Before, data, transforms}};  // drawn from the last
            if (transforms.current_known)
              sittings_.insert(sittings_.begin(), {pair, scene::PairAlignment::CurrentX, data, transforms});
          } else
            report_.no_pictures = say::window_no_pictures_of_poses();
          QTimer::singleShot(0, this, &ReportMaker::draw_next);
        };
      },
      [this, pair](const JobFailure& failure) {
        report_.no_pictures = Message::sequence(
            {report_.no_pictures, say::window_pair_not_pictured(signed_of(pair), failure.what.toStdString())});
        next_pair();
      });
}

void ReportMaker::draw_next() {
  if (sittings_.empty()) {
    next_pair();
    return;
  }
  const Sitting sitting = std::move(sittings_.back());
  sittings_.pop_back();
  if (!painter_) painter_ = std::make_unique<scene::PairPainter>(kWidth, kHeight);
  drawn_.emplace_back(caption(sitting.pair, sitting.alignment).toStdString(),
                      painter_->paint(sitting.data, sitting.transforms, sitting.alignment));
  QTimer::singleShot(0, this, &ReportMaker::draw_next);
}

QString ReportMaker::caption(motion::PairIndex pair, scene::PairAlignment alignment) const {
  // Residuals are known under the result alone.
  if (alignment == scene::PairAlignment::Before)
    return (output_->nominal_known ? tr("Pair %1, from above, under the nominal mounting.")
                                   : tr("Pair %1, from above, under the mounting that the calibration started from; no "
                                        "nominal was given."))
        .arg(pair);
  const results::PairRecord& record = report_.file.pairs.at(pair);
  return tr("Pair %1, from above, under the result. Residual %2 cm, %3°, RMSE %4 cm.")
      .arg(pair)
      .arg(100.0 * record.residual_translation_m, 0, 'f', 1)
      .arg(radians_to_degrees(record.residual_rotation_rad), 0, 'f', 2)
      .arg(100.0 * record.rmse_m, 0, 'f', 1);
}

void ReportMaker::write() {
  painter_.reset();
  emit progressed(tr("Report: writing pages…"));
  jobs_.start(
      [this, html_path = html_path_, pdf_path = pdf_beside(html_path_), title = tr("Calibration of a LiDAR"),
       report = std::make_shared<report::Report>(std::move(report_)), drawn = std::move(drawn_),
       sessions = input_.sessions, style = report_style()](Progress&) -> JobRunner::Deliver {
        for (const auto& [caption, picture] : drawn) report->pictures.push_back({caption, png_of(picture)});
        for (const auto& session : sessions) report->tracks.push_back(report::track_of(*session));
        const std::string html = report::report_html(*report, style);
        const QByteArray pdf = on_qt_thread([&] { return make_pdf_(*report, style, title); });
        if (pdf.isEmpty()) throw Error(ErrorCode::Io, pdf_path.toStdString(), say::window_pdf_not_made());
        // Both or none: a new page beside an old PDF would pass for one report.
        formats::save_together({{html_path.toStdString(), html},
                                {pdf_path.toStdString(), {pdf.constData(), static_cast<std::size_t>(pdf.size())}}});
        return [this, html_path, pdf_path] {
          busy_ = false;
          emit finished(html_path, pdf_path);
        };
      },
      [this](const JobFailure& failure) {
        busy_ = false;
        emit failed(failure.where.isEmpty() ? html_path_ : failure.where, failure.what);
      });
}

}  // namespace remount::gui
