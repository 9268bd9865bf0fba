// A result in words, for the terminal.
#pragma once

#include <string>

#include "model/result_file.h"

namespace remount {

/// X with sigma, pairs with the reasons of rejection, time offset, advice.
std::string summary(const ResultFile& file);

}  // namespace remount
