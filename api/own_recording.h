// What a reader of somebody else's has read, as a session.
#pragma once

#include "algorithms/cloud/point_cloud.h"
#include "model/drive/session.h"
#include "remount/session.h"

namespace remount::api {

/// Without points that are no return. Throws remount::Error(Format) at `where` for columns of different lengths.
cloud::PointCloud cloud_of(const Scan& scan, const std::string& where);

/// As a reader delivers it. Throws remount::Error: Contract where stamps do not ascend or there is no INS, Format for a
/// pose that is none.
drive::Session session_of(const Recording& recording);

}  // namespace remount::api
