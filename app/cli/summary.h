// A result in words, for the terminal.
#pragma once

#include <string>
#include <vector>

#include "algorithms/messages/catalogue.h"
#include "model/results/result_file.h"
#include "model/results/vehicle_file.h"

namespace remount::cli {

/// X with sigma, pairs with the reasons of rejection, time offset, advice. Names of parameters are as options have
/// them.
std::string summary(const results::ResultFile& file, Language language);

/// Where LiDARs sit against each other with sigma, what is said of their heights, and notes; warnings have been printed
/// already.
std::string relatives_summary(const results::VehicleFile& vehicle, const std::vector<Message>& heights,
                              Language language);

}  // namespace remount::cli
