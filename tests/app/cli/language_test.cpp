// The program in another language.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/app/cli/program_fixture.h"

namespace remount::cli {
namespace {

class cli_language : public ProgramFixture<cli_language> {
 protected:
  static void SetUpTestSuite() {
    make_folder_with_drive(
        "--duration-s 3 --beams 24 --azimuth-steps 400 --scan-rate-hz 5 --ins-from-lidar 1.2,-0.3,0.8,5,1,-1");
  }

  /// Whether a letter of three bytes or more is in it: Chinese, where the names are plain.
  static bool has_chinese(const std::string& text) {
    return std::any_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) >= 0xE3; });
  }
  static void expect_contains(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\nin\n" << text;
  }
};

TEST_F(cli_language, is_english_unless_another_is_asked_for) {
  const Outcome usual = run("inspect " + path("drive")), english = run("--language en inspect " + path("drive"));
  EXPECT_EQ(usual.code, 0) << usual.err;
  EXPECT_FALSE(has_chinese(usual.out + usual.err)) << usual.out << usual.err;
  EXPECT_EQ(usual.out, english.out);
}

TEST_F(cli_language, one_that_is_unknown_is_wrong_usage) {
  for (const char* language : {"--language fr ", "--language ", "--language zh "}) {
    const Outcome outcome = run(language + ("inspect " + path("drive")));
    EXPECT_EQ(outcome.code, 1) << language << outcome.out << outcome.err;
    EXPECT_EQ(outcome.out, "") << language;
  }
}

TEST_F(cli_language, inspect_speaks_it) {
  const Outcome outcome = run("--language zh_CN inspect " + path("drive"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(has_chinese(outcome.out)) << outcome.out;
  EXPECT_EQ(outcome.out.find("usable: yes"), std::string::npos) << outcome.out;
}

TEST_F(cli_language, calibrate_and_compare_speak_it) {
  const std::string result = path("zh.yaml");
  const Outcome outcome = run("calibrate " + path("drive") + " --language zh_CN -o " + result);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* said : {"状态：良好", "1 倍标准差", "帧对：提出", "地图检查：", "结果："})
    expect_contains(outcome.out, said);
  for (const char* english : {"status:", "pairs:", "observed", "thick under"})
    EXPECT_EQ(outcome.out.find(english), std::string::npos) << english << "\n" << outcome.out;
  std::filesystem::copy(result, path("same.yaml"));
  const Outcome compared = run("--language zh_CN compare " + result + " " + path("same.yaml"));
  EXPECT_EQ(compared.code, 0) << compared.err;
  expect_contains(compared.out, "zh 与 same 在标称精度内一致");
}

TEST_F(cli_language, complaints_and_wrong_usage_speak_it) {
  const Outcome missing = run("--language zh_CN calibrate " + path("none"));
  EXPECT_EQ(missing.code, 2);
  EXPECT_TRUE(has_chinese(missing.err)) << missing.err;
  const Outcome reversed = run("--language zh_CN calibrate " + path("drive") + " --range x=2:1");
  EXPECT_EQ(reversed.code, 1);
  expect_contains(reversed.err, "x：最小值 2 米 大于最大值 1 米");
}

TEST_F(cli_language, help_explains_options_in_it) {
  const Outcome simulate = run("--language zh_CN simulate --help");
  EXPECT_EQ(simulate.code, 0) << simulate.err;
  expect_contains(simulate.out, "激光雷达的线数。");
  expect_contains(simulate.out, "行驶的道路。可选 street、flat、");
  const Outcome obstacles = run("obstacles --help --language=zh_CN");
  EXPECT_EQ(obstacles.code, 0) << obstacles.err;
  expect_contains(obstacles.out, "车头，自 INS 沿前向计。 [m]");
  EXPECT_FALSE(has_chinese(run("simulate --help").out));
}

TEST_F(cli_language, settings_are_explained_in_it_and_read_back) {
  const Outcome settings = run("--language zh_CN settings -o " + path("zh_settings.yaml"));
  EXPECT_EQ(settings.code, 0) << settings.err;
  const std::string text = text_of(path("zh_settings.yaml"));
  expect_contains(text, "# 帧对两次扫描之间的最长时间（时间限制）。 [0.01 至 3600 s]");
  expect_contains(text, "[time、distance、either]");
  EXPECT_EQ(run("settings --config " + path("zh_settings.yaml")).out, run("settings").out);
  EXPECT_EQ(run("settings -o " + path("zh_settings.yaml")).code, 0) << "settings replace settings of any language";
}

TEST_F(cli_language, help_speaks_it) {
  const Outcome program = run("--language zh_CN --help");
  EXPECT_EQ(program.code, 0) << program.err;
  for (const char* said : {"用法:", "选项:", "命令:", "退出码：", "只打印错误"}) expect_contains(program.out, said);
  for (const char* verb : {"inspect", "calibrate", "solve", "export", "beams", "compare", "report", "obstacles",
                           "odometry", "batch", "simulate", "settings", "doctor"}) {
    const std::string arguments = std::string(verb) + " --help";
    const Outcome help = run("--language=zh_CN " + arguments);
    EXPECT_EQ(help.code, 0) << verb << help.err;
    EXPECT_TRUE(has_chinese(help.out.substr(0, help.out.find('\n')))) << help.out;
    for (const char* english : {"Usage", "Options", "Positionals", "REQUIRED", "Excludes", "Print this", "Exit code"})
      EXPECT_EQ(help.out.find(english), std::string::npos) << english << "\n" << help.out;
    const Outcome usual = run(arguments);
    EXPECT_FALSE(has_chinese(usual.out)) << usual.out;
    EXPECT_EQ(usual.out, run("--language en " + arguments).out);
  }
  expect_contains(run("--language zh_CN calibrate --help").out, "pairwise 需要");
  expect_contains(run("--language zh_CN inspect --help").out, "\n  kitti-raw：");
}

TEST_F(cli_language, a_fleet_and_the_logs_of_its_jobs_speak_it) {
  std::ofstream(path("fleet.yaml")) << "format: remount-fleet/1\nsettings: {run: {map_check: false}}\n"
                                       "vehicles:\n  - {name: one, sessions: [drive]}\n";
  const Outcome outcome = run("--language zh_CN batch " + path("fleet.yaml"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  expect_contains(outcome.out, "已求解");
  std::string log;
  for (const auto& file : std::filesystem::recursive_directory_iterator(path("")))
    if (file.path().extension() == ".log") log += text_of(file.path());
  expect_contains(log, "状态：良好");
}

}  // namespace
}  // namespace remount::cli
