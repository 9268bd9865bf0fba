// What the program says of its verbs and options as they are added, in the forms that shells and man read. There is no
// other list of them: what a verb adds is completed and documented.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "algorithms/messages/message.h"
#include "algorithms/messages/render.h"

namespace remount::cli {

/// An option or a positional argument of a verb.
struct OptionWords {
  std::vector<std::string> names;  ///< with their dashes; none: an argument without a name
  std::string argument;            ///< what stands behind it; empty: nothing does
  std::string meaning, standard;   ///< `standard`: the value that it has when it is not given; may be empty
  std::vector<std::string> choices;
  bool required = false;
  bool several = false;
};

/// Those that are shown in the help, in its order.
std::vector<OptionWords> options_of(CLI::App& verb);
std::vector<CLI::App*> verbs_of(CLI::App& program);

/// A script for bash, or for zsh.
std::string bash_completion(CLI::App& program);
std::string zsh_completion(CLI::App& program);

/// A page for man(1), of the program and all of its verbs.
std::string man_page(CLI::App& program, Language language);

}  // namespace remount::cli
