#include <algorithm>

#include "app/cli/program_words.h"
#include "messages/command_help.h"
#include "remount_version.h"

namespace remount::cli {
namespace {

/// Text of a page: nothing in it is an order of troff, and dashes are those that are typed.
std::string troff(const std::string& text) {
  std::string safe;
  bool begins = true;
  for (const char c : text) {
    if (begins && (c == '.' || c == '\'')) safe += "\\&";
    begins = c == '\n';
    if (c == '\\')
      safe += "\\e";
    else if (c == '-')
      safe += "\\-";
    else
      safe += c;
  }
  return safe;
}

/// Lines that stay apart; blanks before one move it to the right.
std::string troff_lines(const std::string& text) {
  std::string lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    lines += (lines.empty() ? "" : ".br\n") + troff(line) + "\n";
    begin = end + 1;
  }
  return lines;
}

std::string bold(const std::string& text) { return "\\fB" + troff(text) + "\\fR"; }
std::string slanted(const std::string& text) { return "\\fI" + troff(text) + "\\fR"; }

std::string man_option(const OptionWords& option, Language language) {
  std::string head;
  for (const std::string& name : option.names) head += (head.empty() ? "" : ", ") + bold(name);
  if (!option.argument.empty()) head += (head.empty() ? "" : " ") + slanted(option.argument);
  if (!option.standard.empty()) head += " [" + troff(option.standard) + "]";
  if (option.required && !option.names.empty()) head += " (" + troff(render(say::help_required(), language)) + ")";
  return ".TP\n" + head + "\n" + troff_lines(option.meaning);
}

std::string man_options(CLI::App& verb, Language language) {
  std::string text;
  for (const OptionWords& option : options_of(verb)) text += man_option(option, language);
  return text;
}

std::string man_usage(CLI::App& verb) {
  std::string text = bold("remount-cli " + verb.get_name()) + " [" + slanted("OPTION") + "...]";
  for (const OptionWords& option : options_of(verb)) {
    if (!option.names.empty()) continue;
    const std::string name = slanted(option.argument) + (option.several ? "..." : "");
    text += option.required ? " " + name : " [" + name + "]";
  }
  return text + "\n";
}

std::string section(const Message& title, Language language) { return ".SH " + troff(render(title, language)) + "\n"; }

}  // namespace

std::string man_page(CLI::App& program, Language language) {
  std::string about = program.get_description();
  for (const std::string_view end : {".", "。"})
    if (about.ends_with(end)) about.resize(about.size() - end.size());
  std::string text = ".\\\" Written by remount-cli --man-page\n.TH REMOUNT-CLI 1 \"\" \"Remount " +
                     std::string(kVersion) + "\" \"Remount\"\n.ad l\n" + section(say::man_name(), language) +
                     "remount\\-cli \\- " + troff(about) + "\n" + section(say::man_synopsis(), language) +
                     bold("remount-cli") + " [" + slanted("OPTION") + "...] " + slanted("VERB") + " [" +
                     slanted("ARGUMENT") + "...]\n" + section(say::man_description(), language) +
                     troff_lines(render(say::man_what_it_does(), language));
  text += section(say::man_options_of_all(), language) + man_options(program, language);
  text += section(say::man_verbs(), language);
  for (CLI::App* verb : verbs_of(program)) {
    text += ".SS " + verb->get_name() + "\n" + man_usage(*verb) + ".PP\n" + troff_lines(verb->get_description()) +
            man_options(*verb, language);
    if (const std::string footer = verb->get_footer(); !footer.empty()) text += ".PP\n" + troff_lines(footer);
  }
  return text + section(say::man_exit_status(), language) + troff_lines(program.get_footer()) +
         section(say::man_see_also(), language) + "remount(1)\n";
}

}  // namespace remount::cli
