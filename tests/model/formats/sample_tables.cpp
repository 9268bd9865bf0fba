#include "tests/model/formats/sample_tables.h"

#include <vector>

#include "tests/fuzz/readers.h"
#include "tests/model/formats/sample_files.h"

namespace remount::formats {

using namespace samples;

namespace {

/// A table with commas of decimals, and scans with a table of their times.
std::vector<PackedFile> undeclared_files() {
  std::string table = "Zeit (s);Lat (deg);Lon (deg);Alt (m);Heading (deg);Pitch (deg);Roll (deg)\n", times;
  for (int i = 0; i < 60; ++i)
    table += std::to_string(1'600'000'000 + i / 2) + (i % 2 ? ",5" : ",0") + ";48,00" + std::to_string(1000 + 5 * i) +
             ";9,00" + std::to_string(1000 + i * i) + ";250,5;" + std::to_string(10 + 2 * i) + ",25;0,5;-0,25\n";
  std::vector<PackedFile> files{{"motion.csv", table}};
  for (int i = 0; i < 6; ++i) {
    files.push_back({"scans/" + std::to_string(8 + i) + ".bin", kitti_bin(10)});
    times += "2020-09-13 12:26:4" + std::to_string(i) + ".25\n";
  }
  files.push_back({"times.txt", times});
  return files;
}

std::string undeclared_table() { return pack_files(undeclared_files()); }

/// The same with its manifest. @param metric positions are metres
std::string declared_table(bool metric) {
  const std::string position = metric ? "    position: {east: 4, north: 5, down: 3}\n"
                                      : "    latitude: {index: 1, unit: deg}\n    longitude: {index: 2, unit: deg}\n"
                                        "    height: {index: 3, unit: m}\n";
  std::vector<PackedFile> files = undeclared_files();
  files.push_back({"session.yaml",
                   "format: remount-session/1\nname: declared\nscans:\n  directory: scans\n  type: kitti-bin\n"
                   "  stamps: {file: times.txt, table: {separator: bar}, time: {index: 0, unit: date, scale: unix}}\n"
                   "  timing: instant\n" +
                       std::string(metric ? "ins_poses" : "ins") +
                       ":\n  file: motion.csv\n  table: {separator: semicolon, decimals: comma, skip_lines: 1}\n"
                       "  columns:\n    time: {index: 0, unit: s, scale: unix, offset_s: 0.25}\n" +
                       position +
                       "    attitude: {convention: heading, unit: deg, yaw: 4, pitch: 5, roll: 6, negated: [roll]}\n"});
  return pack_files(files);
}

/// Times in columns of year to second, rows without a value, and scans with dates in their names.
/// @param declared with its manifest
std::string table_of_parts(bool declared) {
  std::string table = "year,month,day,hour,minute,second,Microseconds,lat,lon,alt,heading,pitch,roll\n";
  for (int i = 0; i < 60; ++i)
    table += "2020,9,13,12,26," + std::to_string(10 + i / 2) + (i % 2 ? ",500000" : ",0") + ",48.00" +
             std::to_string(1000 + 5 * i) + ",9.00" + std::to_string(1000 + i * i) + ",250.5," +
             (i % 9 == 4 ? "-9999" : std::to_string(10 + 2 * i)) + (i % 9 == 5 ? ",N/A" : ",0.5") + ",-0.25\n";
  std::vector<PackedFile> files{{"motion.csv", table}};
  for (int i = 0; i < 6; ++i)
    files.push_back({"scans/top_20200913_12261" + std::to_string(i) + "_250.bin", kitti_bin(10)});
  if (declared)
    files.push_back(
        {"session.yaml",
         "format: remount-session/1\nname: parts\nscans: {directory: scans, type: kitti-bin, stamps: {names: "
         "date}, timing: instant}\n"
         "ins:\n  file: motion.csv\n  table: {no_value: -9999}\n  columns:\n"
         "    time: {name: second, unit: s, scale: unix, year: year, month: month, day: day, hour: hour, minute: "
         "minute, microseconds: Microseconds}\n"
         "    latitude: {name: lat, unit: deg}\n    longitude: {name: lon, unit: deg}\n    height: {name: alt, "
         "unit: m}\n    attitude: {convention: heading, unit: deg, yaw: heading, pitch: pitch, roll: roll}\n"});
  return pack_files(files);
}

}  // namespace

std::vector<Sample> table_samples() {
  return {{"described", "table", undeclared_table()},
          {"described", "parts", table_of_parts(false)},
          {"native", "declared-time-in-parts", table_of_parts(true)},
          {"native", "declared", declared_table(false)},
          {"native", "declared-poses", declared_table(true)}};
}

}  // namespace remount::formats
