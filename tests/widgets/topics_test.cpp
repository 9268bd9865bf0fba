// Which topics of a bag a session is made of: asked where that is not clear, changed afterwards, undone.
#include "messages/topics.h"

#include <QComboBox>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTreeWidget>

#include "app/gui/basics/language.h"
#include "app/gui/features/all_features.h"
#include "app/gui/workbench/edit_commands.h"
#include "model/formats/sessions/session_reader.h"
#include "tests/model/formats/bags/bag_maker.h"
#include "tests/widgets/support/restored.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/sessions/sessions_panel.h"
#include "widgets/sessions/topics_dialog.h"

namespace remount::widgets {
namespace {

using testing::kPatience_ms;
using testing::WindowFixture;

drive::OfferedTopic offered(const std::string& name, const std::string& type, std::size_t count, double rate_hz,
                            std::vector<drive::TopicUse> uses, std::vector<std::string> used_as = {},
                            const Message& unusable = {}) {
  drive::OfferedTopic one{{name, type, count, rate_hz, {}, std::move(used_as)}, std::move(uses), unusable};
  for (const drive::TopicUse& use : one.uses) one.topic.can_be.push_back(use.role);
  return one;
}

std::vector<drive::OfferedTopic> many_topics() {
  const Message fixes = say::topic_fixes_of_receiver();
  return {
      offered("/camera/image", "sensor_msgs/Image", 3600, 30.0, {}, {}, say::topic_of_other_type()),
      offered("/front/points", "sensor_msgs/PointCloud2", 1200, 10.0, {{"lidar", say::topic_timed_scans(65536)}},
              {"lidar"}),
      offered("/gnss/fix", "sensor_msgs/NavSatFix", 120, 1.0, {{"ins-position", fixes}, {"gnss", fixes}}, {"gnss"}),
      offered("/ins/fix", "sensor_msgs/NavSatFix", 6000, 50.0,
              {{"ins-position", say::topic_fixes_of_device()}, {"gnss", fixes}}, {"ins-position"}),
      offered("/ins/imu", "sensor_msgs/Imu", 12000, 100.0,
              {{"ins", say::topic_orientation(), true, true}, {"imu", say::topic_rates()}}, {"ins", "imu"}),
      offered("/lio/odometry", "nav_msgs/Odometry", 1200, 10.0,
              {{"lidar", say::topic_poses_for_lidar(), false}, {"ins", say::topic_named_as_other_sensor(), false}}),
      offered("/rear/points", "sensor_msgs/PointCloud2", 1200, 10.0, {{"lidar", say::topic_untimed_scans(32768)}}),
      offered("/tf_static", "tf2_msgs/TFMessage", 1, 0.0,
              {{std::string(drive::kNominalRole), say::topic_transforms()}}),
  };
}

/// A session of a bag, with scans of its own whatever the choice.
drive::Session bag_session(const std::filesystem::path& path, const drive::TopicChoice& choice) {
  drive::Session session = testing::sample_session(path.filename().string());
  session.path = path;
  session.topic_choice = choice;
  for (const drive::OfferedTopic& one : many_topics()) {
    session.topics.push_back(one.topic);
    drive::SessionTopic& topic = session.topics.back();
    if (choice.empty()) continue;
    topic.used_as.clear();
    for (const auto& [role, name] : choice)
      if (name == topic.name) topic.used_as.push_back(role);
  }
  const auto lidar = choice.find("lidar");
  const bool rear = lidar != choice.end() && lidar->second == "/rear/points";
  session.nominal_ins_from_lidar = rigid_from_six({rear ? -1.0 : 1.0, 0.0, 1.5, 0.0, 0.0, 0.0});
  return session;
}

/// "*.bag" has several of all, "one.bag" one topic for each role; other paths are drives without topics.
gui::Engine bag_engine(std::shared_ptr<const std::atomic<int>> hold_at) {
  gui::Engine engine = testing::sample_engine(10, std::move(hold_at));
  engine.open = [drive = engine.open](const std::filesystem::path& path, const drive::TopicChoice& choice,
                                      Progress& progress) {
    return path.extension() == ".bag" ? bag_session(path, choice) : drive(path, choice, progress);
  };
  engine.offer_topics = [](const std::filesystem::path& path, Progress&) -> std::optional<drive::TopicOffer> {
    if (path.extension() != ".bag") return std::nullopt;
    std::vector<drive::OfferedTopic> topics = many_topics();
    if (path.stem() == "one")
      std::erase_if(topics, [](const drive::OfferedTopic& one) {
        return one.topic.name == "/rear/points" || one.topic.name == "/gnss/fix";
      });
    return drive::TopicOffer{path, topics,
                             [path](const drive::TopicChoice& choice, Progress&) { return bag_session(path, choice); }};
  };
  return engine;
}

class topics : public WindowFixture {
 protected:
  topics() : WindowFixture(&bag_engine) {}
  void SetUp() override { show(); }
  TopicsDialog* dialog() {
    for (TopicsDialog* one : window_.findChildren<TopicsDialog*>())
      if (one->isVisible()) return one;
    return nullptr;
  }
  TopicsDialog* asked() {
    return QTest::qWaitFor([&] { return dialog() != nullptr; }, kPatience_ms) ? dialog() : nullptr;
  }
  void accept() { dialog()->accept(); }
  QPushButton* button(QWidget& parent, const QString& text) {
    for (QPushButton* one : parent.findChildren<QPushButton*>())
      if (one->text().remove('&') == text) return one;
    return nullptr;
  }
  const drive::Session& session(std::size_t index = 0) const { return *workbench_.sessions().all().at(index); }
};

TEST_F(topics, a_bag_with_several_asks_and_enter_takes_the_suggestion) {
  window_.open_paths({"/data/many.bag"});
  TopicsDialog* dialog = asked();
  ASSERT_TRUE(dialog);
  EXPECT_TRUE(workbench_.sessions().all().empty()) << "nothing is read before the answer";
  const drive::TopicChoice suggestion{{"lidar", "/front/points"},
                                      {"ins", "/ins/imu"},
                                      {"ins-position", "/ins/fix"},
                                      {"gnss", "/gnss/fix"},
                                      {"imu", "/ins/imu"}};
  EXPECT_EQ(dialog->choice(), suggestion);
  photograph(*dialog, "topics");
  QTest::keyClick(dialog, Qt::Key_Return);
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench_.sessions().all().size() == 1; }, kPatience_ms));
  EXPECT_EQ(session().topic_choice, suggestion);
  EXPECT_EQ(workbench_.document().snapshot().project.topics.at(0), suggestion) << "the project keeps it";
}

TEST_F(topics, every_topic_is_listed_with_what_speaks_for_or_against_it) {
  window_.open_paths({"/data/many.bag"});
  ASSERT_TRUE(asked());
  auto* table = dialog()->findChild<QTreeWidget*>();
  ASSERT_EQ(table->topLevelItemCount(), 8);
  const auto row = [&](int i) {
    QStringList cells;
    for (int column = 0; column < table->columnCount(); ++column) cells << table->topLevelItem(i)->text(column);
    return cells.join(" | ");
  };
  EXPECT_EQ(row(0),
            "/camera/image | sensor_msgs/Image | 3600 | 30.0 Hz |  |  | cannot be used: messages of this type are not "
            "read");
  EXPECT_EQ(row(1),
            "/front/points | sensor_msgs/PointCloud2 | 1200 | 10.0 Hz | LiDAR | LiDAR | scans of 65536 points that "
            "have times");
  EXPECT_EQ(row(7),
            "/tf_static | tf2_msgs/TFMessage | 1 |  | nominal mounting | nominal mounting | where the transforms lead "
            "from the LiDAR to the INS");
  dialog()->choose("lidar", "/rear/points");
  EXPECT_TRUE(row(1).contains("| LiDAR |  |")) << row(1).toStdString();
  EXPECT_TRUE(row(6).contains("| LiDAR | LiDAR |")) << row(6).toStdString();
  dialog()->reject();
}

TEST_F(topics, what_cannot_be_is_said_and_not_opened) {
  window_.open_paths({"/data/many.bag"});
  ASSERT_TRUE(asked());
  QPushButton* open = button(*dialog(), "Open");
  EXPECT_TRUE(open->isEnabled());
  dialog()->choose("ins-position", "none");
  EXPECT_FALSE(open->isEnabled()) << "an orientation alone";
  dialog()->choose("lidar", "/lio/odometry");
  dialog()->choose("ins", "/lio/odometry");
  EXPECT_FALSE(open->isEnabled()) << "compared with itself";
  photograph(*dialog(), "topics-problem");
  dialog()->choose("lidar", "/front/points");
  EXPECT_TRUE(open->isEnabled());
  EXPECT_FALSE(dialog()->choice().contains("ins-position")) << "the odometry has one of its own";
  button(*dialog(), "As it was")->click();
  EXPECT_EQ(dialog()->choice().at("ins"), "/ins/imu");
  EXPECT_EQ(dialog()->choice().at("ins-position"), "/ins/fix");
  QTest::keyClick(dialog(), Qt::Key_Escape);
  ASSERT_TRUE(settle());
  EXPECT_TRUE(workbench_.sessions().all().empty());
}

TEST_F(topics, one_topic_for_each_role_opens_without_a_question) {
  window_.open_paths({"/data/one.bag", "/data/drive1"});
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench_.sessions().all().size() == 2; }, kPatience_ms));
  EXPECT_FALSE(dialog());
  EXPECT_TRUE(session(0).topic_choice.empty());
}

TEST_F(topics, several_bags_that_are_dropped_ask_one_after_the_other_and_open_together) {
  QMimeData data;
  data.setUrls(
      {QUrl::fromLocalFile("/data/a.bag"), QUrl::fromLocalFile("/data/b.bag"), QUrl::fromLocalFile("/data/drive1")});
  QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window_, &enter);
  QDropEvent drop({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window_, &drop);
  ASSERT_TRUE(asked());
  EXPECT_EQ(dialog()->windowTitle(), "Topics of a.bag");
  EXPECT_EQ(workbench_.sessions().all().size(), 1U) << "the one that leaves nothing to ask";
  dialog()->choose("lidar", "/rear/points");
  accept();
  ASSERT_TRUE(asked());
  EXPECT_EQ(dialog()->windowTitle(), "Topics of b.bag");
  accept();
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench_.sessions().all().size() == 3; }, kPatience_ms));
  EXPECT_EQ(session(1).topic_choice.at("lidar"), "/rear/points");
  EXPECT_EQ(session(2).topic_choice.at("lidar"), "/front/points");
  window_.open_paths({"/data/a.bag"});
  ASSERT_TRUE(settle());
  EXPECT_FALSE(dialog()) << "it is open already";
}

TEST_F(topics, another_choice_is_an_edit_that_brings_the_result_back_when_it_is_undone) {
  window_.open_paths({"/data/one.bag"});
  ASSERT_TRUE(settle());
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(settle());
  workbench_.decisions().decide({motion::PairIndex{4}}, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  const gui::OutputPtr before = workbench_.outcome().output();
  ASSERT_TRUE(before);
  const auto nominal = workbench_.setup().nominal_ins_from_lidar();
  const int revision = workbench_.document().revision();

  QPushButton* choose = button(*window_.findChild<SessionsPanel*>(), "Topics…");
  ASSERT_TRUE(choose && choose->isEnabled());
  choose->click();
  ASSERT_TRUE(asked());
  EXPECT_EQ(dialog()->choice().at("lidar"), "/front/points") << "as it is used";
  dialog()->choose("imu", "none");
  accept();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !session().topic_choice.empty(); }, kPatience_ms));
  ASSERT_TRUE(settle());
  EXPECT_EQ(session().topic_choice.at("imu"), "none");
  EXPECT_FALSE(workbench_.outcome().output()) << "it was of other topics";
  EXPECT_GT(workbench_.document().revision(), revision) << "a project has to be saved";

  workbench_.history().stack().undo();
  ASSERT_TRUE(settle());
  EXPECT_TRUE(session().topic_choice.empty());
  EXPECT_EQ(workbench_.outcome().output(), before);
  EXPECT_EQ(workbench_.outcome().output()->pairs.at(4).state, motion::PairState::Rejected);
  EXPECT_FALSE(workbench_.calibrations().out_of_date());
  ASSERT_TRUE(workbench_.setup().nominal_ins_from_lidar());
  EXPECT_TRUE(workbench_.setup().nominal_ins_from_lidar()->isApprox(*nominal));
  workbench_.history().stack().redo();
  ASSERT_TRUE(settle());
  EXPECT_EQ(session().topic_choice.at("imu"), "none");
  EXPECT_FALSE(workbench_.outcome().output());
  workbench_.history().stack().undo();
  workbench_.history().stack().undo();
  ASSERT_TRUE(settle());
  EXPECT_NE(workbench_.outcome().output()->pairs.at(4).state, motion::PairState::Rejected) << "the edit before it";
}

TEST_F(topics, the_nominal_of_the_former_frames_goes_with_them) {
  window_.open_paths({"/data/one.bag"});
  ASSERT_TRUE(settle());
  EXPECT_NEAR(workbench_.setup().nominal_ins_from_lidar()->translation().x(), 1.0, 1e-12);
  workbench_.session_edits().choose_topics(
      motion::SessionIndex{0}, {{"lidar", "/rear/points"}, {"ins", "/ins/imu"}, {"ins-position", "/ins/fix"}});
  ASSERT_TRUE(settle());
  EXPECT_NEAR(workbench_.setup().nominal_ins_from_lidar()->translation().x(), -1.0, 1e-12)
      << "that of the LiDAR that is used now";
  workbench_.history().stack().undo();
  EXPECT_NEAR(workbench_.setup().nominal_ins_from_lidar()->translation().x(), 1.0, 1e-12);
}

TEST_F(topics, undone_while_it_calibrates_the_run_of_the_other_topics_is_dropped) {
  window_.open_paths({"/data/one.bag"});
  ASSERT_TRUE(settle());
  workbench_.session_edits().choose_topics(
      motion::SessionIndex{0}, {{"lidar", "/rear/points"}, {"ins", "/ins/imu"}, {"ins-position", "/ins/fix"}});
  ASSERT_TRUE(settle());
  *hold_at_ = 5;
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench_.activity().stage().empty(); }, kPatience_ms));
  workbench_.history().stack().undo();
  ASSERT_TRUE(settle());
  *hold_at_ = -1;
  EXPECT_FALSE(workbench_.outcome().output()) << "nothing of a run whose session is gone";
  EXPECT_TRUE(session().topic_choice.empty());
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(settle());
  EXPECT_TRUE(workbench_.outcome().output());
}

TEST_F(topics, undone_while_it_calibrates_the_decisions_before_are_solved) {
  window_.open_paths({"/data/one.bag"});
  ASSERT_TRUE(settle());
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(settle());
  workbench_.decisions().decide({motion::PairIndex{4}},
                                motion::PairState::Rejected);  // its solution has no time to come back
  const std::shared_ptr<const drive::Session> front = workbench_.sessions().all()[0],
                                              rear = std::make_shared<const drive::Session>(bag_session(
                                                  front->path, {{"lidar", "/rear/points"}, {"ins", "/ins/imu"}}));
  workbench_.history().stack().push(
      new gui::TopicsCommand(workbench_.session_edits(), workbench_.setup(), workbench_.calibrations(), front, rear));
  ASSERT_FALSE(workbench_.outcome().output());
  *hold_at_ = 5;
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench_.activity().stage().empty(); }, kPatience_ms));
  workbench_.history().stack().undo();
  *hold_at_ = -1;
  ASSERT_TRUE(settle());
  ASSERT_TRUE(workbench_.outcome().output());
  EXPECT_EQ(workbench_.outcome().output()->pairs.at(4).state, motion::PairState::Rejected);
  EXPECT_FALSE(workbench_.solutions().incomplete()) << "the run of the other topics had stopped the solution";
}

TEST_F(topics, the_dialog_is_used_by_keys_and_read_aloud) {
  window_.open_paths({"/data/many.bag"});
  ASSERT_TRUE(asked());
  for (QComboBox* combo : dialog()->findChildren<QComboBox*>()) {
    EXPECT_TRUE(combo->accessibleName().startsWith("Topic that serves as ")) << combo->accessibleName().toStdString();
    EXPECT_NE(combo->focusPolicy(), Qt::NoFocus);
  }
  EXPECT_EQ(dialog()->findChild<QTreeWidget*>()->accessibleName(), "All topics of the recording");
  auto* first = qobject_cast<QComboBox*>(dialog()->focusWidget());
  ASSERT_TRUE(first) << "the focus begins at the LiDAR";
  EXPECT_EQ(first->currentText(), "/front/points");
  QTest::keyClick(first, Qt::Key_Down);
  EXPECT_EQ(dialog()->choice().at("lidar"), "/lio/odometry");
  int keys = 0;
  for (QLabel* label : dialog()->findChildren<QLabel*>()) keys += label->buddy() && label->text().contains('&');
  EXPECT_EQ(keys, 5) << "each role has a key of its own";
  dialog()->reject();
}

TEST_F(topics, the_dialog_speaks_chinese) {
  const testing::LanguageFor spoken("zh_CN");
  TopicsDialog chinese("many.bag", many_topics());
  chinese.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&chinese, kPatience_ms));
  photograph(chinese, "topics-chinese");
  QStringList texts{chinese.windowTitle()};
  for (QLabel* label : chinese.findChildren<QLabel*>()) texts << label->text();
  for (QPushButton* one : chinese.findChildren<QPushButton*>()) texts << one->text() << one->toolTip();
  for (QComboBox* combo : chinese.findChildren<QComboBox*>()) texts << combo->accessibleName();
  auto* table = chinese.findChild<QTreeWidget*>();
  for (int column = 0; column < table->columnCount(); ++column) {
    texts << table->headerItem()->text(column);
    for (int i = 0; column > 1 && i < table->topLevelItemCount(); ++i) texts << table->topLevelItem(i)->text(column);
  }
  static const QRegularExpression kEnglish(QStringLiteral("[a-z]{4,}"));
  for (QString text : texts) {
    text.remove("many.bag");
    EXPECT_FALSE(text.contains(kEnglish)) << text.toStdString();
  }
  EXPECT_GT(texts.size(), 50);
}

TEST(bags_in_the_window, a_bag_on_disk_is_listed_asked_about_and_read) {
  const QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("two.bag").toStdString();
  bags::BagMaker bag(path);
  bag.add_ins("/ins", 41);
  bag.add_scans("/front", 20, 30);
  bag.add_scans("/top", 20, 50);
  bag.finish();
  gui::Engine engine = testing::sample_engine();
  engine.open = gui::model_engine().open;
  engine.offer_topics = gui::model_engine().offer_topics;
  gui::Workbench workbench(engine);
  gui::MainWindow window(workbench, gui::all_features());
  window.show();
  window.open_paths({QString::fromStdString(path.string())});
  TopicsDialog* dialog = nullptr;
  ASSERT_TRUE(QTest::qWaitFor([&] { return (dialog = window.findChild<TopicsDialog*>()) != nullptr; }, kPatience_ms));
  EXPECT_EQ(dialog->choice().at("lidar"), "/top");
  dialog->choose("lidar", "/front");
  dialog->accept();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.sessions().all().empty(); }, kPatience_ms));
  EXPECT_EQ(workbench.sessions().all()[0]->scans->load(0).size(), 30U);
  // The project opens it as it was chosen, and asks nobody.
  const QString project = folder.filePath("job.remount");
  workbench.document().save(project);
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench.document().path() == project; }, kPatience_ms));
  workbench.document().open(project);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.activity().opening(); }, kPatience_ms));
  EXPECT_EQ(workbench.sessions().all().at(0)->topic_choice.at("lidar"), "/front");
  EXPECT_EQ(workbench.sessions().all().at(0)->scans->load(0).size(), 30U);
}

}  // namespace
}  // namespace remount::widgets
