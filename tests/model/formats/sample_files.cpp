#include "tests/model/formats/sample_files.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "model/formats/files/lzf.h"
#include "model/project/project.h"
#include "tests/fuzz/readers.h"
#include "tests/model/formats/bags/bag_fixtures.h"
#include "tests/model/formats/ins/ncom_records.h"
#include "tests/model/formats/ins/novatel_records.h"
#include "tests/model/formats/ins/sbf_records.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats::samples {

namespace fs = std::filesystem;

// ---- Scans

namespace {

std::string opening(const std::string& count, const std::string& encoding) {
  return "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z ring time\nSIZE 4 4 4 2 4\nTYPE F F F U F\nCOUNT 1 1 1 1 1\nWIDTH " +
         count + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count + "\nDATA " + encoding + "\n";
}

template <class T>
void append(Bytes& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

}  // namespace

Bytes compressed_pcd(int count) {
  Bytes columns;
  for (int column = 0; column < 5; ++column)
    for (int i = 0; i < count; ++i)
      if (column == 3)
        append(columns, static_cast<std::uint16_t>(i % 4));
      else
        append(columns, 0.5f * static_cast<float>(i / 3 + column));
  const Bytes packed = lzf_encode(columns);
  Bytes bytes = opening(std::to_string(count), "binary_compressed");
  append(bytes, static_cast<std::uint32_t>(packed.size()));
  append(bytes, static_cast<std::uint32_t>(columns.size()));
  return bytes + packed;
}

Bytes ply(const std::string& encoding, int count) {
  Bytes bytes = "ply\nformat " + encoding + " 1.0\nelement camera 2\nproperty list uchar float view\nelement vertex " +
                std::to_string(count) +
                "\nproperty float x\nproperty "
                "double y\nproperty float z\nproperty uchar ring\nend_header\n";
  if (encoding == "ascii") {
    bytes += "2 0.5 0.25\n0\n";
    for (int i = 0; i < count; ++i) bytes += std::to_string(i) + " 1.5 -2.25 3\n";
    return bytes;
  }
  const auto put = [&](auto value) {
    append(bytes, value);
    if (encoding == "binary_big_endian") std::reverse(bytes.end() - sizeof value, bytes.end());
  };
  put(std::uint8_t{2}), put(0.5f), put(0.25f), put(std::uint8_t{0});
  for (int i = 0; i < count; ++i) put(static_cast<float>(i)), put(1.5), put(-2.25f), put(std::uint8_t{3});
  return bytes;
}

Bytes ascii_pcd(int count) {
  Bytes rows;
  for (int i = 0; i < count; ++i) rows += std::to_string(i) + " 2.5 3 4 0.01\n";
  return opening(std::to_string(count), "ascii") + rows;
}

Bytes binary_pcd(int count) {
  Bytes rows;
  for (int i = 0; i < count; ++i) {
    for (int axis = 0; axis < 3; ++axis) append(rows, static_cast<float>(i + axis));
    append(rows, static_cast<std::uint16_t>(i)), append(rows, 0.01f);
  }
  return opening(std::to_string(count), "binary") + rows;
}

Bytes kitti_bin(int count) {
  Bytes bytes;
  for (int i = 0; i < count; ++i) {  // as a sensor that turns has them: bare floats are told by what they hold
    const double range_m = 10.0 + i % 7, azimuth_rad = 0.01 * i;
    append(bytes, static_cast<float>(range_m * std::cos(azimuth_rad)));
    append(bytes, static_cast<float>(range_m * std::sin(azimuth_rad)));
    append(bytes, static_cast<float>(-1.7 + 0.1 * (i % 5)));
    append(bytes, static_cast<float>(0.1 * (i % 10)));
  }
  return bytes;
}

// ---- Logs

namespace {

/// Lines of numbers from 0 on, below a head.
template <class Line>
Bytes with_lines(Bytes text, int count, const Line& line) {
  for (int i = 0; i < count; ++i) text += line(i);
  return text;
}

}  // namespace

Bytes poses(const char* separator, int count) {
  Bytes text;
  for (int i = 0; i < count; ++i) {
    const double t = 0.1 * i, yaw = 1.5 * std::sin(0.31 * t) + 0.8 * std::sin(0.83 * t + 1.0);
    char line[256];
    std::snprintf(line, sizeof line, "%.6f%s%.3f%s2%s3%s0%s0%s%.12f%s%.12f\n", 1.6e9 + t, separator, t, separator,
                  separator, separator, separator, separator, std::sin(yaw / 2), separator, std::cos(yaw / 2));
    text += line;
  }
  return text;
}

Bytes pose_lines(int count) {
  Bytes text;
  for (int i = 0; i < count; ++i) {
    char line[256];
    std::snprintf(line, sizeof line, "2021-10-26-16-21-%02d-%03d 1 0 0 %d 0 1 0 0 0 0 1 0\n", 10 + i / 10, i % 10 * 100,
                  i);
    text += line;
  }
  return text;
}

Bytes odometry_csv(int count) {
  return with_lines(
      "time,.header.seq,.header.stamp.secs,.header.stamp.nsecs,.pose.pose.position.x,.pose.pose.position.y,"
      ".pose.pose.position.z,.pose.pose.orientation.x,.pose.pose.orientation.y,.pose.pose.orientation.z,"
      ".pose.pose.orientation.w\n",
      count, [](int i) {
        return std::to_string(i) + "," + std::to_string(i) + ",1636512535," + std::to_string(560000000 + i * 10000000) +
               "," + std::to_string(i) + ",0,0,0,0,0,1\n";
      });
}

Bytes inspvax_csv(int count) {
  return with_lines(
      "time,.header.gps_week,.header.gps_week_seconds,.ins_status,.latitude,.longitude,.altitude,.undulation,.roll,"
      ".pitch,.azimuth,.latitude_std,.longitude_std,.altitude_std,.roll_std,.pitch_std,.azimuth_std\n",
      count, [](int i) {
        return std::to_string(1636512535000000000 + i * 20000000LL) + ",2183," + std::to_string(269353560 + 20 * i) +
               ",3,51.1,-114.0,1063.6,-16.9,0.5,0.25," + std::to_string(90 + i) + ",0.1,0.1,0.1,0.01,0.01,0.02\n";
      });
}

Bytes apollo_odometry(int count) {
  return with_lines("timestamp,position_type,qw,qx,qy,qz,x,y,z\n", count, [](int i) {
    return std::to_string(1600000000 + i) + ",56,1,0,0,0," + std::to_string(586000 + i) + ",4405000,31\n";
  });
}

/// "122640.50" and "12:26:40.50" for ten a second.
std::string clock_text(int i, const char* between) {
  char text[64];
  std::snprintf(text, sizeof text, "%02d%s%02d%s%02d.%d0", 12 + i / 36000, between, i / 600 % 60, between, i / 10 % 60,
                i % 10);
  return text;
}

Bytes nmea(int count) {
  return with_lines("$GPRMC,120000.00,A,,,,,,,130920,,,A\n", count, [](int i) {
    const std::string time = clock_text(i, "");
    return "$GPGGA," + time + ",4846.10,N,00911.50,E,4,12,0.8,250.0,M,48.0,M,,\n$PASHR," + time +
           ",350.0,T,+02.00,-01.00,+0.00,0.10,0.11,0.20,2,1\n";
  });
}

Bytes nmea_headings(int count) {
  return with_lines("$GPRMC,120000.00,A,,,,,,,130920,,,A\n", count, [](int i) {
    return "$GPGGA," + clock_text(i, "") + ",4846.100000,N,00911.500000,E,4,12,0.8,250.000,M,48.000,M,,\n$GPHDT," +
           std::to_string(i * i / 100 % 360) + ".500,T\n";
  });
}

Bytes nmea_short(int count) {
  return with_lines("$GPRMC,120000,A,,,,,,,130920,,,A\n", count, [](int i) {
    return "$GPGGA," + clock_text(i, "").substr(0, 8) +
           ",4846.1000,N,00911.5000,E,4,9,1.0,250.0,M,48.0,M,,\n$GPHDT,350.0,T\n";
  });
}

Bytes gpx(int count) {
  const auto point = [](int i) {
    return "<trkpt lat=\"48.5\" lon=\"9.25\"><ele>310</ele><time>2020-09-13T" + clock_text(i, ":") +
           "Z</time></trkpt>\n";
  };
  return with_lines("<gpx version=\"1.1\"><trk><trkseg>\n", count, point) + "</trkseg></trk></gpx>\n";
}

Bytes smartloc(int count) {
  Bytes odometry, truth;
  for (int i = 0; i < count; ++i) {
    const Bytes time = std::to_string(0.2 * i);
    odometry += "odom3 " + time + " 5.8 0 0 0 0 -0.005 0.0025 0.0009 0.0009 4e-06 4e-06 4e-06\n";
    truth += "point3 " + time + " " + std::to_string(3785108.1 + i) + " 899901.4 5037234.4 0 0 0 0 0 0 0 0 0\n";
  }
  return pack_files({{"a_Input.txt", odometry}, {"a_GT.txt", truth}});
}

// ---- Documents

Bytes inspvax_log(int count) {
  return with_lines("", count, [](int i) { return inspvaxa(2183, 100.0 + 0.02 * i, 90.0 + i); });
}

Bytes inspva_log(int count) {
  Bytes text;
  for (int i = 0; i < count; ++i) {
    const double time = 100.0 + 0.02 * i;
    text += novatel::inspva(i % 3 == 0 ? "INSPVAA" : "INSPVASA", time, 90.0 + i % 200);
    if (i % 6 == 0) text += novatel::insstdev("INSSTDEVA", time) + novatel::bestpos("BESTPOSA", time);
  }
  return text;
}

Bytes novatel_binary(int count) {
  Bytes bytes = "[COM1]<OK\r\n";
  for (int i = 0; i < count; ++i) {
    const double time = 100.0 + 0.02 * i;
    const novatel::Body body = novatel::inspva_body(time, 90.0 + i % 200);
    bytes += i % 6 == 5 ? novatel::long_log(507, time, body) : novatel::short_log(508, time, body);
    if (i % 6 > 0) continue;
    bytes +=
        novatel::long_log(2051, time, novatel::insstdev_body()) + novatel::long_log(42, time, novatel::bestpos_body());
    bytes += novatel::long_log(1465, time, novatel::inspvax_body(90.0 + i % 200)) +
             novatel::short_log(1462, time, novatel::rawimux_body(time));
  }
  return bytes;
}

Bytes sbet(int count) {
  Bytes bytes;
  for (int i = 0; i < count; ++i) {
    const double t = 0.1 * i, yaw = 1.5 * std::sin(0.31 * t) + 0.8 * std::sin(0.83 * t + 1.0);
    for (const double value : {44'818.0 + t, 0.9, 0.16 + 1e-8 * i, 310.0, 0.1, 0.0, 0.0, 0.02, -0.01, 0.25 - yaw, 0.25,
                               0.0, 0.0, 9.8, 0.0, 0.0, 0.0})
      append(bytes, value);
  }
  return bytes;
}

Bytes smrmsg(int count) {
  Bytes bytes;
  for (int i = 0; i < count; ++i)
    for (const double value : {44'818.0 + 0.1 * i, 0.01, 0.02, 0.03, 0.001, 0.001, 0.001, 0.5, 0.5, 1.5})
      append(bytes, value);
  return bytes;
}

Bytes ncom(int count) {
  Bytes bytes = "noise";
  for (int i = 0; i < count; ++i) {
    constexpr int kFirst_ms = 58'000, kMinute_ms = 60'000;  // into minute 21400586 of GPS
    const double t = 0.1 * i, yaw = 1.5 * std::sin(0.31 * t) + 0.8 * std::sin(0.83 * t + 1.0);
    const int time_ms = kFirst_ms + 100 * i;
    NcomRecord record{.millisecond = time_ms % kMinute_ms, .heading_rad = -yaw, .pitch_rad = 0.01};
    record.channel = i % 5;
    record.minutes = 21'400'586 + time_ms / kMinute_ms;
    bytes += record.bytes();
  }
  return bytes;
}

Bytes sbf_log(int count) {
  Bytes bytes = "$@noise";
  for (int i = 0; i < count; ++i) {
    const double t = 0.1 * i, yaw = 1.5 * std::sin(0.31 * t) + 0.8 * std::sin(0.83 * t + 1.0), time = 44'818.0 + t;
    sbf::InsRecord record{.seconds = time, .angles = {static_cast<float>(-57.3 * yaw), 0.5F, -0.25F}};
    record.place[1] += 1e-8 * i;
    bytes += record.bytes();
    if (i % 10 == 0) {
      record.cartesian = record.with_covariance = true;
      record.place[0] = 3.9e6, record.place[1] = 6.3e5, record.place[2] = 4.97e6;
      bytes += record.bytes() + sbf::att_euler(time, 90.0F, 5.0F, sbf::kDoNotUse) + sbf::att_cov_euler(time) +
               sbf::pvt_geodetic(time) + sbf::pos_cov_geodetic(time);
    }
  }
  return bytes;
}

Bytes explorer_table(int count) {
  Bytes text =
      "Project:     drive\nProgram:     Inertial Explorer Version 8.90.6611\n\n"
      "   Week      GPSTime        Latitude       Longitude        H-Ell Q     Heading       Pitch        Roll   "
      "SDNorth"
      "    HdngSD\n"
      "(weeks)        (sec)     (+/-D M S)      (+/-D M S)          (m)         (deg)       (deg)       (deg)       (m)"
      "     (deg)\n";
  for (int i = 0; i < count; ++i) {
    const double t = 0.1 * i, yaw_deg = 57.3 * (1.5 * std::sin(0.31 * t) + 0.8 * std::sin(0.83 * t + 1.0));
    char line[256];
    std::snprintf(line, sizeof line, "2123 %.3f 51 33 %.5f 9 10 12.5 310.25 1 %.6f 0.5 -0.25 0.01 0.05\n", 44'818.0 + t,
                  10.0 + 0.001 * i, std::fmod(360.0 - yaw_deg, 360.0));
    text += line;
  }
  return text;
}

Bytes oxts_csv(int count) {
  return with_lines(
      "Date (UTC),Time (UTC),PosLat (deg),PosLon (deg),PosAlt (m),AngleHeading (deg),AnglePitch (deg),AngleRoll (deg),"
      "PosLatStdev (m),PosLonStdev (m),PosAltStdev (m)\n",
      count, [](int i) {
        return "2020-09-13,12:26:4" + std::to_string(i / 10 % 10) + "." + std::to_string(i % 10) +
               "00,51.5,9.2,310.25," + std::to_string(10 + i) + ",0.5,-0.25,0.01,0.01,0.02\n";
      });
}

Bytes rtklib(int count) {
  return with_lines(
      "% program   : RTKLIB ver.2.4.3\n%\n"
      "% (lat/lon/height=WGS84/ellipsoidal,Q=1:fix,2:float,3:sbas,4:dgps,5:single,6:ppp,ns=# of satellites)\n"
      "%  GPST                  latitude(deg) longitude(deg)  height(m)   Q  ns   sdn(m)   sde(m)   sdu(m)  sdne(m)  "
      "sdeu(m)  sdun(m) age(s)  ratio\n",
      count, [](int i) {
        return "2020/09/13 12:26:5" + std::to_string(8 + i / 10 % 2) + "." + std::to_string(i % 10) +
               "00   48.12345678" + std::to_string(i % 10) +
               "    9.250000000   310.2500   1  12   0.0100   0.0100   0.0200   0.0010  -0.0010   0.0010   0.00"
               "   9.9\n";
      });
}

Bytes motion_pairs(int count) {
  Bytes text = "# pairs\nset,i,j";
  for (const char letter : {'P', 'Q'})
    for (int i = 0; i < 12; ++i) text += std::string(",") + letter + std::to_string(i / 4) + std::to_string(i % 4);
  for (int k = 0; k < count; ++k) {
    text += "\ns," + std::to_string(k) + "," + std::to_string(k + 1);
    for (int matrix = 0; matrix < 2; ++matrix)
      for (int i = 0; i < 12; ++i) text += i % 5 == 0 ? ",1" : ",0";
  }
  return text + "\n";
}

results::ResultFile result() {
  results::ResultFile file;
  file.result.status = calibration::Status::Ok;
  file.result.set_observed(calibration::ParameterSet::all(), {});
  file.result.covariance = Matrix6d::Identity() * 1e-6;
  file.result.mounting.reference_from_sensor = rigid_from_six({0.9, -0.25, 0.75, 2.0, -0.02, 0.015});
  file.ins_axes = drive::InsAxes::ForwardLeftUp;
  return file;
}

/// A project with a calibration in it.
results::VehicleFile vehicle() {
  results::VehicleFile both;
  both.lidars = {{"front", true, result()}, {"rear", false, result()}};
  results::RelativeRecord two;
  two.lidar_a = "front", two.lidar_b = "rear";
  two.sigma[calibration::Parameter::X] = 0.002;
  both.relatives = {two};
  both.agreements = {{"front", "rear", Vector6d::Constant(0.01), Vector6d::Constant(0.005), 2.0}};
  both.groups = {{"front", "rear"}};
  return both;
}

Bytes project() {
  const TemporaryFolder folder;
  project::Project project;
  project.sessions = {folder.path() / "one"};
  project.nominal_ins_from_lidar = RigidTransform::Identity();
  project.verdicts.push_back({motion::SessionIndex{}, 1, 2, motion::PairState::Rejected, Message::verbatim("by hand")});
  pipeline::PipelineOutput output;
  for (int i = 0; i < 4; ++i)
    output.keyframes.push_back({motion::SessionIndex{}, index_at<motion::ScanIndex>(i),
                                1'600'000'000'000'000'000 + i * 100'000'000LL, 1.0 * i});
  for (int i = 0; i < 3; ++i) {
    motion::Pair pair;
    pair.keyframe_a = index_at<motion::KeyframeIndex>(i);
    pair.keyframe_b = index_at<motion::KeyframeIndex>(i + 1);
    output.pairs.push_back(pair);
  }
  output.result = result().result;
  project.output = output;
  project.basis.session_count = 1;
  project::save_project(project, folder.path() / "p.remount");
  return bytes_of(folder.path() / "p.remount");
}

}  // namespace remount::formats::samples
