// Two languages: complete, with the same placeholders, and switched without a restart.
#include "app/gui/basics/language.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QFile>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QRegularExpression>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTextDocument>
#include <QXmlStreamReader>
#include <map>
#include <set>

#include "algorithms/messages/render.h"
#include "app/gui/document/result_files.h"
#include "app/gui/features/project_feature.h"
#include "app/gui/window_host.h"
#include "messages/calibration.h"
#include "messages/ins_logs.h"
#include "model/checks/data_check.h"
#include "model/formats/session_readers.h"
#include "model/method_registry/calibration_method.h"
#include "model/project/project.h"
#include "model/results/exporters/exporter.h"
#include "model/settings/settings.h"
#include "tests/support/child_process.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/shell/log_panel.h"
#include "widgets/text/model_text.h"
#include "widgets/text/option_access.h"

namespace remount::widgets {
namespace {

using testing::kPatience_ms;

const QString kFolder = QStringLiteral(REMOUNT_SOURCE_DIR "/resources/translations/");

struct Entry {
  QString context, source;
  QStringList translations;  // several for plurals
  bool unfinished = false;
};

std::vector<Entry> entries_of(const QString& path) {
  std::vector<Entry> entries;
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return entries;
  QXmlStreamReader xml(&file);
  QString context;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    const auto name = xml.name();
    if (name == QLatin1String("name")) context = xml.readElementText();
    if (name == QLatin1String("message")) entries.push_back({context, {}, {}, false});
    if (name == QLatin1String("source")) entries.back().source = xml.readElementText();
    if (name == QLatin1String("translation")) {
      entries.back().unfinished = xml.attributes().hasAttribute("type");
      const QString text = xml.readElementText(QXmlStreamReader::IncludeChildElements);
      entries.back().translations << text;
    }
  }
  return entries;
}

std::multiset<QString> placeholders(const QString& text) {
  std::multiset<QString> found;
  static const QRegularExpression kPlaceholder(QStringLiteral("%(\\d|n)"));
  for (auto match = kPlaceholder.globalMatch(text); match.hasNext();) found.insert(match.next().captured());
  return found;
}

TEST(languages, every_text_is_translated_with_the_same_placeholders) {
  const std::vector<Entry> entries = entries_of(kFolder + "remount_zh_CN.ts");
  EXPECT_GT(entries.size(), 500U);
  for (const Entry& entry : entries) {
    const std::string what = (entry.context + ": " + entry.source).toStdString();
    EXPECT_FALSE(entry.unfinished) << what;
    for (const QString& translation : entry.translations) {
      EXPECT_FALSE(translation.trimmed().isEmpty()) << what;
      EXPECT_EQ(placeholders(translation), placeholders(entry.source)) << what;
    }
  }
  for (const Entry& entry : entries_of(kFolder + "remount_en.ts"))
    EXPECT_FALSE(entry.unfinished) << entry.source.toStdString();
}

TEST(languages, the_translations_know_every_text_of_the_sources) {
  const QTemporaryDir folder;
  for (const char* name : {"remount_zh_CN.ts", "remount_en.ts"})
    ASSERT_TRUE(QFile::copy(kFolder + name, folder.filePath(name)));
  testing::ChildProcess update(REMOUNT_SOURCE_DIR "/packaging/translations", {folder.path().toStdString()});
  ASSERT_EQ(update.ended(kPatience_ms * 3), 0) << update.said();
  for (const char* name : {"remount_zh_CN.ts", "remount_en.ts"})
    for (const Entry& entry : entries_of(folder.filePath(name)))
      EXPECT_FALSE(entry.unfinished) << "run packaging/translations and translate in " << name << ": "
                                     << entry.source.toStdString();
}

TEST(languages, the_first_of_the_systems_languages_is_spoken) {
  EXPECT_EQ(gui::language_for({"zh-Hans-CN", "en-US"}), "zh_CN");
  EXPECT_EQ(gui::language_for({"en-GB", "zh-CN"}), "en");
  EXPECT_EQ(gui::language_for({"de-DE", "zh-CN"}), "zh_CN");
  EXPECT_EQ(gui::language_for({"de-DE"}), "en");
  EXPECT_EQ(gui::language_for({}), "en");
}

class chinese : public ::testing::Test {
 protected:
  void SetUp() override { gui::speak("zh_CN", false); }
  void TearDown() override { gui::speak("en", false); }
};

TEST_F(chinese, messages_of_the_model_are_told_in_it) {
  EXPECT_EQ(model_text(say::solved_all_observed()), "已求解；六个参数全部可观测。");
  EXPECT_EQ(model_text(say::csv_no_column("yaw", {"x", "height"})), "没有列“yaw”；现有的列为 x、height")
      << "names in files stay as they are, also where they are words of the program";
  EXPECT_EQ(model_text(Message::verbatim("moving objects, 9.1 sigma")), "moving objects, 9.1 sigma")
      << "what a user typed is not translated";
  gui::speak("en", false);
  EXPECT_EQ(model_text(say::solved_all_observed()), "Solved; all six parameters are observed.");
}

TEST_F(chinese, readers_say_what_they_look_for_in_it) {
  for (const auto& reader : formats::session_readers()) {
    const QString line = model_text(reader->description());
    EXPECT_TRUE(line.contains(QRegularExpression("[\\x{4e00}-\\x{9fff}]"))) << line.toStdString();
  }
}

TEST_F(chinese, exports_and_what_has_changed_since_a_calibration_are_told_in_it) {
  for (const ExportFormat& format : gui::export_formats())
    EXPECT_TRUE(format.direction.contains(QStringLiteral("激光雷达"))) << format.direction.toStdString();
  project::CalibrationBasis then{1, {}, {}}, now{3, {}, RigidTransform::Identity()};
  now.settings.pairing.max_gap_s = then.settings.pairing.max_gap_s + 1.5;
  QStringList changes;
  for (const Message& change : project::changes_since(then, now)) changes << model_text(change);
  ASSERT_EQ(changes.size(), 3);
  EXPECT_EQ(changes[0], "1 份数据，现为 3 份");
  EXPECT_EQ(changes[1], "当时没有名义安装，现已给出");
  EXPECT_TRUE(changes[2].startsWith("“最长间隔”（配对） ") && changes[2].contains("，现为 "))
      << changes[2].toStdString();
}

TEST(languages, every_method_is_named_and_says_what_it_needs) {
  for (const method_registry::CalibrationMethod* method : method_registry::calibration_methods()) {
    EXPECT_NE(render(method->title(), Language::Chinese), english(method->title())) << method->id;
    EXPECT_NE(render(method->needs(), Language::Chinese), english(method->needs())) << method->id;
  }
}

TEST(languages, every_code_of_a_finding_says_what_it_means_and_what_to_do) {
  for (const checks::DataCheck& check : checks::data_checks())
    for (const checks::FindingKind& kind : check.kinds)
      for (const Message& words : {kind.meaning(), kind.remedy()})
        EXPECT_NE(render(words, Language::Chinese), english(words)) << kind.code;
}

TEST(languages, every_export_format_is_named_and_says_its_direction) {
  for (const auto& format : results::exporters())
    for (const Message& words : {format->description(), format->direction()})
      EXPECT_NE(render(words, Language::Chinese), english(words)) << format->id();
}

TEST_F(chinese, options_are_named_and_explained_in_it) {
  for (const OptionField& field : option_fields(settings::Settings{})) {
    EXPECT_EQ(option_label(field).toStdString(), render(field.label(), Language::Chinese));
    EXPECT_TRUE(option_help(field).contains(QRegularExpression("[\\x{4e00}-\\x{9fff}]"))) << field.name.toStdString();
  }
  EXPECT_EQ(option_label(settings::Settings{}, "pairing", "max_gap_s"), "最长间隔");
  gui::speak("en", false);
  EXPECT_EQ(option_label(settings::Settings{}, "pairing", "max_gap_s"), "Max gap");
}

/// Texts on the screen and read aloud, by where they are.
std::map<QString, QString> texts_of(QWidget& window) {
  std::map<QString, QString> texts;
  int index = 0;
  const auto note = [&](const QObject* object, const char* what, QString text) {
    if (Qt::mightBeRichText(text)) {
      QTextDocument plain;
      plain.setHtml(text);
      text = plain.toPlainText();
    }
    if (!text.isEmpty())
      texts[QStringLiteral("%1 %2 %3").arg(index).arg(object->metaObject()->className(), what)] = text;
  };
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    ++index;
    note(widget, "tool tip", widget->toolTip());
    note(widget, "name", widget->accessibleName());
    if (auto* label = qobject_cast<QLabel*>(widget)) note(label, "text", label->text());
    if (auto* button = qobject_cast<QAbstractButton*>(widget)) note(button, "text", button->text());
    if (auto* group = qobject_cast<QGroupBox*>(widget)) note(group, "title", group->title());
    if (auto* dock = qobject_cast<QDockWidget*>(widget)) note(dock, "title", dock->windowTitle());
    if (auto* line = qobject_cast<QLineEdit*>(widget)) note(line, "placeholder", line->placeholderText());
    if (auto* menu = qobject_cast<QMenu*>(widget)) {
      note(menu, "title", menu->title());
      for (const QAction* action : menu->actions()) note(action, qPrintable(action->text()), action->text());
    }
    if (auto* combo = qobject_cast<QComboBox*>(widget))
      for (int i = 0; i < combo->count(); ++i) note(combo, qPrintable(QString::number(i)), combo->itemText(i));
    if (auto* view = qobject_cast<QAbstractItemView*>(widget))
      for (int column = 0; view->model() && column < view->model()->columnCount(); ++column)
        for (const int role : {Qt::DisplayRole, Qt::ToolTipRole})
          note(view, qPrintable(QStringLiteral("header %1 %2").arg(column).arg(role)),
               view->model()->headerData(column, Qt::Horizontal, role).toString());
  }
  return texts;
}

/// English words that a Chinese text may keep: names, units, keys, formats, file names.
bool is_chinese_enough(QString text) {
  static const QRegularExpression kAllowed(QStringLiteral(
      "Remount|LiDAR|GNSS|INS|RMSE|Ctrl|Shift|Esc|F5|Space|Return|English|Language|HTML|PDF|OpenGL|Frobenius|sigma|"
      "ins_from_lidar|point_in_\\w+|Rz|Ry|Rx|yaw|pitch|roll|solve\\.\\w+|drive\\d|scan\\d+|pcd|native|session|auto|"
      "PCL|min_\\w+|cache_mb|png|Alt|Del|Home|End|PgUp|PgDown|Tab|Qt|Rx|NaN|INS\\.csv|ins\\.csv|offscreen"));
  text.remove(kAllowed);
  static const QRegularExpression kEnglishWord(QStringLiteral("[A-Za-z]{4,}"));
  return !text.contains(kEnglishWord);
}

class language_switch : public ::testing::Test {
 protected:
  void TearDown() override { gui::speak("en", false); }
  bool settle() {
    return QTest::qWaitFor(
        [&] {
          return !workbench_.activity().opening() && !workbench_.activity().calibrating() &&
                 !workbench_.activity().solving();
        },
        kPatience_ms);
  }
  QTemporaryDir folder_;
  gui::Workbench workbench_{testing::sample_engine()};
  gui::WindowHost host_{workbench_};
};

TEST_F(language_switch, every_visible_text_changes_and_no_work_is_lost) {
  host_.window().show();
  host_.window().open_paths({"/data/drive1"});
  ASSERT_TRUE(settle());
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(settle());
  workbench_.selection().select(motion::PairIndex{7});
  const auto english = texts_of(host_.window());
  const auto lines = host_.window().findChild<LogPanel*>()->blockCount();
  host_.change_language("zh_CN");
  ASSERT_TRUE(settle());
  QTest::qWait(200);
  EXPECT_EQ(workbench_.selection().pair(), motion::PairIndex{7});
  EXPECT_TRUE(workbench_.outcome().output());
  EXPECT_GE(host_.window().findChild<LogPanel*>()->blockCount(), lines);
  for (const auto& [where, text] : texts_of(host_.window())) {
    if (where.contains("LogPanel") || is_chinese_enough(text)) continue;
    // Sentences of the sample world that no real model says.
    if (text.contains("because the road was flat") || text.contains("speed bump")) continue;
    ADD_FAILURE() << "still English: " << where.toStdString() << ": " << text.toStdString();
  }
  EXPECT_GT(english.size(), 100U);
  if (const QString pictures = qEnvironmentVariable("REMOUNT_SCREENSHOT_DIR"); !pictures.isEmpty())
    host_.window().grab().save(QDir(pictures).filePath("16-chinese.png"));
  host_.change_language("en");
  ASSERT_TRUE(settle());
  const auto again = texts_of(host_.window());
  std::set<QString> before;
  for (const auto& [where, text] : english) before.insert(text);
  int changed = 0;
  for (const auto& [where, text] : again) changed += before.contains(text);
  EXPECT_GT(changed, static_cast<int>(again.size()) * 9 / 10) << "and back";
}

TEST_F(language_switch, unsaved_work_stays_safe) {
  host_.window().feature<gui::ProjectFeature>()->keep_work_in(folder_.path());
  host_.window().open_paths({"/data/drive1"});
  ASSERT_TRUE(settle());
  host_.change_language("zh_CN");
  EXPECT_TRUE(host_.window().findChildren<QDialog*>().isEmpty()) << "nothing is offered for recovery: it is open";
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(settle());
  EXPECT_TRUE(workbench_.document().unsaved());
}

}  // namespace
}  // namespace remount::widgets
