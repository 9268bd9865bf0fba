// A result in words, for the terminal.
#pragma once

#include <string>

#include "algorithms/messages/catalogue.h"
#include "model/results/result_file.h"

namespace remount::cli {

/// X with sigma, pairs with the reasons of rejection, time offset, advice. Names of parameters are as options have
/// them.
std::string summary(const results::ResultFile& file, Language language);

}  // namespace remount::cli
