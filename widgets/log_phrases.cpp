#include "widgets/log_phrases.h"

#include <QtGlobal>

namespace remount {

const std::vector<const char*>& log_phrases() {
  static const std::vector<const char*> phrases{
      QT_TRANSLATE_NOOP("remount::model", "%1 entry repeats the stamp before it; the best of each is used."),
      QT_TRANSLATE_NOOP("remount::model", "%1 entries repeat the stamp before them; the best of each is used."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 fix lies more than 2 degrees of latitude or longitude from the rest: left out."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 fixes lie more than 2 degrees of latitude or longitude from the rest: left out."),
      QT_TRANSLATE_NOOP("remount::model", "%1 is '%2', which stands for a value that was not known"),
      QT_TRANSLATE_NOOP("remount::model",
                        "roll, pitch or azimuth is a number that stands for a value that was not known"),
      QT_TRANSLATE_NOOP("remount::model", "roll, pitch or yaw is a number that stands for a value that was not known"),
      QT_TRANSLATE_NOOP("remount::model", "%1 is a number that stands for a value that was not known"),
      QT_TRANSLATE_NOOP("remount::model", "the receiver had no fix"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The attitude is taken from %1, and the position with it; %2 other positions are not used."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The attitude is taken from %1, and the position with it; %2 other positions are not used, nor "
                        "the attitudes of %3."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The attitude is taken from %1, and the position with it; %2 other position is not used."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The attitude is taken from %1, and the position with it; %2 other position is not used, nor "
                        "the attitudes of %3."),
      QT_TRANSLATE_NOOP("remount::model", "The attitude is taken from %1; the attitudes of %2 are not used."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The log has the heading and pitch of two antennas (%1) and no roll: it is taken to be zero, "
                        "with an error of 3 degrees (1 sigma) that lasts over the drive."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "%1 status of the INS has the name of a status of a position (SINGULARITY for INS_SOLUTION_GOOD): ROS' "
          "novatel_gps_driver took them from the wrong table before September 2026. They are read as what was meant."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "%1 statuses of the INS have the name of a status of a position (SINGULARITY for INS_SOLUTION_GOOD): ROS' "
          "novatel_gps_driver took them from the wrong table before September 2026. They are read as what was meant."),
      QT_TRANSLATE_NOOP("remount::model", "expected '%1<header>;<data>*<crc>'"),
      QT_TRANSLATE_NOOP("remount::model", "position and attitude of the INS itself, without errors"),
      QT_TRANSLATE_NOOP("remount::model", "nobody fills in its orientation: it is all zero, or no number"),
      QT_TRANSLATE_NOOP("remount::model", "packets of the sensor, which its driver makes points of"),
      QT_TRANSLATE_NOOP("remount::model",
                        "holds the packets of a sensor as they came over the wire (%1), %2 messages. They are not "
                        "read: the driver of the sensor makes points of them."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Nobody fills in the orientation of this topic: it is all zero, or no number. It can be "
                        "neither the INS nor the LiDAR."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The recording was interrupted, and its folder cannot be written, which the database needs to "
                        "read what is in its log: a temporary copy is read."),
      QT_TRANSLATE_NOOP("remount::model", "cannot be unpacked in %1: %2; set TMPDIR to a folder with more room, or %3"),
      QT_TRANSLATE_NOOP("remount::model", "unpack it with 'zstd -d'"),
      QT_TRANSLATE_NOOP("remount::model", "copy the bag to a folder that can be written"),
      QT_TRANSLATE_NOOP("remount::model", "only %1 are free"),
      QT_TRANSLATE_NOOP("remount::model",
                        "cannot be unpacked, there is no folder for temporary files: %1; set TMPDIR to one, or %2"),
      QT_TRANSLATE_NOOP("remount::model", "copying the bag, MB"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The orientation of this IMU is not measured. With one it would be the INS, to which fixes "
                        "give the position."),
      QT_TRANSLATE_NOOP("remount::model", "is no session that Remount knows: it is %1. %2 Remount looks for:%3"),
      QT_TRANSLATE_NOOP("remount::model",
                        "is no session that Remount knows. It holds %1 (%2). %3 Remount looks for:%4"),
      QT_TRANSLATE_NOOP("remount::model", "Fixes far from all others are glitches of the receiver, and left out."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Of several sentences with an attitude one kind serves: mixed, they would be of different sensors."),
      QT_TRANSLATE_NOOP("remount::model", "Nothing, where it is the right one; otherwise log that one alone."),
      QT_TRANSLATE_NOOP("remount::model", "Roll is a guess: of the mounting only yaw, and x and y, can be relied on."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Use an INS that measures roll; or give what you measured, or the height of the INS above ground."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Were the names taken by their words, the INS would seem to be invalid throughout."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Update the driver before you record again; this recording is read as it was meant."),
      QT_TRANSLATE_NOOP("remount::model", "Packets have no points that could be registered."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Play the bag with the sensor's driver running, and record the points that it publishes."),
      QT_TRANSLATE_NOOP("remount::model", "Nothing of the topic that would be the INS can be used."),
      QT_TRANSLATE_NOOP("remount::model",
                        "See what the driver of the INS reports, or choose another topic as the INS."),
      QT_TRANSLATE_NOOP("remount::model", "What was recorded last lies in the database's log."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Nothing, where there is room for the copy; closing the recorder properly saves it."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Of entries with one stamp only one is used: the best where they say how good they are, "
                        "otherwise the first."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Turn fully to each side at least once: in a figure of eight with a vehicle, on the spot with "
                        "a machine that slews."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Look at clock and attitude of the INS. Where the LiDAR gave poses instead of scans, look whether they are "
          "what they are taken for: of this drive, in metres, and from the LiDAR to the world."),
      QT_TRANSLATE_NOOP("remount::model", "a capture of network packets (pcap)"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Play it through the driver of the sensor, and record the points that it makes as a bag."),
      QT_TRANSLATE_NOOP("remount::model", "u-blox's binary log (UBX)"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Convert it to NMEA with sentences GGA, GST and RMC, as u-center does, or to GPX."),
      QT_TRANSLATE_NOOP("remount::model", "NovAtel's binary log"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Convert it to ASCII with NovAtel Convert: INSPVAXA at 10 Hz or more is read."),
      QT_TRANSLATE_NOOP("remount::model", "NovAtel's ASCII log without INSPVAXA or INSPVAA"),
      QT_TRANSLATE_NOOP("remount::model", "Log one of the two: they have position and attitude of the INS."),
      QT_TRANSLATE_NOOP("remount::model", "Septentrio's binary log (SBF)"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Convert it to NMEA with sentences GGA, GST, RMC and PSSN,HRP, or its INS solution to a CSV, "
                        "and name the columns in a session.yaml."),
      QT_TRANSLATE_NOOP("remount::model", "a trajectory of Applanix (SBET)"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Export it as a CSV with time, latitude, longitude, height, roll, pitch and heading, and name "
                        "the columns in a session.yaml."),
      QT_TRANSLATE_NOOP("remount::model", "the binary log of an OxTS INS (NCOM)"),
      QT_TRANSLATE_NOOP("remount::model", "Export it as a CSV with NAVsolve, and name the columns in a session.yaml."),
      QT_TRANSLATE_NOOP("remount::model", "the raw log of an Applanix POS"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Process it, export the trajectory as a CSV, and name the columns in a session.yaml."),
      QT_TRANSLATE_NOOP("remount::model", "GNSS observations (RINEX)"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Process them to positions first: NMEA or GPX is read, or a CSV that a session.yaml names."),
      QT_TRANSLATE_NOOP("remount::model", "GNSS corrections (RTCM 3)"),
      QT_TRANSLATE_NOOP("remount::model", "Positions are needed: log NMEA of the receiver."),
      QT_TRANSLATE_NOOP("remount::model", "poses of 12 numbers a line without times, as KITTI's odometry has them"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Put the time of each scan before its pose, as in TUM's format: seconds, x y z, quaternion x y z w."),
      QT_TRANSLATE_NOOP("remount::model", "a compressed point cloud (LAZ)"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Unpack it to LAS, as laszip does; scans belong into a folder, each with its time, which a "
                        "session.yaml describes."),
      QT_TRANSLATE_NOOP("remount::model", "a point cloud"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "One cloud is no drive: scans belong into a folder, each with its time, which a session.yaml describes."),
      QT_TRANSLATE_NOOP("remount::model", "point clouds of a scanner (E57)"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Export each scan as PCD, PLY or LAS, and give them their times in a session.yaml."),
      QT_TRANSLATE_NOOP("remount::model", "a recording of Livox Viewer (LVX)"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Convert it to a bag with Livox's ROS driver, which keeps the times of the points."),
      QT_TRANSLATE_NOOP("remount::model", "a bag by its name that does not begin as one"),
      QT_TRANSLATE_NOOP("remount::model",
                        "It is damaged, or was not copied whole: copy it again from where it was recorded."),
      QT_TRANSLATE_NOOP("remount::model", "an SQLite database that is no bag by its name"),
      QT_TRANSLATE_NOOP("remount::model", "Where it is a bag of ROS 2, call it .db3."),
      QT_TRANSLATE_NOOP("remount::model", "an archive"),
      QT_TRANSLATE_NOOP("remount::model", "Unpack it, and open the folder that comes out."),
      QT_TRANSLATE_NOOP("remount::model", "an HDF5 file"),
      QT_TRANSLATE_NOOP("remount::model", "Export scans and poses from it to formats that are read."),
      QT_TRANSLATE_NOOP("remount::model", "a drawing for maps (KML)"),
      QT_TRANSLATE_NOOP("remount::model", "Export the track as GPX, with the times of its points."),
  };
  return phrases;
}

}  // namespace remount
