// Nominal mountings of several LiDARs on the command line.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/cli/console.h"
#include "model/results/exporters/exporter.h"

namespace remount::cli {

struct NamedNominals {
  struct Nominal {
    results::ReadMounting mounting;
    std::string text;  ///< where it came from
  };
  std::map<std::string, Nominal> of;   ///< by names of LiDARs
  bool ignore_declared = false;        ///< even where the data declare one
  std::vector<Message> doubts, notes;  ///< of what files leave open, and hold of others
};

/// @param texts each "NAME=SIX|FILE", a file that holds mountings by names, or "none" @param names of the LiDARs
/// Throws Error.
NamedNominals named_nominals(const std::vector<std::string>& texts, const std::vector<std::string>& names);

/// The same, and says aloud what files leave open and hold of others.
NamedNominals named_nominals(const std::vector<std::string>& texts, const std::vector<std::string>& names,
                             Console& console);

}  // namespace remount::cli
