// Drives of the smartLoc data set (TU Chemnitz, Reisdorf and others 2016): wheel speed, yaw rate, ground truth.
#pragma once

#include "model/formats/sessions/session_reader.h"

namespace remount::formats {

/// Opens `<name>_Input.txt`, or a folder with one such file, with `<name>_GT.txt` beside it where it is there. There is
/// no LiDAR and no INS. What the streams of the session hold:
///   wheels  speed of the vehicle (odom3, x) for both rear wheels alike: the data have no wheel for itself, so the
///           difference of the two says nothing about turning
///   imu     turn rates (odom3), in vehicle axes x forward, y left, z up; specific force is NaN, for there is none
///   gnss    the *ground truth* (point3) and not a receiver's fixes; its covariance is not stated in the data (zeros),
///           a sigma of 0.1 m is put in its place
/// Pseudoranges are not read. Stamps count from the start of the recording, not from 1970.
class SmartlocReader final : public SessionReader {
 public:
  std::string_view id() const override { return "smartloc"; }
  Message description() const override;
  int probe(const std::filesystem::path& path) const override;
  drive::Session open(const std::filesystem::path& path, Progress& progress) const override;
};

}  // namespace remount::formats
