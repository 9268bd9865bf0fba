// remount-cli: the workbench without a window.
#include <exception>
#include <memory>
#include <new>
#include <sstream>

#include "algorithms/core/error.h"
#include "algorithms/core/parallel.h"
#include "app/cli/choices.h"
#include "app/cli/program_words.h"
#include "app/cli/verbs.h"
#include "messages/command_help.h"
#include "messages/command_line.h"
#include "model/formats/files/printable_text.h"
#include "remount_version.h"

namespace remount::cli {
namespace {

/// Headings and what CLI11 says by itself. Verbs take them over as they are added.
void add_headings(CLI::App& app, const Console& console) {
  const std::pair<const char*, Message> labels[] = {{"Usage", say::help_usage()},
                                                    {"OPTIONS", say::help_options_in_usage()},
                                                    {"SUBCOMMAND", say::help_verb_in_usage()},
                                                    {"Positionals", say::help_positionals()},
                                                    {"REQUIRED", say::help_required()},
                                                    {"Excludes", say::help_excludes()}};
  for (const auto& [label, message] : labels) app.get_formatter()->label(label, console.words(message));
  app.group(console.words(say::help_verbs()));
  app.option_defaults()->group(console.words(say::help_options()));
  app.set_help_flag("-h,--help", console.words(say::help_help()));
  app.set_version_flag("--version", std::string("remount-cli ") + kVersion, console.words(say::help_version()));
  app.footer(console.words(say::help_exit_codes()));
}

void add_common_options(CLI::App& app, Console& console) {
  app.add_flag("-q,--quiet", console.options().quiet, console.words(say::help_quiet()));
  app.add_option("--log", console.options().log_file, console.words(say::help_log()))->type_name("FILE");
  app.add_flag("--append-log", console.options().append_log, console.words(say::help_append_log()));
  app.add_option("-j,--threads", console.options().threads, console.words(say::help_threads()))
      ->check(CLI::Range(0, kMostThreads).description(""))
      ->type_name("N");
  const std::vector<std::string> languages(kLanguageTags.begin(), kLanguageTags.end());
  app.add_option_function<std::string>(
         "--language", [&console](const std::string& tag) { console.options().language = language_of(tag); },
         console.words(say::help_language()))
      ->check(one_of(languages).description(""))
      ->default_str(languages.front())
      ->type_name("zh_CN|en");
}

/// What packages and shells are made of. Written as the help is: nothing else of the command line is looked at.
void add_program_words(CLI::App& app, const Console& console) {
  const std::vector<std::string> shells{"bash", "zsh"};
  app.add_option_function<std::string>(
         "--completion",
         [&app](const std::string& shell) {
           throw CLI::CallForVersion(shell == "zsh" ? zsh_completion(app) : bash_completion(app), kSolved);
         },
         console.words(say::help_completion()))
      ->check(one_of(shells).description(""))
      ->type_name("bash|zsh");
  app.add_flag_callback(
      "--man-page", [&app, &console] { throw CLI::CallForVersion(man_page(app, console.options().language), kSolved); },
      console.words(say::help_man_page()));
}

/// Verbs say what their options mean as they are added, before anything is parsed.
Language language_asked_for(int argc, char** argv) {
  constexpr std::string_view kFlag = "--language";
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == kFlag && i + 1 < argc) return language_of(argv[i + 1]);
    if (word.starts_with(kFlag) && word.substr(kFlag.size()).starts_with('='))
      return language_of(word.substr(kFlag.size() + 1));
  }
  return Language::English;
}

/// What CLI11 calls "a subcommand is required" says neither what was typed nor what would have been right.
Message no_verb(const CLI::App& app) {
  std::string typed;
  std::vector<std::string> verbs;
  for (const std::string& word : app.remaining())
    if (typed.empty() && !word.starts_with('-')) typed = word;
  for (const CLI::App* verb : app.get_subcommands({})) verbs.push_back(verb->get_name());
  return typed.empty()
             ? say::cli_no_verb(verbs)
             : say::cli_unknown_verb(formats::printable(typed.substr(0, 60), formats::LineBreaks::Escaped), verbs);
}

int run_main(int argc, char** argv) {
  Console console;
  console.options().language = language_asked_for(argc, argv);
  CLI::App app(console.words(say::help_program()), "remount-cli");
  add_headings(app, console);
  app.require_subcommand(1);
  app.fallthrough();
  add_common_options(app, console);
  add_program_words(app, console);
  Run run;
  for (const auto add : {add_inspect, add_describe, add_calibrate, add_solve, add_export, add_beams, add_compare,
                         add_report, add_obstacles, add_odometry, add_batch, add_simulate, add_settings, add_doctor})
    add(app, console, run);
  // Verbs have their help flag before they take over how options are grouped.
  for (CLI::App* verb : app.get_subcommands({})) verb->get_help_ptr()->group(console.words(say::help_options()));
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    std::ostringstream text;
    const int code = app.exit(help, text);
    console.deliver(text.str());
    return console.end(code);
  } catch (const CLI::ParseError& problem) {
    // Of what stands before a verb, the verb is not yet known.
    if (app.get_subcommands().empty() && dynamic_cast<const CLI::ValidationError*>(&problem) != nullptr)
      console.complain(say::cli_wrong_option(problem.what()));
    else if (app.get_subcommands().empty())
      console.complain(no_verb(app));
    else
      console.complain(say::cli_wrong_usage(problem.what(), app.get_subcommands().front()->get_name()));
    return kUsage;
  }
  try {
    std::string command_line;
    for (int i = 0; i < argc; ++i)
      command_line += (i == 0 ? "" : " ") + formats::printable(argv[i], formats::LineBreaks::Escaped);
    console.start(command_line);
    return console.end(run());
  } catch (const Error& error) {
    console.complain(error);
    return exit_code_of(error);
  } catch (const std::bad_alloc&) {
    console.complain(say::cli_no_memory());
    return kUnreadable;
  } catch (const std::exception& error) {
    console.complain(say::cli_unexpected(error.what()));
    return kUnreadable;
  }
}

}  // namespace
}  // namespace remount::cli

int main(int argc, char** argv) { return remount::cli::run_main(argc, argv); }
