// Layouts that differ in names, order, units, conventions, separators and clocks.
#pragma once

#include <string>
#include <vector>

#include "tests/model/guesses/written_tables.h"

namespace remount::guesses {

inline std::vector<std::string> angles(const drive::AttitudeAngles& a, double yaw_sign = 1.0) {
  return {degrees_text(a.roll_rad), degrees_text(a.pitch_rad), degrees_text(yaw_sign * a.yaw_rad)};
}

inline std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

inline std::vector<std::string> place_deg(const WrittenSample& s) {
  return {degrees_text(s.ins.latitude_rad), degrees_text(s.ins.longitude_rad), number(s.ins.height_m)};
}

inline std::vector<std::string> place_m(const WrittenSample& s) {
  const Eigen::Vector3d p = s.world_from_ins.translation();
  return {number(p.x()), number(p.y()), number(p.z())};
}

inline std::vector<std::string> wxyz(const Eigen::Quaterniond& q) {
  return {number(q.w()), number(q.x()), number(q.y()), number(q.z())};
}

/// North, east, down from forward, right, down.
inline Eigen::Quaterniond ned_from_frd(const Eigen::Quaterniond& enu_from_flu) {
  Eigen::Matrix3d ned_from_enu;
  ned_from_enu << 0, 1, 0, 1, 0, 0, 0, 0, -1;
  const Eigen::Matrix3d flu_from_frd = Eigen::Vector3d(1, -1, -1).asDiagonal();
  return Eigen::Quaterniond(ned_from_enu * enu_from_flu.toRotationMatrix() * flu_from_frd);
}

/// Layouts that differ in names, order, units, conventions, separators and clocks.
inline std::vector<WrittenLayout> layouts() {
  std::vector<WrittenLayout> all;
  all.push_back(
      {"a maker's CSV with GPS week",
       "GPS Week,TOW(s),Latitude(deg),Longitude(deg),Height(m),Roll(deg),Pitch(deg),Heading(deg),Course(deg)\n", ",",
       false, [](const WrittenSample& s) {
         const std::int64_t gps_ns = formats::gps_ns_from_unix_ns(s.ins.stamp_ns);
         constexpr std::int64_t kWeek_ns = 604'800'000'000'000;
         return joined(joined({std::to_string(gps_ns / kWeek_ns), seconds_text(gps_ns % kWeek_ns)}, place_deg(s)),
                       joined(angles(heading_angles(s)), {"12.5"}));
       }});
  all.push_back({"Chinese names, commas of decimals",
                 "项目：测试\n时间(毫秒);航向角(度);俯仰角(度);横滚角(度);纬度(度);经度(度);高程(米)\n", ";", true,
                 [](const WrittenSample& s) {
                   const drive::AttitudeAngles a = heading_angles(s);
                   return joined({std::to_string(s.ins.stamp_ns / 1'000'000), degrees_text(a.yaw_rad),
                                  degrees_text(a.pitch_rad), degrees_text(a.roll_rad)},
                                 place_deg(s));
                 }});
  all.push_back({"tabs, radians, yaw from east", "lon_rad\tlat_rad\talt\troll\tpitch\tyaw\tstamp_us\tvel_x\n", "\t",
                 false, [](const WrittenSample& s) {
                   const drive::AttitudeAngles a = yaw_angles(s);
                   return std::vector<std::string>{number(s.ins.longitude_rad),
                                                   number(s.ins.latitude_rad),
                                                   number(s.ins.height_m),
                                                   number(a.roll_rad),
                                                   number(a.pitch_rad),
                                                   number(a.yaw_rad),
                                                   std::to_string(s.ins.stamp_ns / 1000),
                                                   "1.5"};
                 }});
  all.push_back({"poses between blanks, w first", "# trajectory of the INS\n# t x y z qw qx qy qz\n", " ", false,
                 [](const WrittenSample& s) {
                   return joined(joined({seconds_text(s.ins.stamp_ns)}, place_m(s)),
                                 wxyz(Eigen::Quaterniond(s.world_from_ins.linear())));
                 }});
  all.push_back({"numbers alone", "", " ", false, [](const WrittenSample& s) {
                   return joined(joined({seconds_text(s.ins.stamp_ns)}, place_deg(s)), angles(heading_angles(s)));
                 }});
  all.push_back({"dates, quaternion of north-east-down", "utc time,lat,lon,alt,q.x,q.y,q.z,q.w\n", ",", false,
                 [](const WrittenSample& s) {
                   const std::vector<std::string> q = wxyz(ned_from_frd(s.ins.enu_from_ins));
                   std::string date = formats::format_date_ns(s.ins.stamp_ns) + "Z";
                   date[10] = 'T';
                   return joined(joined({date}, place_deg(s)), {q[1], q[2], q[3], q[0]});
                 }});
  all.push_back(
      {"yaw from north to the left, nose up", "time[s]|latitude|longitude|altitude|yaw[deg]|pitch[deg]|roll[deg]\n",
       "|", false, [](const WrittenSample& s) {
         const drive::AttitudeAngles a = heading_angles(s);
         return joined(joined({seconds_text(s.ins.stamp_ns)}, place_deg(s)),
                       {degrees_text(wrap_angle_rad(-a.yaw_rad)), degrees_text(a.pitch_rad), degrees_text(a.roll_rad)});
       }});
  all.push_back({"a message as columns",
                 "field.header.seq,field.header.stamp.secs,field.header.stamp.nsecs,field.pose.pose.position.x,field."
                 "pose.pose.position.y,field.pose.pose.position.z,field.pose.pose.orientation.x,field.pose.pose."
                 "orientation.y,field.pose.pose.orientation.z,field.pose.pose.orientation.w\n",
                 ",", false, [](const WrittenSample& s) {
                   const std::vector<std::string> q = wxyz(Eigen::Quaterniond(s.world_from_ins.linear()));
                   return joined(joined({"7", std::to_string(s.ins.stamp_ns / 1'000'000'000),
                                         std::to_string(s.ins.stamp_ns % 1'000'000'000)},
                                        place_m(s)),
                                 {q[1], q[2], q[3], q[0]});
                 }});
  all.push_back({"north, east, down", "Time(ns),North(m),East(m),Down(m),Heading(deg),Pitch(deg),Roll(deg)\n", ",",
                 false, [](const WrittenSample& s) {
                   const std::vector<std::string> p = place_m(s);
                   WrittenSample turned = s;
                   turned.ins.enu_from_ins = Eigen::Quaterniond(s.world_from_ins.linear());
                   const drive::AttitudeAngles a = heading_angles(turned);
                   return std::vector<std::string>{std::to_string(s.ins.stamp_ns),
                                                   p[1],
                                                   p[0],
                                                   number(-s.world_from_ins.translation().z()),
                                                   degrees_text(a.yaw_rad),
                                                   degrees_text(a.pitch_rad),
                                                   degrees_text(a.roll_rad)};
                 }});
  all.push_back({"yaw from east, nose up, two times", "host_time,timestamp (s),lat,lng,height,yaw,pitch,roll\n", ",",
                 false, [](const WrittenSample& s) {
                   const drive::AttitudeAngles a = yaw_angles(s);
                   return joined(
                       joined({seconds_text(s.ins.stamp_ns + 37'000'000), seconds_text(s.ins.stamp_ns)}, place_deg(s)),
                       {degrees_text(a.yaw_rad), degrees_text(-a.pitch_rad), degrees_text(a.roll_rad)});
                 }});
  return all;
}

}  // namespace remount::guesses
