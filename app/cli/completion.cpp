#include <algorithm>
#include <array>
#include <string_view>

#include "app/cli/arguments.h"
#include "app/cli/program_words.h"
#include "remount_version.h"

namespace remount::cli {
namespace {

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::string names_of(const std::vector<CLI::App*>& verbs, const std::string& between) {
  std::vector<std::string> names;
  for (const CLI::App* verb : verbs) names.push_back(verb->get_name());
  return joined(names, between);
}

std::string flags_of(const std::vector<OptionWords>& options) {
  std::vector<std::string> flags;
  for (const OptionWords& option : options) flags.insert(flags.end(), option.names.begin(), option.names.end());
  return joined(flags, " ");
}

/// Those of a verb that the program does not have before it already, as -h.
std::vector<OptionWords> options_of_verb_alone(CLI::App& verb, const std::vector<OptionWords>& common) {
  std::vector<OptionWords> options = options_of(verb);
  std::erase_if(options, [&](const OptionWords& option) {
    return !option.names.empty() && std::any_of(common.begin(), common.end(),
                                                [&](const OptionWords& known) { return known.names == option.names; });
  });
  return options;
}

/// What is called so is a file or a folder, or may be one.
bool names_file(const std::string& argument) {
  constexpr std::array<std::string_view, 8> kFiles{"FILE",    "FOLDER", "PATH", "RESULT",
                                                   "SESSION", "FLEET",  "OUT",  "PAIRS.csv"};
  const std::vector<std::string> words = split(argument, '|');
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::find(kFiles.begin(), kFiles.end(), word) != kFiles.end();
  });
}

/// Lines of a case: what stands behind the options of a verb ("*": of any).
std::string bash_values(const std::string& verb, const std::vector<OptionWords>& options) {
  std::string lines;
  for (const OptionWords& option : options) {
    if (option.names.empty() || option.argument.empty()) continue;
    std::vector<std::string> patterns;
    for (const std::string& name : option.names) patterns.push_back(verb + ":" + name);
    lines += "    " + joined(patterns, "|") + ")";
    if (!option.choices.empty())
      lines += " words='" + joined(option.choices, " ") + "' ;;\n";
    else
      lines += names_file(option.argument) ? " return ;;\n" : " $no_files; return ;;\n";
  }
  return lines;
}

/// The words that come where no value of an option is asked for: options behind a dash, else what the arguments can be.
std::string bash_words(const std::vector<OptionWords>& options, const std::string& common) {
  std::vector<std::string> choices;
  for (const OptionWords& option : options)
    if (option.names.empty()) choices.insert(choices.end(), option.choices.begin(), option.choices.end());
  return "if [[ $word == -* ]]; then words='" + flags_of(options) + common + "'; else words='" + joined(choices, " ") +
         "'; fi";
}

/// The first clause of what an option means, in letters that have no meaning in a specification of zsh in single
/// quotes.
std::string zsh_brief(std::string text) {
  for (const char* end : {"\n", ": ", "; ", ". ", " ("}) text = text.substr(0, text.find(end));
  std::erase_if(text, [](char c) { return c == '[' || c == ']' || c == ':' || c == '\\' || c == '"'; });
  for (std::size_t at = text.find('\''); at != std::string::npos; at = text.find('\'', at + 4))
    text.replace(at, 1, "'\\''");
  return text;
}

std::string zsh_value(const OptionWords& option) {
  if (option.argument.empty()) return "";
  const std::string what = ":" + zsh_brief(option.argument.substr(0, option.argument.find(':'))) + ":";
  if (!option.choices.empty()) return what + "(" + joined(option.choices, " ") + ")";
  return what + (names_file(option.argument) ? "_files" : " ");  // a blank: it is told, and nothing offered
}

/// Specifications for _arguments, a word each; the first argument is the verb.
std::string zsh_specifications(const std::vector<OptionWords>& options) {
  std::string lines;
  int place = 2;
  for (const OptionWords& option : options) {
    if (option.names.empty()) {
      lines += "      '" + (option.several ? "*" : std::to_string(place++)) + zsh_value(option) + "'\n";
      continue;
    }
    for (const std::string& name : option.names)
      lines += "      '*" + name + "[" + zsh_brief(option.meaning) + "]" + zsh_value(option) + "'\n";
  }
  return lines;
}

std::string written_by(const char* shell) {
  return "# Written by remount-cli " + std::string(kVersion) + " --completion " + shell + "\n";
}

/// Bash and zsh alike: the verb is the first word that is one.
std::string find_verb(const std::vector<CLI::App*>& verbs, const std::string& words) {
  return "  for i in " + words + "; do\n    case $i in " + names_of(verbs, "|") + ") verb=$i; break ;; esac\n  done\n";
}

}  // namespace

std::string bash_completion(CLI::App& program) {
  const std::vector<CLI::App*> verbs = verbs_of(program);
  const std::vector<OptionWords> common = options_of(program);
  std::string text = written_by("bash") +
                     "_remount_cli() {\n"
                     "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} verb= words= i\n"
                     "  local no_files='compopt +o default +o bashdefault'\n"
                     "  COMPREPLY=()\n" +
                     find_verb(verbs, "\"${COMP_WORDS[@]:1:COMP_CWORD-1}\"") + "  case $verb:$before in\n" +
                     bash_values("*", common);
  for (CLI::App* verb : verbs) text += bash_values(verb->get_name(), options_of(*verb));
  text += "    :*) words='" + names_of(verbs, " ") + " " + flags_of(common) + "' ;;\n";
  for (CLI::App* verb : verbs)
    text += "    " + verb->get_name() + ":*) " +
            bash_words(options_of_verb_alone(*verb, common), " " + flags_of(common)) + " ;;\n";
  return text +
         "  esac\n"
         "  COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
         "}\n"
         "complete -o bashdefault -o default -F _remount_cli remount-cli\n";
}

std::string zsh_completion(CLI::App& program) {
  const std::vector<CLI::App*> verbs = verbs_of(program);
  const std::vector<OptionWords> common = options_of(program);
  std::string text = "#compdef remount-cli\n" + written_by("zsh") + "local verb i\nlocal -a verbs common\nverbs=(\n";
  for (const CLI::App* verb : verbs)
    text += "  '" + verb->get_name() + ":" + zsh_brief(verb->get_description()) + "'\n";
  text += ")\ncommon=(\n" + zsh_specifications(common) + ")\n" + find_verb(verbs, "${words[2,CURRENT-1]}") +
          "case $verb in\n"
          "  '') if [[ $PREFIX == -* ]]; then _arguments $common; else _describe -t commands verb verbs; fi ;;\n";
  for (CLI::App* verb : verbs)
    text += "  " + verb->get_name() + ") _arguments $common '1: :' \\\n" + [&] {
      std::string lines = zsh_specifications(options_of_verb_alone(*verb, common));
      for (std::size_t at = lines.find('\n'); at != std::string::npos; at = lines.find('\n', at + 3))
        lines.replace(at, 1, " \\\n");
      return lines;
    }() + "      && return 0 ;;\n";
  return text + "esac\n";
}

}  // namespace remount::cli
