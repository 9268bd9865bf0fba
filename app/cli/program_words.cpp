#include "app/cli/program_words.h"

#include "app/cli/arguments.h"

namespace remount::cli {
namespace {

std::vector<std::string> choices_of(CLI::Option& option) {
  try {
    for (int i = 0;; ++i)
      if (const std::string& names = option.get_validator(i)->get_name(); !names.empty()) return split(names, '\n');
  } catch (const CLI::OptionNotFound&) {
    return {};  // there are no more
  }
}

OptionWords words_of(CLI::Option& option) {
  OptionWords words;
  for (const std::string& name : option.get_snames()) words.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) words.names.push_back("--" + name);
  if (option.get_items_expected_max() > 0) words.argument = option.get_type_name();
  words.meaning = option.get_description();
  words.standard = option.get_default_str();
  words.choices = choices_of(option);
  // What it can be told stands behind its kind there, too long for a line of a page.
  if (const std::size_t list = words.argument.find(":{"); list != std::string::npos) {
    words.argument.resize(list);
    words.meaning += "\n";
    for (const std::string& choice : words.choices)
      words.meaning += (words.meaning.ends_with('\n') ? "" : ", ") + choice;
  }
  words.required = option.get_required();
  words.several = option.get_items_expected_max() > 1;
  return words;
}

}  // namespace

std::vector<OptionWords> options_of(CLI::App& verb) {
  std::vector<OptionWords> words;
  for (CLI::Option* option : verb.get_options({}))
    if (!option->get_group().empty()) words.push_back(words_of(*option));
  return words;
}

std::vector<CLI::App*> verbs_of(CLI::App& program) {
  std::vector<CLI::App*> verbs;
  for (CLI::App* verb : program.get_subcommands({}))
    if (!verb->get_group().empty()) verbs.push_back(verb);
  return verbs;
}

}  // namespace remount::cli
