// Makers of the built-in exporters; only exporters.cpp lists them.
#pragma once

#include <memory>

#include "model/results/exporters/exporter.h"

namespace remount {

std::unique_ptr<Exporter> make_yaml_exporter();
std::unique_ptr<Exporter> make_json_exporter();
std::unique_ptr<Exporter> make_matrix_exporter();
std::unique_ptr<Exporter> make_ros1_exporter();
std::unique_ptr<Exporter> make_ros2_exporter();
std::unique_ptr<Exporter> make_urdf_exporter();
std::unique_ptr<Exporter> make_autoware_exporter();
std::unique_ptr<Exporter> make_apollo_exporter();
std::unique_ptr<Exporter> make_apollo_rfu_exporter();
std::unique_ptr<Exporter> make_kitti_exporter();
std::unique_ptr<Exporter> make_opencalib_exporter();

}  // namespace remount
