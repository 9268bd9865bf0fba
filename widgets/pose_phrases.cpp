#include "widgets/pose_phrases.h"

#include <QtGlobal>

namespace remount {

const std::vector<const char*>& pose_phrases() {
  static const std::vector<const char*> phrases{
      QT_TRANSLATE_NOOP("remount::model", "x backward, y right, z up"),
      QT_TRANSLATE_NOOP("remount::model", "x left, y backward, z up"),
      QT_TRANSLATE_NOOP("remount::model",
                        "By the direction of travel the axes of the INS are %1, not %2. The result is in the axes of "
                        "the log, and is called by these."),
      QT_TRANSLATE_NOOP("remount::model", "By the direction of travel the axes of the INS are %1."),
      QT_TRANSLATE_NOOP("remount::model", "Exports that turn axes, and the obstacle check, go by what looks forward."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Nothing; where a robot moves sideways at will, mind that its axes are called otherwise."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Positions are of the UTM grid and attitudes relative to true north, which are %1 degrees apart there: "
          "attitudes were turned to the grid by that, and distances divided by the grid's scale."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Positions are of the UTM grid, and attitudes are taken to be relative to its north, too; "
                        "distances were divided by the grid's scale."),
      QT_TRANSLATE_NOOP("remount::model",
                        "By the fixes, positions are of a grid whose north is %1 degrees from the true one, to which "
                        "attitudes are relative: they were turned to the grid by that."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Positions have the numbers of a grid that need not be UTM, and are left as they are. Which "
                        "north the attitudes count from, that of the grid or the true one, is not known: yaw is "
                        "uncertain by %1 degrees, which its sigma includes."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Which north the attitudes count from was judged by the direction of travel, and may be "
                        "another: yaw is uncertain by %1 degrees, which its sigma includes."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Which north the attitudes count from, that of the grid or the true one, is not known: yaw is "
                        "uncertain by %1 degrees, which its sigma includes."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The heading of the INS keeps %1 degrees from the direction of travel. Either the INS is "
                        "turned so in the vehicle, or positions are of a grid (UTM) and attitudes relative to true "
                        "north, which the data do not tell: yaw is uncertain by %2 degrees, which its sigma includes."),
      QT_TRANSLATE_NOOP("remount::model", "positions and attitudes of the INS may count from different norths"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Without that, yaw of X would be off by the grid's convergence without a sign of it."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Give latitude and longitude where you have them, as a NavSatFix or in a session.yaml."),
      QT_TRANSLATE_NOOP("remount::model", "Distances of the grid are up to a thousandth too long or too short."),
      QT_TRANSLATE_NOOP("remount::model", "Give latitude and longitude where you have them."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Positions and attitudes that count from different norths turn X about the vertical."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Record the fixes of the same drive, too, or give latitude and longitude with attitudes to true north."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 sample is beyond anything that a vehicle reaches (positions beyond 1e9 m, or 250 km from "
                        "the rest): left out."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 samples are beyond anything that a vehicle reaches (positions beyond 1e9 m, or 250 km from "
                        "the rest): left out."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 sample is beyond anything that a vehicle reaches (no latitude, longitude and height on the "
                        "earth): left out."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 samples are beyond anything that a vehicle reaches (no latitude, longitude and height on "
                        "the earth): left out."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "%1 sample is beyond anything that a vehicle reaches (values beyond a million, or none at all): left out."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "%1 samples are beyond anything that a vehicle reaches (values beyond a million, or none at all): left out."),
      QT_TRANSLATE_NOOP("remount::model", "Glitches of a filter or of its log; what lies between them is used."),
      QT_TRANSLATE_NOOP("remount::model", "Look at the source of the stream where they are many."),
      QT_TRANSLATE_NOOP("remount::model",
                        "no position of the %1 lies on the earth (all are beyond 1e9 m, or hundreds of kilometres "
                        "apart): look what is logged for a position, and in which unit"),
      QT_TRANSLATE_NOOP("remount::model", "no position of the INS lies on the earth"),
      QT_TRANSLATE_NOOP("remount::model", "the position is beyond 1e9 m"),
      QT_TRANSLATE_NOOP("remount::model", "%1 moves by more than 1e9 m: is it in metres?"),
      QT_TRANSLATE_NOOP("remount::model", "the two scans are expected to lie farther apart than any LiDAR sees"),
      QT_TRANSLATE_NOOP("remount::model", "no vehicle moves so far"),
      QT_TRANSLATE_NOOP("remount::model",
                        "the positions of the INS look like earth-centred coordinates (ECEF), x, y and z from the "
                        "middle of the earth: convert them to metres east, north and up of the start, or give latitude "
                        "and longitude in a session.yaml"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "the positions of the INS look like degrees, latitude and longitude where x and y in metres are expected: "
          "convert them to metres, or declare them as latitude and longitude in a session.yaml"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "the positions of the INS look like radians, latitude and longitude where x and y in metres are expected: "
          "convert them to metres, or declare them as latitude and longitude in a session.yaml"),
      QT_TRANSLATE_NOOP("remount::model", "By their size the times are taken to be milliseconds."),
      QT_TRANSLATE_NOOP("remount::model", "By their size the times are taken to be microseconds."),
      QT_TRANSLATE_NOOP("remount::model", "By their size the times are taken to be nanoseconds."),
      QT_TRANSLATE_NOOP("remount::model", "Stamps in another unit would be none at all."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Name the unit in the first line, as in \"# timestamp [ns] tx ty tz qx qy qz qw\"."),
      QT_TRANSLATE_NOOP("remount::model",
                        "the unit of its times cannot be told by their size: name it in a first line, as in '# "
                        "timestamp [ns] tx ty tz qx qy qz qw'"),
      QT_TRANSLATE_NOOP("remount::model", "'%1' is no time in milliseconds"),
      QT_TRANSLATE_NOOP("remount::model", "'%1' is no time in microseconds"),
      QT_TRANSLATE_NOOP("remount::model", "'%1' is no time in nanoseconds"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The stamps are %1 weeks before those they belong to: the week number of GPS begins anew every 1024 weeks, "
          "and a receiver with old firmware takes one turn for another. They were moved by that."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The stamps are %1 weeks after those they belong to: the week number of GPS begins anew every 1024 weeks, "
          "and a receiver with old firmware takes one turn for another. They were moved by that."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The receiver counts a wrong number of weeks; that is mended, and nothing is lost by it."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Update the firmware of the receiver: other programs take its stamps as they are."),
  };
  return phrases;
}

}  // namespace remount
