// Command line options from an option struct that describes itself.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "algorithms/core/index.h"
#include "algorithms/core/options.h"
#include "algorithms/messages/render.h"
#include "app/cli/choices.h"
#include "messages/command_line.h"
#include "model/formats/documents/document.h"

namespace remount::cli {

/// One option for each member: "duration_s" becomes --duration-s, with its unit, range, default and meaning in the
/// help. The enumeration "scenario" becomes a required positional argument.
struct OptionAdder {
  CLI::App& verb;
  Language language;

  static std::string flag(const OptionInfo& info) {
    std::string name = "--" + std::string(info.name);
    for (char& c : name)
      if (c == '_') c = '-';
    return name;
  }
  std::string help(const OptionInfo& info) const {
    return render(info.help(), language) + (info.unit.empty() ? "" : " [" + std::string(info.unit) + "]");
  }

  template <class T>
  void operator()(const OptionInfo& info, T& value) {
    CLI::Option* option = verb.add_option(flag(info), value, help(info))->capture_default_str();
    if constexpr (std::is_same_v<T, bool>) {
      option->type_name("true|false");
    } else if constexpr (std::is_arithmetic_v<T>) {
      CLI::Range range(static_cast<T>(info.minimum), static_cast<T>(info.maximum));
      // The range stands in the option's type already.
      option->check(range.description(""))
          ->type_name(formats::shortest(info.minimum) + ".." + formats::shortest(info.maximum));
    }
  }

  template <class T>
  void choice(const OptionInfo& info, T& value, const std::vector<std::string_view>& names) {
    const std::vector<std::string> known(names.begin(), names.end());
    const auto assign = [&value, known](const std::string& name) {
      value = static_cast<T>(std::find(known.begin(), known.end(), name) - known.begin());
    };
    const bool positional = info.name == "scenario";
    const Message help = Message::sequence({info.help(), say::cli_one_of(known)});
    CLI::Option* option = verb.add_option_function<std::string>(positional ? std::string(info.name) : flag(info),
                                                                assign, render(help, language));
    option->check(one_of(known).description(""));
    if (positional)
      option->required()->type_name("SCENARIO");
    else
      option->type_name("NAME")->default_str(known[index_of(value)]);
  }
};

}  // namespace remount::cli
