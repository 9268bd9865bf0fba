// What an option can be told, for the check of what was typed and for the completion of shells alike.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace remount::cli {

/// Says what an option can be told to what completes it, and checks nothing. Validators have no other room for it than
/// their name, which nothing else uses.
inline CLI::Validator completed_by(const std::vector<std::string>& names, CLI::Validator check = CLI::Validator("")) {
  std::string lines;
  for (const std::string& name : names) lines += (lines.empty() ? "" : "\n") + name;
  return check.name(lines);
}

/// Refuses what is none of them. The list stands in the option's help unless it is described otherwise.
inline CLI::Validator one_of(const std::vector<std::string>& names) {
  return completed_by(names, CLI::IsMember(names));
}

}  // namespace remount::cli
