#include "app/gui/report_maker.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QDateTime>
#include <QImage>
#include <QLocale>
#include <QThread>
#include <QTimer>

#include "algorithms/core/error.h"
#include "model/io/atomic_save.h"
#include "model/project.h"
#include "model/session_report.h"
#include "widgets/gl_support.h"
#include "widgets/model_text.h"
#include "widgets/report_pdf.h"
#include "widgets/scene/pair_picture.h"

namespace remount {
namespace {

constexpr int kWidth = 900, kHeight = 440;
constexpr std::size_t kWorst = 3, kBest = 1;

std::string png_of(const RgbImage& picture) {
  const QImage image(picture.rgb.data(), picture.width, picture.height, 3 * picture.width, QImage::Format_RGB888);
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return bytes.toStdString();
}

}  // namespace

ReportStyle report_style() {
  ReportStyle style;
  style.phrase = [](const char* context, const char* english) {
    return QCoreApplication::translate(context, english).toStdString();
  };
  style.sentence = [](const std::string& text) { return model_text(text).toStdString(); };
  style.language = QLocale().bcp47Name().toStdString();
  return style;
}

ReportMaker::ReportMaker(Workbench& workbench, QObject* parent) : QObject(parent), workbench_(workbench) {}

void ReportMaker::make(const QString& html_path) {
  if (busy_ || !workbench_.output()) return;
  busy_ = true;
  html_path_ = html_path;
  output_ = workbench_.output();
  input_ = workbench_.input_of_output();
  report_ = {};
  report_.file = make_result_file(input_, *output_, workbench_.input_files());
  report_.created = utc_text(QDateTime::currentMSecsSinceEpoch() * 1000000).substr(0, 19) + " UTC";
  pairs_.clear();
  if (const QString reason = missing_gl_reason(); !reason.isEmpty())
    report_.no_pictures = tr("No pictures of pairs: %1.").arg(reason).toStdString();
  else
    pairs_ = pairs_to_picture(report_.file.pairs, kWorst, kBest);
  next_picture();
}

void ReportMaker::next_picture() {
  if (pairs_.empty()) {
    write();
    return;
  }
  const std::size_t pair = pairs_.front();
  pairs_.erase(pairs_.begin());
  emit progressed(tr("Report: picture of pair %1…").arg(pair));
  jobs_.start(
      [this, pair, input = input_, output = output_,
       load = workbench_.engine().load_pair_clouds](Progress&) -> JobRunner::Deliver {
        auto clouds = std::make_shared<const PairClouds>(load(input, *output, static_cast<int>(pair)));
        return [this, pair, clouds] {
          take_clouds(pair, *clouds);
          QTimer::singleShot(0, this, &ReportMaker::next_picture);
        };
      },
      [this, pair](const JobFailure& failure) {
        const QString why = tr("Pair %1 cannot be pictured: %2").arg(pair).arg(failure.what);
        report_.no_pictures += (report_.no_pictures.empty() ? "" : " ") + why.toStdString();
        next_picture();
      });
}

QString ReportMaker::caption(std::size_t pair, const QString& alignment) const {
  const PairRecord& record = report_.file.pairs.at(pair);
  return tr("Pair %1, %2. Residual %3 cm, %4°, RMSE %5 cm.")
      .arg(pair)
      .arg(alignment)
      .arg(100.0 * record.residual_translation_m, 0, 'f', 1)
      .arg(radians_to_degrees(record.residual_rotation_rad), 0, 'f', 2)
      .arg(100.0 * record.rmse_m, 0, 'f', 1);
}

void ReportMaker::take_clouds(std::size_t pair, const PairClouds& clouds) {
  if (clouds.cloud_a.size() == 0 && clouds.cloud_b.size() == 0) {
    report_.no_pictures = tr("No pictures of pairs: they come from LiDAR poses, without scans.").toStdString();
    return;
  }
  const PairTransforms transforms = pair_transforms(*output_, static_cast<int>(pair));
  for (const auto& [alignment, words] : {std::pair{PairAlignment::Before, tr("from above, under the mounting before")},
                                         std::pair{PairAlignment::CurrentX, tr("from above, under the result")}})
    report_.pictures.push_back(
        {caption(pair, words).toStdString(), png_of(picture_of_pair(clouds, transforms, alignment, kWidth, kHeight))});
}

void ReportMaker::write() {
  emit progressed(tr("Report: writing pages…"));
  const QString pdf_path =
      html_path_.endsWith(QLatin1String(".html")) ? html_path_.chopped(5) + ".pdf" : html_path_ + ".pdf";
  const QString title = tr("Calibration of a LiDAR");
  jobs_.start(
      [this, pdf_path, title, html_path = html_path_, report = std::make_shared<Report>(std::move(report_)),
       sessions = input_.sessions, style = report_style()](Progress&) -> JobRunner::Deliver {
        for (const auto& session : sessions) report->tracks.push_back(track_of(*session));
        save_atomically(html_path.toStdString(), report_html(*report, style));
        QByteArray pdf;
        // The text engine starts timers, which a thread of Qt's own has.
        const std::unique_ptr<QThread> thread(QThread::create([&] { pdf = report_pdf(*report, style, title); }));
        thread->start();
        thread->wait();
        if (pdf.isEmpty()) throw Error(ErrorCode::Io, pdf_path.toStdString(), tr("could not be made").toStdString());
        save_atomically(pdf_path.toStdString(),
                        std::string_view(pdf.constData(), static_cast<std::size_t>(pdf.size())));
        return [this, html_path, pdf_path] {
          busy_ = false;
          emit finished(html_path, pdf_path);
        };
      },
      [this](const JobFailure& failure) {
        busy_ = false;
        emit failed(failure.where, failure.what);
      });
}

}  // namespace remount
