#include "widgets/forms/option_changes.h"

#include <gtest/gtest.h>

#include <QRegularExpression>

#include "tests/widgets/support/restored.h"
#include "widgets/text/option_access.h"
#include "widgets/text/option_mentions.h"
#include "widgets/text/section_words.h"

namespace remount::widgets {
namespace {

TEST(option_changes, are_named_as_on_the_pages_of_the_options) {
  const testing::LanguageFor english("en");
  settings::Settings then, now;
  EXPECT_TRUE(setting_changes(then, now).isEmpty());
  then.pairing.max_gap_s = 2.5;
  now.pairing.max_gap_s = 1.25;
  now.registration.algorithm = registration::RegistrationAlgorithm::PclGicp;
  then.solve.joint_clouds = true;
  now.solve.joint_clouds = false;
  now.range.yaw_max_rad = degrees_to_radians(90.0);
  now.run.cache_mb = then.run.cache_mb + 100;
  EXPECT_EQ(setting_changes(then, now).join('\n'),
            "Max gap (Pairing): 2.5 s, now 1.25 s\n"
            "Algorithm (Alignment): plane to plane (own engine), now GICP (PCL)\n"
            "Yaw max (Search range): 180°, now 90°\n"
            "Joint clouds (Solution): on, now off");
}

/// Whatever is changed: no key of a file is among the words, and the option's label is.
void expect_words_without_keys(const QString& language) {
  const testing::LanguageFor spoken(language);
  const settings::Settings then;
  for (const OptionField& field : option_fields(then)) {
    if (field.name == "cache_mb") continue;
    settings::Settings now = then;
    const QVariant other = field.kind == OptionKind::Switch ? QVariant(!field.value.toBool())
                           : field.kind == OptionKind::Text ? QVariant("other")
                           : field.kind == OptionKind::Choice
                               ? QVariant((field.value.toInt() + 1) % static_cast<int>(field.choices.size()))
                           : field.kind == OptionKind::Integer ? QVariant(field.value.toInt() + 1)
                                                               : QVariant(field.value.toDouble() + 0.5);
    ASSERT_TRUE(set_option(now, field.section, field.name, other));
    const QString text = setting_changes(then, now).join('\n');
    EXPECT_TRUE(text.startsWith(option_label(field))) << text.toStdString();
    EXPECT_TRUE(text.contains(section_title(field.section))) << text.toStdString();
    static const QRegularExpression kKey(QStringLiteral("[a-z]+[._][a-z]+_?[a-z]*"));
    EXPECT_FALSE(QString(text).remove(QRegularExpression(QStringLiteral("[0-9.]+"))).contains(kKey))
        << text.toStdString();
    EXPECT_EQ(text.contains(QStringLiteral("现在为")), language == "zh_CN") << text.toStdString();
  }
}

TEST(option_changes, hold_no_keys_of_files) { expect_words_without_keys("en"); }

TEST(option_changes, hold_no_keys_of_files_in_chinese) { expect_words_without_keys("zh_CN"); }

TEST(option_mentions, are_in_the_words_of_the_pages) {
  const testing::LanguageFor english("en");
  EXPECT_EQ(with_option_labels("set solve.apply_time_offset to correct it."),
            "set “Apply time offset” (Solution) to correct it.");
  EXPECT_EQ(with_option_labels("pairing.max_gap_s (5) is above pairing.max_distance_m."),
            "“Max gap” (Pairing) (5) is above “Max distance” (Pairing).");
  for (const char* stays : {"solve.joint_clouds: is no switch", "settings.solve.joint_clouds",
                            "/data/pairing.max_gap_s", "drive.bag and solve.nothing_of_the_kind", "1.5 m"})
    EXPECT_EQ(with_option_labels(stays), stays);
}

}  // namespace
}  // namespace remount::widgets
