// Blocks of SBF for tests and samples, byte by byte.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace remount::formats::sbf {

constexpr float kDoNotUse = -2e10F;

template <class T>
void put(std::string& bytes, T value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

/// Bit by bit, as it is defined.
inline std::uint16_t crc(const std::string& bytes) {
  unsigned crc = 0;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned>(static_cast<unsigned char>(byte)) << 8U;
    for (int i = 0; i < 8; ++i) crc = ((crc & 0x8000U) != 0 ? crc << 1U ^ 0x1021U : crc << 1U) & 0xFFFFU;
  }
  return static_cast<std::uint16_t>(crc);
}

constexpr int kSbfWeek = 2123;

/// @param body behind the time; filled up to a multiple of four
inline std::string block(int id, double seconds, const std::string& body, int revision = 0) {
  std::string numbered;
  const std::size_t bytes = (14 + body.size() + 3) / 4 * 4;
  put(numbered, static_cast<std::uint16_t>(id | revision << 13));
  put(numbered, static_cast<std::uint16_t>(bytes));
  put(numbered, static_cast<std::uint32_t>(seconds * 1000.0 + 0.5));
  put(numbered, static_cast<std::uint16_t>(kSbfWeek));
  numbered += body;
  numbered.resize(bytes - 4);
  std::string block = "$@";
  put(block, crc(numbered));
  return block + numbered;
}

/// INSNavGeod, or with `cartesian` INSNavCart.
struct InsRecord {
  double seconds = 44'818.0;
  int mode = 4, error = 0;
  double place[3] = {0.9, 0.16, 310.0};
  bool cartesian = false;
  bool with_covariance = false;
  float covariances[3] = {0.0F, 0.0F, 0.0F};         ///< INSNavCart: x y, x z, y z
  std::vector<float> sigma = {0.01F, 0.02F, 0.03F};  ///< empty: the sub-block is not there
  std::vector<float> angles = {0.0F, 0.0F, 0.0F};    ///< heading, pitch, roll
  std::vector<float> angle_sigma = {0.3F, 0.2F, 0.1F};
  int id = 0;  ///< 0: its own

  std::string bytes() const {
    std::string body;
    put(body, static_cast<std::uint8_t>(mode));
    put(body, static_cast<std::uint8_t>(error));
    put<std::uint16_t>(body, 0), put<std::uint16_t>(body, 0);
    for (const double value : place) put(body, value);
    if (!cartesian) put(body, 47.5F);
    put<std::uint16_t>(body, 1), put<std::uint16_t>(body, 1), put<std::uint16_t>(body, 0);
    const unsigned list = (sigma.empty() ? 0U : 1U) | (angles.empty() ? 0U : 2U) | (angle_sigma.empty() ? 0U : 4U) |
                          8U | (with_covariance ? 32U : 0U);
    put(body, static_cast<std::uint16_t>(list));
    for (const std::vector<float>* values : {&sigma, &angles, &angle_sigma})
      for (const float value : *values) put(body, value);
    for (const float speed : {1.0F, 2.0F, 3.0F}) put(body, speed);
    if (with_covariance)
      for (const float covariance : covariances) put(body, covariance);
    return block(id != 0 ? id : cartesian ? 4225 : 4226, seconds, body);
  }
};

inline std::string pvt_geodetic(double seconds, int mode = 4, double latitude_rad = 0.9) {
  std::string body;
  put(body, static_cast<std::uint8_t>(mode)), put<std::uint8_t>(body, 0);
  for (const double value : {latitude_rad, 0.16, 310.0}) put(body, value);
  for (int i = 0; i < 5; ++i) put(body, kDoNotUse);  // undulation, velocity, course
  put(body, -2e10), put(body, kDoNotUse);            // clock
  body.resize(body.size() + 16);                     // 72 to 88
  put<std::uint16_t>(body, 10);                      // latency
  put<std::uint16_t>(body, 40), put<std::uint16_t>(body, 60), put<std::uint8_t>(body, 0);
  return block(4007, seconds, body, 2);
}

inline std::string pos_cov_geodetic(double seconds) {
  std::string body;
  put<std::uint16_t>(body, 4);
  for (const float value : {1e-4F, 4e-4F, 9e-4F, 1.0F, 1e-5F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F}) put(body, value);
  return block(5906, seconds, body);
}

/// @param mode 1, 3: by float ambiguities; 1, 2: without roll
inline std::string att_euler(double seconds, float heading_deg, float pitch_deg, float roll_deg,
                             std::uint16_t mode = 4) {
  std::string body;
  put<std::uint16_t>(body, 12), put(body, mode), put<std::uint16_t>(body, 0);
  for (const float value : {heading_deg, pitch_deg, roll_deg, kDoNotUse, kDoNotUse, kDoNotUse}) put(body, value);
  return block(5938, seconds, body);
}

inline std::string att_cov_euler(double seconds) {
  std::string body;
  put<std::uint16_t>(body, 0);
  for (const float value : {0.09F, 0.04F, 0.01F, 0.0F, 0.0F, 0.0F}) put(body, value);
  return block(5939, seconds, body);
}

}  // namespace remount::formats::sbf
