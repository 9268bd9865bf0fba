// The report from the window: page and PDF with pictures, charts and the same numbers.
#include "messages/report.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QBuffer>
#include <QFile>
#include <QFileDialog>
#include <QFontDatabase>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTimer>
#include <stdexcept>
#include <string>
#include <vector>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "app/gui/basics/language.h"
#include "app/gui/document/report_maker.h"
#include "app/gui/document/result_files.h"
#include "messages/calibration.h"
#include "tests/support/child_process.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/basics/gl_support.h"
#include "widgets/charts/paint_drawing.h"
#include "widgets/shell/message_banner.h"

namespace remount::widgets {
namespace {

using testing::kPatience_ms;
using report_window = testing::WindowFixture;

QByteArray contents(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

TEST(report_paths, page_and_pdf_lie_beside_each_other_whatever_was_typed) {
  const auto both = [](const char* typed) {
    const QString page = gui::html_beside(typed);
    return (page + " " + gui::pdf_beside(page)).toStdString();
  };
  EXPECT_EQ(both("/a/drive.html"), "/a/drive.html /a/drive.pdf");
  EXPECT_EQ(both("/a/drive"), "/a/drive.html /a/drive.pdf");
  EXPECT_EQ(both("/a/drive.pdf"), "/a/drive.html /a/drive.pdf");
  EXPECT_EQ(both("/a/drive.PDF"), "/a/drive.html /a/drive.pdf");
  EXPECT_EQ(both("/a/drive.HTML"), "/a/drive.HTML /a/drive.pdf");
  EXPECT_EQ(both("/a/drive.htm"), "/a/drive.htm /a/drive.pdf");
  EXPECT_EQ(both("/a/drive.html.pdf"),
            "/a/drive.html /a/drive.pdf");  // the suggested name, and what was typed behind it
  EXPECT_EQ(both("/a/drive.2024-05"), "/a/drive.2024-05.html /a/drive.2024-05.pdf");
  EXPECT_EQ(both("/a/drive.htmx"), "/a/drive.htmx.html /a/drive.htmx.pdf");
}

TEST_F(report_window, a_second_one_waits_for_the_first_and_says_so) {
  const QTemporaryDir folder;
  show();
  calibrate_drive();
  auto& maker = *window_.findChild<gui::ReportMaker*>();
  QSignalSpy finished(&maker, &gui::ReportMaker::finished), failed(&maker, &gui::ReportMaker::failed);
  maker.make(folder.filePath("drive.html"));
  trigger("Ctrl+R");  // asks for no file
  EXPECT_TRUE(child<MessageBanner>().isVisible());
  EXPECT_TRUE(child<MessageBanner>().findChild<QLabel*>()->text().contains("being written"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return finished.count() + failed.count() > 0; }, kPatience_ms));
  EXPECT_EQ(finished.count(), 1);
}

TEST_F(report_window, one_click_makes_a_page_and_a_pdf) {
  const QTemporaryDir folder;
  show();
  calibrate_drive();
  auto& maker = *window_.findChild<gui::ReportMaker*>();
  QSignalSpy finished(&maker, &gui::ReportMaker::finished), failed(&maker, &gui::ReportMaker::failed);
  maker.make(folder.filePath("drive.html"));
  EXPECT_TRUE(maker.busy());
  ASSERT_TRUE(QTest::qWaitFor([&] { return finished.count() + failed.count() > 0; }, kPatience_ms));
  ASSERT_EQ(failed.count(), 0) << failed.at(0).at(1).toString().toStdString();
  const QString html = QString::fromUtf8(contents(folder.filePath("drive.html")));
  const QByteArray pdf = contents(folder.filePath("drive.pdf"));
  for (const double value_m :
       {x_m(), workbench_.outcome().output()->result.mounting.reference_from_sensor.translation().y()})
    EXPECT_TRUE(html.contains(QStringLiteral(">%1 m</td>").arg(value_m, 0, 'f', 4))) << value_m;
  EXPECT_EQ(html.count("<svg"), 3) << "residuals of translation and rotation, and the drive";
  if (missing_gl_reason().isEmpty())
    EXPECT_EQ(html.count("data:image/png"), 8) << "three worst and the best, before and after";
  else
    EXPECT_TRUE(html.contains("No pictures of pairs")) << "it is said where there are none";
  EXPECT_TRUE(pdf.startsWith("%PDF")) << pdf.left(20).toStdString();
  EXPECT_GT(pdf.count("/Type /Page\n"), 1);
  EXPECT_TRUE(pdf.contains("/FontFile")) << "fonts are embedded";
  if (const QString pictures = qEnvironmentVariable("REMOUNT_SCREENSHOT_DIR"); !pictures.isEmpty()) {
    QFile::remove(QDir(pictures).filePath("report.pdf"));
    QFile::remove(QDir(pictures).filePath("report.html"));
    QFile::copy(folder.filePath("drive.pdf"), QDir(pictures).filePath("report.pdf"));
    QFile::copy(folder.filePath("drive.html"), QDir(pictures).filePath("report.html"));
  }
}

TEST_F(report_window, a_place_that_cannot_be_written_is_named) {
  show();
  calibrate_drive();
  auto& maker = *window_.findChild<gui::ReportMaker*>();
  QSignalSpy failed(&maker, &gui::ReportMaker::failed);
  maker.make("/nowhere/at/all/drive.html");
  ASSERT_TRUE(QTest::qWaitFor([&] { return failed.count() > 0; }, kPatience_ms));
  EXPECT_TRUE(failed.at(0).at(0).toString().contains("/nowhere/at/all"));
  EXPECT_FALSE(maker.busy());
}

TEST_F(report_window, a_pdf_that_fails_is_a_failure_with_its_reason) {
  const QTemporaryDir folder;
  calibrate_drive();
  gui::ReportMaker maker(workbench_, nullptr,
                         [](const report::Report&, report::ReportStyle, const QString&) -> QByteArray {
                           throw std::runtime_error("the paper is gone");
                         });
  QSignalSpy finished(&maker, &gui::ReportMaker::finished), failed(&maker, &gui::ReportMaker::failed);
  QFile before(folder.filePath("drive.html"));
  ASSERT_TRUE(before.open(QIODevice::WriteOnly) && before.write("old") == 3);
  before.close();
  maker.make(folder.filePath("drive.html"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return finished.count() + failed.count() > 0; }, kPatience_ms));
  ASSERT_EQ(failed.count(), 1);
  EXPECT_EQ(failed.at(0).at(0).toString(), folder.filePath("drive.html"));
  EXPECT_TRUE(failed.at(0).at(1).toString().contains("the paper is gone"))
      << failed.at(0).at(1).toString().toStdString();
  EXPECT_FALSE(maker.busy());
  EXPECT_EQ(contents(folder.filePath("drive.html")), "old") << "a new page would stand beside no PDF, or an old one";
  EXPECT_FALSE(QFile::exists(folder.filePath("drive.pdf")));
}

/// Names a file in the dialog that asks for one and answers the questions after it.
class Answers : public QObject {
 public:
  Answers(const QString& file, QMessageBox::StandardButton answer) {
    connect(&timer_, &QTimer::timeout, this, [this, file, answer] {
      QWidget* const dialog = QApplication::activeModalWidget();
      if (auto* files = qobject_cast<QFileDialog*>(dialog)) {
        files->findChild<QLineEdit*>()->setText(file);
        QMetaObject::invokeMethod(files, "accept");
      } else if (auto* question = qobject_cast<QMessageBox*>(dialog)) {
        questions << question->text();
        question->button(answer)->click();
      }
    });
    timer_.start(20);
  }
  QStringList questions;

 private:
  QTimer timer_;
};

TEST_F(report_window, asks_once_before_page_or_pdf_are_replaced) {
  QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  const QTemporaryDir folder;
  const QString html = folder.filePath("drive.html"), pdf = folder.filePath("drive.pdf");
  show();
  calibrate_drive();
  auto& maker = *window_.findChild<gui::ReportMaker*>();
  const auto ask = [&](const QString& file, QMessageBox::StandardButton answer) {
    Answers answers(file, answer);
    trigger("Ctrl+R");
    return answers.questions;
  };
  const auto write = [](const QString& path) {
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write("old") == 3;
  };
  ASSERT_TRUE(write(pdf));
  QStringList questions = ask(html, QMessageBox::No);
  ASSERT_EQ(questions.size(), 1);
  EXPECT_TRUE(questions[0].contains(pdf) && !questions[0].contains(html)) << questions[0].toStdString();
  ASSERT_TRUE(write(html));
  questions = ask(folder.filePath("drive"), QMessageBox::No);
  ASSERT_EQ(questions.size(), 1) << "the suffix is added";
  EXPECT_TRUE(questions[0].contains(pdf) && questions[0].contains(html)) << questions[0].toStdString();
  EXPECT_FALSE(maker.busy());
  EXPECT_EQ(contents(html) + contents(pdf), "oldold");
  QSignalSpy finished(&maker, &gui::ReportMaker::finished);
  EXPECT_EQ(ask(html, QMessageBox::Yes).size(), 1) << "not a second time by the dialog";
  ASSERT_TRUE(QTest::qWaitFor([&] { return finished.count() > 0; }, kPatience_ms));
  EXPECT_TRUE(contents(html).startsWith("<!DOCTYPE html>") && contents(pdf).startsWith("%PDF"));
  EXPECT_TRUE(ask(folder.filePath("other.html"), QMessageBox::No).isEmpty());
  ASSERT_TRUE(QTest::qWaitFor([&] { return finished.count() > 1; }, kPatience_ms));
}

QString pdf_reader() { return QStandardPaths::findExecutable("pdftotext"); }

QString text_of_pdf(const QByteArray& pdf, const QStringList& options) {
  const QTemporaryDir folder;
  QFile file(folder.filePath("report.pdf"));
  EXPECT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(pdf);
  file.close();
  // Not by its output, where its warnings would stand among the text.
  QFile text(folder.filePath("report.txt"));
  std::vector<std::string> arguments;
  for (const QString& argument : options + QStringList{file.fileName(), text.fileName()})
    arguments.push_back(argument.toStdString());
  testing::ChildProcess reader(pdf_reader().toStdString(), arguments);
  EXPECT_EQ(reader.ended(kPatience_ms), 0) << pdf.size() << " bytes: " << reader.said();
  EXPECT_TRUE(text.open(QIODevice::ReadOnly)) << text.errorString().toStdString();
  return QString::fromUtf8(text.readAll());
}

TEST(report_pdf, numbers_are_whole_headers_repeated_and_headings_stay_with_what_follows) {
  if (pdf_reader().isEmpty()) GTEST_SKIP() << "pdftotext (poppler-utils) is not installed";
  pipeline::PipelineInput input;
  input.sessions = {std::make_shared<const drive::Session>(testing::sample_session("drive1"))};
  const pipeline::PipelineOutput output = testing::sample_output(input, 150);
  report::Report report;
  report.file.result = output.result;
  report.file.pairs = results::pair_records(output.keyframes, output.pairs);
  const std::string hash = std::string(56, 'a') + "0123cdef";
  report.file.inputs = {
      {"drive1", "vehicle07_2024-05-17-10-22-33_calibration_yard_front_top_of_the_roof.bag", 1234567890, hash}};
  QByteArray png;
  QBuffer buffer(&png);
  QImage grey(600, 300, QImage::Format_RGB32);
  grey.fill(Qt::gray);
  ASSERT_TRUE(grey.save(&buffer, "PNG"));
  for (const char* caption : {"the worst pair", "the best pair", "another pair"})
    report.pictures.push_back({caption, {png.begin(), png.end()}});
  static const QRegularExpression kRow(R"(\d\d:\d\d:\d\d\.\d\d\d +\d+\.\d s)");
  // What stands before the heading grows line by line, so that headings come to any place of a page.
  for (int lines = 0; lines < 24; lines += 2) {
    if (lines > 0) report.file.result.advice.insert(report.file.result.advice.end(), 2, Message::verbatim("Drive on."));
    const QString text = text_of_pdf(report_pdf(report, {}, "report"), {"-layout"});
    for (const report::ReportPicture& picture : report.pictures)
      EXPECT_TRUE(text.contains(QString::fromStdString(picture.caption)))
          << picture.caption << ", " << lines << " lines";
    EXPECT_EQ(text.count(kRow), 150) << lines << " lines";
    EXPECT_TRUE(text.contains("0123cdef")) << "the end of a hash beside a long name";
    int tables = 0;
    for (const QString& page : text.split('\f', Qt::SkipEmptyParts)) {
      const QStringList said = page.split('\n', Qt::SkipEmptyParts);
      if (said.size() < 3) continue;                         // the text of charts is no text
      const QString last = said[said.size() - 2].trimmed();  // before the number of the page
      for (const char* heading : {"Residuals of the pairs", "Drive", "Pairs", "Settings", "Data"})
        EXPECT_NE(last, heading) << lines << " lines\n" << page.toStdString();
      const qsizetype row = page.indexOf(kRow), header = page.indexOf("scan a (UTC)");
      if (row < 0) continue;
      ++tables;
      EXPECT_TRUE(header >= 0 && header < row) << page.toStdString();
    }
    EXPECT_GE(tables, 2) << text.toStdString();
    if (HasFailure()) return;
  }
}

class chinese_report : public ::testing::Test {
 protected:
  void SetUp() override {
    gui::speak("zh_CN", false);
    report_.file.result.message = say::solved_all_observed();
    report_.tracks = {{"drive1", true, {{0, 0}, {10, 5}}}};
  }
  void TearDown() override { gui::speak("en", false); }
  report::Report report_;
};

TEST_F(chinese_report, is_a_pdf_with_chinese_letters) {
  if (pdf_reader().isEmpty()) GTEST_SKIP() << "pdftotext (poppler-utils) is not installed";
  if (QFontDatabase::families(QFontDatabase::SimplifiedChinese).isEmpty()) GTEST_SKIP() << "no font for Chinese";
  QString text = text_of_pdf(report_pdf(report_, gui::report_style(), "报告"), {});
  text.remove(QRegularExpression("\\s"));  // lines break anywhere
  const auto words_of = [](const Message& message) {
    return QString::fromStdString(render(message, Language::Chinese));
  };
  for (const QString& words : {QStringLiteral("已求解；六个参数全部可观测。"), words_of(say::report_title()),
                               words_of(say::report_residuals()), words_of(say::report_settings_usual())})
    EXPECT_TRUE(text.contains(QString(words).remove(' '))) << words.toStdString() << "\n"
                                                           << text.left(600).toStdString();
}

/// In a process of its own: an application looks for fonts once.
TEST_F(chinese_report, says_that_a_font_is_missing_instead_of_drawing_boxes) {
  if (qEnvironmentVariableIsEmpty("REMOUNT_WITHOUT_CHINESE_FONTS")) {
    const QTemporaryDir folder;
    QFile fonts(folder.filePath("fonts.conf"));
    ASSERT_TRUE(fonts.open(QIODevice::WriteOnly));
    fonts.write("<?xml version=\"1.0\"?><fontconfig><dir>/usr/share/fonts/truetype/dejavu</dir></fontconfig>");
    fonts.close();
    testing::ChildProcess child(
        QCoreApplication::applicationFilePath().toStdString(),
        {"--gtest_filter=chinese_report.says_that_a_font_is_missing_instead_of_drawing_boxes"},
        {{"FONTCONFIG_FILE", fonts.fileName().toStdString()}, {"REMOUNT_WITHOUT_CHINESE_FONTS", "1"}});
    EXPECT_EQ(child.ended(kPatience_ms), 0) << child.said();
    return;
  }
  try {
    report_pdf(report_, gui::report_style(), "报告");
    FAIL() << "boxes were drawn";
  } catch (const Error& error) {
    EXPECT_NE(english(error.what_happened()).find("fonts-noto-cjk"), std::string::npos)
        << english(error.what_happened());
  }
  gui::speak("en", false);
  EXPECT_TRUE(report_pdf(report_, gui::report_style(), "Report").startsWith("%PDF")) << "English needs no such font";
}

TEST(paint_drawing, puts_colours_where_the_drawing_says) {
  report::Drawing drawing;
  drawing.width = 40, drawing.height = 20;
  drawing.shapes = {report::DrawnBox{{10, 5}, {10, 10}, "#ff0000"}, report::DrawnDot{{32, 10}, 4, "#0000ff"}};
  const QImage image = image_of(drawing, 2.0);
  EXPECT_EQ(image.size(), QSize(80, 40));
  EXPECT_EQ(image.pixelColor(30, 20), QColor(255, 0, 0));
  EXPECT_EQ(image.pixelColor(64, 20), QColor(0, 0, 255));
  EXPECT_EQ(image.pixelColor(5, 5), QColor(255, 255, 255));
}

}  // namespace
}  // namespace remount::widgets
