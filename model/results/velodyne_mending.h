// The calibration file of a Velodyne's driver, with corrections of its beams added.
#pragma once

#include <string>

#include "algorithms/cloud/beam_errors.h"
#include "model/formats/packets/velodyne_calibration.h"

namespace remount::results {

/// The same text but for elevations and distances, each with what is to be added to it at its elevation. The scale of
/// ranges has no place in it.
std::string with_beams_mended(const formats::VelodyneCalibration& calibration, const cloud::BeamErrors& errors);

}  // namespace remount::results
