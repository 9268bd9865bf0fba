// Whether times of points can be those of one sweep, judged by the time between scans and by where the points lie.
// docs/maths/sweeps.md (W7)
#pragma once

#include <string>

#include "model/drive/session.h"
#include "model/formats/clouds/cloud_file.h"

namespace remount::formats {

/// What is wrong with the times of a scan, where they span much more than the time between scans, or, of a sensor that
/// looks all around, so much less that it is no turn; empty where they can be of one
/// sweep. "column time spans 1.000 s in a scan, while scans are 0.100 s apart"
/// @param interval_s 0 where it is not known
Message sweep_misfit(const ReadCloud& read, double interval_s);

/// What is wrong with times that are all multiples of a step too coarse for a sweep; empty where they are not. "column
/// gps_time comes in steps of 0.031 s: 32-bit floats cannot hold seconds of the day or the week"
Message coarse_times(const ReadCloud& read);

/// Open where the points, by their times, would go around the other way than they are stored, or, where their order
/// tells nothing, counter-clockwise.
drive::TimesCount times_count(const cloud::PointCloud& cloud);

}  // namespace remount::formats
