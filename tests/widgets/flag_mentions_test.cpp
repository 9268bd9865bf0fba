#include "widgets/text/flag_mentions.h"

#include <gtest/gtest.h>

#include <QRegularExpression>

#include "algorithms/messages/catalogue.h"
#include "tests/widgets/support/restored.h"
#include "widgets/text/model_text.h"

namespace remount::widgets {
namespace {

TEST(flag_mentions, are_places_of_the_window) {
  const testing::LanguageFor english("en");
  EXPECT_EQ(with_window_places("Mend the file, or give the mounting with --nominal."),
            "Mend the file, or give the mounting in “Nominal mounting”.");
  EXPECT_EQ(with_window_places("measure the height and give it with --measured."),
            "measure the height and give it in “Measured by hand”.");
  EXPECT_EQ(with_window_places("leave them out: --topic imu=none."), "leave them out: “Topics…: IMU – none”.");
  EXPECT_EQ(with_window_places("odom has 100 Hz: --topic ins=/odom takes it"),
            "odom has 100 Hz: “Topics…: INS – /odom” takes it");
  EXPECT_EQ(with_window_places("(--topic ins-position=TOPIC), or say with --topic which topic is the IMU"),
            "(“Topics…: Position of the INS”), or say in “Topics…” which topic is the IMU");
  EXPECT_EQ(with_window_places("it can be calibrated with --method trajectory or vehicle-frame"),
            "it can be calibrated with the method “Trajectory alignment” or “Vehicle frame”");
  EXPECT_EQ(with_window_places("choose --method slew for an excavator"),
            "choose the method “Slewing machine” for an excavator");
  EXPECT_EQ(in_words_of_window("give --set solve.joint_clouds=off"), "give “Joint clouds” (Solution)=off");
  EXPECT_EQ(with_window_places("--lidars all calibrates all of them together, --topic lidar=NAME reads another."),
            "the panel “LiDARs” calibrates all of them together, “Topics…: LiDAR” reads another.");
  EXPECT_EQ(with_window_places("a -- b, /data/--method"), "a -- b, /data/--method");
}

/// What only the command line says: its own sentences, help, and a line of inspect.
bool is_for_the_command_line(std::string_view code) {
  return code.starts_with("cli-") || code.starts_with("help-") || code == "session-usable-by-others";
}

/// Every sentence of the catalogue, with the id of a method in each of its places.
void expect_no_flags(Language language) {
  const testing::LanguageFor spoken(QString::fromUtf8(kLanguageTags[static_cast<std::size_t>(language)]));
  static const QRegularExpression kFlag(QStringLiteral("--[a-z]")), kPlace(QStringLiteral("\\{[^{}]*\\}"));
  for (const CatalogueEntry& entry : catalogue()) {
    if (is_for_the_command_line(entry.code)) continue;
    QString text = QString::fromUtf8(entry.text[static_cast<std::size_t>(language)]);
    const QString said = in_words_of_window(text.replace(kPlace, QStringLiteral("slew")));
    EXPECT_FALSE(said.contains(kFlag)) << entry.code << ": " << said.toStdString();
  }
}

TEST(flag_mentions, places_have_no_letters_of_the_keyboard) {
  const testing::LanguageFor chinese("zh_CN");
  EXPECT_EQ(with_window_places("--topic lidar=NAME"), QStringLiteral("“话题…：激光雷达”"));
}

TEST(flag_mentions, no_sentence_of_the_model_has_a_flag_in_the_window) { expect_no_flags(Language::English); }

TEST(flag_mentions, no_sentence_of_the_model_has_a_flag_in_the_window_in_chinese) {
  expect_no_flags(Language::Chinese);
}

}  // namespace
}  // namespace remount::widgets
