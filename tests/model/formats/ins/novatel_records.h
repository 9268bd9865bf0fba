// NovAtel's logs for tests, byte by byte as the manual has them.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>

#include "model/formats/ins/novatel_frames.h"

namespace remount::formats::novatel {

constexpr int kWeek = 2183;

inline std::string with_crc(char begin, const std::string& body) {
  char crc[16];
  std::snprintf(crc, sizeof crc, "*%08x\r\n", novatel_crc32(body));
  return begin + body + crc;
}

inline std::string ascii_header(const std::string& name, double seconds) {
  char header[120];
  const bool is_short = name == "INSPVASA" || name == "INSSTDEVSA";
  std::snprintf(header, sizeof header,
                is_short ? "%s,%d,%.3f;" : "%s,COM1,0,73.5,FINESTEERING,%d,%.3f,00000040,4e77,43562;", name.c_str(),
                kWeek, seconds);
  return header;
}

/// @param name "INSPVAA" or "INSPVASA", which has a short header
inline std::string inspva(const std::string& name, double seconds, double azimuth_deg,
                          const std::string& status = "INS_SOLUTION_GOOD") {
  char body[400];
  std::snprintf(body, sizeof body, "%d,%.9f,51.11637873403,-114.03825114994,1046.7093,0.1,0.2,0.3,1.5,-2.5,%.6f,%s",
                kWeek, seconds, azimuth_deg, status.c_str());
  return with_crc(name == "INSPVASA" ? '%' : '#', ascii_header(name, seconds) + body);
}

/// @param name "INSSTDEVA" or "INSSTDEVSA"
inline std::string insstdev(const std::string& name, double seconds, double latitude_m = 0.8) {
  char body[200];
  std::snprintf(body, sizeof body, "%.4f,0.9,1.2,0.01,0.02,0.03,0.5,0.6,0.7,13000045,0,0,7fd1bf,0", latitude_m);
  return with_crc(name == "INSSTDEVSA" ? '%' : '#', ascii_header(name, seconds) + body);
}

inline std::string bestpos(const std::string& name, double seconds, const std::string& status = "SOL_COMPUTED") {
  const std::string type = status == "SOL_COMPUTED" ? "NARROW_INT" : "NONE";
  return with_crc('#', ascii_header(name, seconds) + status + "," + type +
                           ",51.11637873403,-114.03825114994,1063.6093,-16.9000,WGS84,0.8,0.9,1.2,\"\",0.000,0.000,7,7,"
                           "0,0,0,06,0,03");
}

/// A body of numbers, little-endian.
class Body {
 public:
  template <class T>
  Body& add(T value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes_.append(raw, sizeof value);
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// @param message_type its lowest five bits are the antenna, its highest says that it is an answer
inline std::string long_log(std::uint16_t id, double seconds, const Body& body, std::uint8_t message_type = 0) {
  Body log;
  log.add<std::uint8_t>(0xAA).add<std::uint8_t>(0x44).add<std::uint8_t>(0x12).add<std::uint8_t>(28).add(id);
  log.add(message_type).add<std::uint8_t>(32).add(static_cast<std::uint16_t>(body.bytes().size()));
  log.add<std::uint16_t>(0).add<std::uint8_t>(147).add<std::uint8_t>(180).add<std::uint16_t>(kWeek);
  log.add(static_cast<std::uint32_t>(seconds * 1000.0 + 0.5)).add<std::uint32_t>(0x40).add<std::uint16_t>(0x4e77);
  log.add<std::uint16_t>(43562);
  const std::string bytes = log.bytes() + body.bytes();
  return bytes + Body().add(novatel_crc32(bytes)).bytes();
}

inline std::string short_log(std::uint16_t id, double seconds, const Body& body) {
  Body log;
  log.add<std::uint8_t>(0xAA).add<std::uint8_t>(0x44).add<std::uint8_t>(0x13);
  log.add(static_cast<std::uint8_t>(body.bytes().size())).add(id).add<std::uint16_t>(kWeek);
  log.add(static_cast<std::uint32_t>(seconds * 1000.0 + 0.5));
  const std::string bytes = log.bytes() + body.bytes();
  return bytes + Body().add(novatel_crc32(bytes)).bytes();
}

/// Of INSPVA, 88 bytes.
inline Body inspva_body(double seconds, double azimuth_deg, std::uint32_t status = 3) {
  Body body;
  body.add<std::uint32_t>(kWeek).add(seconds);
  for (const double value : {51.11637873403, -114.03825114994, 1046.7093, 0.1, 0.2, 0.3, 1.5, -2.5, azimuth_deg})
    body.add(value);
  return body.add(status);
}

inline void add_errors(Body& body) {
  for (const float sigma : {0.8F, 0.9F, 1.2F, 0.01F, 0.02F, 0.03F, 0.5F, 0.6F, 0.7F}) body.add(sigma);
}

/// Of INSPVAX, 126 bytes.
inline Body inspvax_body(double azimuth_deg, std::uint32_t status = 3) {
  Body body;
  body.add(status).add<std::uint32_t>(56);
  for (const double value : {51.11637873403, -114.03825114994, 1063.6093}) body.add(value);
  body.add(-16.9F);
  for (const double value : {0.1, 0.2, 0.3, 1.5, -2.5, azimuth_deg}) body.add(value);
  add_errors(body);
  return body.add<std::uint32_t>(0).add<std::uint16_t>(0);
}

/// Of INSSTDEV, 52 bytes.
inline Body insstdev_body() {
  Body body;
  add_errors(body);
  for (int i = 0; i < 4; ++i) body.add<std::uint32_t>(0);
  return body;
}

/// Of BESTPOS, 72 bytes.
inline Body bestpos_body(std::uint32_t status = 0) {
  Body body;
  body.add(status).add<std::uint32_t>(status == 0 ? 50 : 0);
  for (const double value : {51.11637873403, -114.03825114994, 1063.6093}) body.add(value);
  body.add(-16.9F).add<std::uint32_t>(61);
  for (const float value : {0.8F, 0.9F, 1.2F, 0.0F, 0.0F, 0.0F}) body.add(value);  // errors, station, ages
  return body.add<std::uint64_t>(0);
}

/// Counts of an Epson G320 that stands, as the manual has them: along z, -y, x, then about these.
inline constexpr std::array<int, 6> kStandingCounts{329'308'016, -2'706'935, 4'508'389, 196'192, 417'138, -1'000'837};

/// Of RAWIMUX and RAWIMUSX, 40 bytes.
inline Body rawimux_body(double seconds, int type = 41, const std::array<int, 6>& counts = kStandingCounts,
                         int info = 4) {
  Body body;
  body.add(static_cast<std::uint8_t>(info)).add(static_cast<std::uint8_t>(type)).add<std::uint16_t>(kWeek);
  body.add(seconds).add<std::uint32_t>(0);
  for (const int count : counts) body.add<std::int32_t>(count);
  return body;
}

/// Of RAWIMU and RAWIMUS, 40 bytes.
inline Body rawimu_body(double seconds) {
  Body body;
  body.add<std::uint32_t>(kWeek).add(seconds).add<std::uint32_t>(0);
  for (const int count : kStandingCounts) body.add<std::int32_t>(count);
  return body;
}

/// @param name "RAWIMUA", "RAWIMUSA", "RAWIMUXA" or "RAWIMUSXA"
inline std::string rawimu(const std::string& name, double seconds) {
  const bool is_short = name.starts_with("RAWIMUS");
  char time[64];
  std::snprintf(time, sizeof time, "%d,%.6f,ea59fe00", kWeek, seconds);
  std::string body = (name.ends_with("XA") ? "04,41," : "") + std::string(time);
  for (const int count : kStandingCounts) body += "," + std::to_string(count);
  char header[120];
  std::snprintf(header, sizeof header,
                is_short ? "%s,%d,%.3f;" : "%s,USB1,0,64.5,FINESTEERING,%d,%.3f,02000020,0dc5,16809;", name.c_str(),
                kWeek, seconds);
  return with_crc(is_short ? '%' : '#', header + body);
}

}  // namespace remount::formats::novatel
