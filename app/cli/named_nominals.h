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
  std::map<std::string, Nominal> of;  ///< by names of LiDARs
  bool ignore_declared = false;       ///< even where the data declare one
};

/// @param texts each "NAME=SIX|FILE", a file that holds mountings by names, or "none" @param names of the LiDARs
/// Notes what a file holds of others. Throws Error.
NamedNominals named_nominals(const std::vector<std::string>& texts, const std::vector<std::string>& names,
                             Console& console);

}  // namespace remount::cli
