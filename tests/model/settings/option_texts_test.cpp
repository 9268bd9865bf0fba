// Every option says in each language what it is called and what it means.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "algorithms/messages/render.h"
#include "algorithms/quality/obstacle_check.h"
#include "model/settings/settings.h"
#include "model/simulator/simulation_options.h"

namespace remount::settings {
namespace {

bool ends_as_sentence(const std::string& text, Language language) {
  return text.ends_with(language == Language::Chinese ? "。" : ".");
}

bool holds_chinese(const std::string& text) {
  // Not find_first_of: clang 19 forgets what lies above 0x7f.
  return std::any_of(text.begin(), text.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0xe4 && byte <= 0xe9;
  });
}

/// Visits the options of one form, where no two may look alike: a reach in metres and one in degrees have one name.
struct TextChecker {
  std::string section;
  Language language;
  bool has_labels = true;
  std::set<std::string> labels{};
  int options = 0;

  void check(const OptionInfo& info) {
    ++options;
    const std::string option = section + '.' + std::string(info.name);
    ASSERT_NE(info.help, nullptr) << option;
    const std::string help = render(info.help(), language);
    EXPECT_TRUE(ends_as_sentence(help, language)) << option << ": " << help;
    EXPECT_EQ(holds_chinese(help), language == Language::Chinese) << option << ": " << help;
    if (!has_labels) return;
    ASSERT_NE(info.label, kNoLabel) << option;
    const std::string label = render(info.label(), language);
    EXPECT_FALSE(label.empty()) << option;
    EXPECT_TRUE(labels.insert(label + ' ' + std::string(info.unit)).second) << option << ": " << label << ", twice";
  }
  template <class T>
  void operator()(const OptionInfo& info, const T&) {
    check(info);
  }
  template <class T>
  void choice(const OptionInfo& info, const T&, const std::vector<std::string_view>&) {
    check(info);
  }
};

class option_texts : public ::testing::TestWithParam<Language> {};

TEST_P(option_texts, name_and_explain_every_setting) {
  const Settings settings;
  int options = 0;
  Settings::visit_sections(settings, [&](std::string_view name, const auto& section) {
    TextChecker checker{std::string(name), GetParam()};
    std::decay_t<decltype(section)>::visit(section, checker);
    EXPECT_GT(checker.options, 0) << name;
    options += checker.options;
  });
  EXPECT_GT(options, 100);
}

TEST_P(option_texts, name_and_explain_the_outline_of_the_vehicle) {
  TextChecker checker{"obstacles", GetParam()};
  const quality::ObstacleOptions options;
  quality::ObstacleOptions::visit(options, checker);
  EXPECT_GT(checker.options, 0);
}

TEST_P(option_texts, explain_how_drives_are_simulated) {
  TextChecker checker{"simulate", GetParam(), false};
  const simulator::SimulationOptions options;
  simulator::SimulationOptions::visit(options, checker);
  EXPECT_GT(checker.options, 50);
}

INSTANTIATE_TEST_SUITE_P(of, option_texts, ::testing::Values(Language::English, Language::Chinese),
                         [](const auto& of) { return std::string(kLanguageTags[static_cast<std::size_t>(of.param)]); });

}  // namespace
}  // namespace remount::settings
