// The page that imports tables, over a few rows and scans.
#pragma once

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <fstream>

#include "app/gui/features/import_feature.h"
#include "messages/sessions.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/import/check_list.h"
#include "widgets/import/column_table.h"
#include "widgets/import/convention_form.h"
#include "widgets/import/import_dialog.h"

namespace remount::testing {

using guesses::ColumnRole;
using widgets::ImportDialog;

/// A table of a vehicle that drives an S on a level road, with x to the east, and a few scans beside it.
/// @param late_s is added to the times of the table
inline void write_import_data(const QString& folder, int late_s = 0) {
  const std::filesystem::path root = folder.toStdString();
  std::ofstream table(root / "motion.csv");
  table.precision(12);
  table << "t,x,y,z,roll,pitch,yaw\n";
  double x_m = 0.0, y_m = 0.0;
  for (int i = 0; i <= 500; ++i) {
    const double time_s = 0.04 * i, yaw_rad = 1.4 * std::sin(0.5 * time_s);
    table << 1'700'000'000.0 + late_s + time_s << ',' << x_m << ',' << y_m << ',' << 0.4 * std::sin(0.3 * time_s)
          << ",0.1,0.2," << yaw_rad * 180.0 / M_PI << '\n';
    x_m += 0.32 * std::cos(yaw_rad), y_m += 0.32 * std::sin(yaw_rad);
  }
  std::filesystem::create_directories(root / "scans");
  for (int scan = 0; scan < 4; ++scan) {
    std::ofstream cloud(root / "scans" /
                        (std::to_string(1'700'000'000'000'000'000LL + scan * 1'000'000'000LL) + ".pcd"));
    cloud << "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 40\nHEIGHT 1\nPOINTS 40\nDATA "
             "ascii\n";
    for (int point = 0; point < 40; ++point) cloud << point << ' ' << 0.5 * point << " 1\n";
  }
}

/// A log of the INS (.log) or a capture, opened without the other.
inline drive::Session alone(const std::filesystem::path& path) {
  drive::Session session = sample_session("alone");
  session.path = path;
  if (path.extension() == ".log")
    session.scans.reset();
  else
    session.ins.clear();
  session.findings.push_back(
      {drive::Severity::Problem, "one-stream", path.string(), Message::verbatim("It is half a session.")});
  return session;
}

/// Folders of tables are no session, and manifests are one.
inline gui::Engine engine_of_manifests(std::shared_ptr<const std::atomic<int>> hold_at) {
  gui::Engine engine = sample_engine(10, std::move(hold_at));
  engine.open = [](const std::filesystem::path& path, const drive::TopicChoice&, Progress&) {
    if (path.extension() == ".log" || path.extension() == ".pcap") return alone(path);
    if (path.extension() != ".yaml") throw Error(ErrorCode::Unsupported, path.string(), say::session_unknown({}));
    drive::Session session = sample_session("imported");
    session.path = path;
    return session;
  };
  return engine;
}

class ImportPage : public WindowFixture {
 protected:
  ImportPage() : WindowFixture(&engine_of_manifests) {}
  void SetUp() override {
    show();
    write_import_data(folder_.path());
  }
  void open_page() {
    feature().import(folder_.path());
    ASSERT_TRUE(page());
    ASSERT_TRUE(checked());
  }
  gui::ImportFeature& feature() { return *window_.feature<gui::ImportFeature>(); }
  ImportDialog* page() { return window_.findChild<ImportDialog*>(); }
  bool checked() {
    return QTest::qWaitFor(
        [&] { return page()->choice().table && page()->checks().isEnabled() && !page()->checks().text().isEmpty(); },
        kPatience_ms);
  }
  void choose(std::size_t column, ColumnRole role) {
    QComboBox* list = page()->columns().roles_of(column);
    list->setCurrentIndex(list->findData(static_cast<int>(role)));
    emit list->activated(list->currentIndex());
  }
  static QPushButton& button(QWidget& parent, const QString& text) {
    for (QPushButton* one : parent.findChildren<QPushButton*>())
      if (one->text().remove('&') == text) return *one;
    throw std::logic_error("no button " + text.toStdString());
  }
  static int offers_in(QWidget& parent, const QString& text) {
    const auto buttons = parent.findChildren<QPushButton*>();
    return static_cast<int>(std::ranges::count_if(
        buttons, [&](QPushButton* one) { return one->isVisible() && one->text().remove('&') == text; }));
  }
  QString manifest() const { return folder_.filePath("session.yaml"); }
  std::string text_of(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
  }
  /// Answers the next question.
  void answer(QMessageBox::StandardButton with) {
    QTimer::singleShot(100, this_, [this, with] {
      if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
        ++asked_;
        box->button(with)->click();
      }
    });
  }
  QTemporaryDir folder_;
  QObject owner_;
  QObject* this_ = &owner_;
  int asked_ = 0;
};

}  // namespace remount::testing
