// What methods find out about data while they run.
#include "model/checks/builtin.h"

namespace remount {

DataCheck method_run_check() {
  return {
      .kinds = {
          {"odometry-lost", "Poses that are predicted come from no scan: what the LiDAR did there is not known.",
           "Drive more slowly, or where there is more to see; see whether the scans are whole and in order."},
          {"odometry-scans", "A scan that is not aligned has no pose, and takes no part.",
           "Drive more slowly, or where there is more to see; see whether the scans are whole and in order."},
          {"turn-scans", "A scan that is not aligned has no pose, and takes no part.",
           "Drive more slowly, or where there is more to see; see whether the scans are whole and in order."},
          {"odometry-unsettled", "The odometry was made with another mounting than the one it leads to.",
           "Give a better nominal, or drive where there is more to see."},
          {"odometry-restarted", "What spans such a place rests on a prediction.",
           "Look for gaps of the scans there; drive more slowly, or where there is more to see."},
          {"odometry-point-times",
           "Scans that are taken while the vehicle moves stay bent, and align the worse for it.",
           "Have the driver write the times of points from the stamp of the scan, in one unit."},
          {"odometry-drifts",
           "An odometry that leans adds to the way what the vehicle did not drive; pitch or yaw takes it.",
           "See whether the poses are of one frame throughout and in metres; make them with an odometry that closes "
           "loops, or calibrate from the scans."},
          {"clock-open", "X is uncertain by the way that is driven in that time.",
           "Synchronise the clocks, or record an INS with attitude, whose turns show the offset."},
          {"odometry-without-ins", "There is nothing to compare its odometry with.",
           "Record an INS with attitude, or leave the session out."},
          {"trajectory-outliers", "Either these positions and attitudes are wrong, or their clock is.",
           "Look for lost corrections and reflected signals there; where they are many, look at clocks and "
           "conventions."},
          {"nominal-unused", "A place on the vehicle is another number in another frame.",
           "Give the nominal mounting in the frame in which the method finds the sensor, or none."},
          {"registration-sigma",
           "Points that are matched with points, or with cells, are off by more than their number says, the same way "
           "in every pair.",
           "Choose plane-to-plane or pcl-gicp where the sigma is to hold."},
          {"wheel-scale", "A tyre differs by a per cent or two: one of the two is not in metres.",
           "Look at the wheel radius or the units of the wheel speeds, and at the units of the sensor's poses."},
          {"drive-gap", "Dead reckoning does not reach across a gap.",
           "Look for messages that the recorder drops (disk, network, buffers); record again where much is missing."},
          {"first-session-only", "The other sessions take no part.", "Give one session, or poses of a sensor."},
          {"ground-tilted", "The machine stood on a slope, or what was taken for the ground is none.",
           "Record the ground where it is level and free around the machine."},
          {"ground-not-seen", "z, pitch and roll rest on the motion of the drive alone.",
           "Drive where the road around the vehicle is free, or measure z by hand."}}};
}

}  // namespace remount
