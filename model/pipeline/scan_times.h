// When the points of a scan were measured, as far as the session and the settings say.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/motion/sweep.h"
#include "model/drive/session.h"
#include "model/settings/settings.h"

namespace remount::pipeline {

/// Times from the stamp, s, one for each point; empty where neither the points nor a sweep tell them.
/// @param sweep which sweep may tell them; nothing: none, for files of some formats do not say whether their scans are
/// compensated
std::vector<float> told_times(const drive::Session& session, const cloud::PointCloud& cloud,
                              const std::optional<drive::SweepModel>& sweep);

/// The sweep by which a session's scans are to be compensated, as the settings have it; nothing: by none.
std::optional<drive::SweepModel> sweep_of(const drive::Session& session, settings::DeskewMode mode);

/// The same as the settings have it; empty where the scan is to be used as it is.
std::vector<float> scan_times(const drive::Session& session, const cloud::PointCloud& cloud, settings::DeskewMode mode);

/// Median step of the first scans' stamps; 0 of a single scan.
double scan_period_s(const drive::ScanSource& scans);

/// When the points of a scan of each session were measured: of a few amid the session the longest, for its first may be
/// the end of a turn. At once where nothing tells it, none of them can be read, or what they tell is longer than two
/// scans follow each other.
std::vector<motion::Sweep> swept_times(const std::vector<std::shared_ptr<const drive::Session>>& sessions,
                                       settings::DeskewMode mode);

/// Whether a clock offset may be told from the scans of a session, or its LiDAR poses: sweeps that are not compensated
/// lie at another time on one side of the sensor than on the other, which looks like an offset.
bool tells_clock(const drive::Session& session, settings::DeskewMode mode);

/// Of the scan with a stamp, which is one of the source's; stamps ascend.
std::string scan_name_at(const drive::ScanSource& scans, std::int64_t stamp_ns);

}  // namespace remount::pipeline
