// Captures of each make of LiDAR, of a few packets.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "model/formats/bags/bag_writer.h"
#include "tests/model/formats/sample_inputs.h"

namespace remount::formats {

/// For the readers of captures, with what lies beside them.
std::vector<Sample> captured_samples();

/// Packets of several makes as their drivers publish them, with what lies beside captures on topics.
std::string bag_of_packets(std::unique_ptr<bags::BagWriter> (*make)(const std::filesystem::path& path));

}  // namespace remount::formats
