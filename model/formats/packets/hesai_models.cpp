#include "model/formats/packets/hesai_models.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "model/formats/packets/hesai_firing_times.h"

namespace remount::formats {

namespace {

/// Of the Pandar40 and 40P, by channel; azimuths are those of their four columns of lasers.
constexpr double kElevations40_deg[] = {15,   11,    8,     5,     3,     2,     1.67,  1.33,  1,     0.67,
                                        0.33, 0,     -0.33, -0.67, -1,    -1.33, -1.66, -2,    -2.33, -2.67,
                                        -3,   -3.33, -3.67, -4,    -4.33, -4.67, -5,    -5.33, -5.67, -6,
                                        -7,   -8,    -9,    -10,   -11,   -12,   -13,   -14,   -19,   -25};
constexpr double kAzimuths40_deg[] = {-1.042, -1.042, -1.042, -1.042, -1.042, -1.042, 3.125,  -5.208, -1.042, 3.125,
                                      -5.208, -1.042, 3.125,  -5.208, -1.042, 3.125,  -5.208, -1.042, 3.125,  -5.208,
                                      -1.042, 3.125,  -5.208, -1.042, 3.125,  -5.208, -1.042, 3.125,  -5.208, -1.042,
                                      -1.042, -1.042, -1.042, -1.042, -1.042, -1.042, -1.042, -1.042, -1.042, -1.042};
constexpr double kTimes40_us[] = {-42.22, -28.47, -16.04, -3.62,  -45.49, -31.74, -47.46, -54.67, -20.62, -33.71,
                                  -40.91, -8.19,  -20.62, -27.16, -50.73, -8.19,  -14.74, -36.98, -45.49, -52.7,
                                  -23.89, -31.74, -38.95, -11.47, -18.65, -25.19, -48.76, -6.23,  -12.77, -35.01,
                                  -21.92, -9.5,   -43.52, -29.77, -17.35, -4.92,  -42.22, -28.47, -16.04, -3.62};

/// Of the Pandar64.
constexpr double kElevations64_deg[] = {
    14.882, 11.032, 8.059,  5.057,  3.04,   2.028,  1.86,    1.688,   1.522,   1.351,  1.184,   1.013,  0.846,
    0.675,  0.508,  0.337,  0.169,  0,      -0.169, -0.337,  -0.508,  -0.675,  -0.845, -1.013,  -1.184, -1.351,
    -1.522, -1.688, -1.86,  -2.028, -2.198, -2.365, -2.536,  -2.7,    -2.873,  -3.04,  -3.21,   -3.375, -3.548,
    -3.712, -3.884, -4.05,  -4.221, -4.385, -4.558, -4.72,   -4.892,  -5.057,  -5.229, -5.391,  -5.565, -5.726,
    -5.898, -6.061, -7.063, -8.059, -9.06,  -9.885, -11.032, -12.006, -12.974, -13.93, -18.889, -24.897};
constexpr double kAzimuths64_deg[] = {
    -1.042, -1.042, -1.042, -1.042, -1.042, -1.042, 1.042,  3.125,  5.208,  -5.208, -3.125, -1.042, 1.042,
    3.125,  5.208,  -5.208, -3.125, -1.042, 1.042,  3.125,  5.208,  -5.208, -3.125, -1.042, 1.042,  3.125,
    5.208,  -5.208, -3.125, -1.042, 1.042,  3.125,  5.208,  -5.208, -3.125, -1.042, 1.042,  3.125,  5.208,
    -5.208, -3.125, -1.042, 1.042,  3.125,  5.208,  -5.208, -3.125, -1.042, 1.042,  3.125,  5.208,  -5.208,
    -3.125, -1.042, -1.042, -1.042, -1.042, -1.042, -1.042, -1.042, -1.042, -1.042, -1.042, -1.042};
constexpr double kTimes64_us[] = {
    -23.18,  -21.876, -20.572, -19.268, -17.964, -16.66,  -11.444, -46.796, -7.532,  -36.956, -50.732, -54.668, -40.892,
    -44.828, -31.052, -34.988, -48.764, -52.7,   -38.924, -42.86,  -29.084, -33.02,  -46.796, -25.148, -36.956, -50.732,
    -27.116, -40.892, -44.828, -31.052, -34.988, -48.764, -25.148, -38.924, -42.86,  -29.084, -33.02,  -52.7,   -6.228,
    -54.668, -15.356, -27.116, -10.14,  -23.18,  -4.924,  -21.876, -14.052, -17.964, -8.836,  -19.268, -3.62,   -20.572,
    -12.748, -16.66,  -7.532,  -11.444, -6.228,  -15.356, -10.14,  -4.924,  -3.62,   -14.052, -8.836,  -12.748};

/// Of the PandarQT.
constexpr double kElevationsQt_deg[] = {
    -52.121, -49.785, -47.577, -45.477, -43.465, -41.528, -39.653, -37.831, -36.055, -34.32, -32.619, -30.95,  -29.308,
    -27.69,  -26.094, -24.517, -22.964, -21.42,  -19.889, -18.372, -16.865, -15.368, -13.88, -12.399, -10.925, -9.457,
    -7.994,  -6.535,  -5.079,  -3.626,  -2.175,  -0.725,  0.725,   2.175,   3.626,   5.079,  6.534,   7.993,   9.456,
    10.923,  12.397,  13.877,  15.365,  16.861,  18.368,  19.885,  21.415,  22.959,  24.524, 26.101,  27.697,  29.315,
    30.957,  32.627,  34.328,  36.064,  37.84,   39.662,  41.537,  43.475,  45.487,  47.587, 49.795,  52.133};
constexpr double kAzimuthsQt_deg[] = {
    8.736,  8.314, 7.964,  7.669,  7.417,  7.198,  7.007,  6.838,  6.688,  6.554,  6.434,  6.326,  6.228,
    6.14,   6.059, 5.987,  -5.27,  -5.216, -5.167, -5.123, -5.083, -5.047, -5.016, -4.988, -4.963, -4.942,
    -4.924, -4.91, -4.898, -4.889, -4.884, -4.881, 5.493,  5.496,  5.502,  5.512,  5.525,  5.541,  5.561,
    5.584,  5.611, 5.642,  5.676,  5.716,  5.759,  5.808,  5.862,  5.921,  -5.33,  -5.396, -5.469, -5.55,
    -5.64,  -5.74, -5.85,  -5.974, -6.113, -6.269, -6.447, -6.651, -6.887, -7.163, -7.493, -7.892};
constexpr double kTimesQt_us[] = {
    12.31,  14.37,  16.43,  18.49,  20.54,  22.6,   24.66,  26.71,  29.16,  31.22,  33.28,  35.34,  37.39,
    39.45,  41.5,   43.56,  46.61,  48.67,  50.73,  52.78,  54.84,  56.9,   58.95,  61.01,  63.45,  65.52,
    67.58,  69.63,  71.69,  73.74,  75.8,   77.86,  80.9,   82.97,  85.02,  87.08,  89.14,  91.19,  93.25,
    95.3,   97.75,  99.82,  101.87, 103.93, 105.98, 108.04, 110.1,  112.15, 115.2,  117.26, 119.32, 121.38,
    123.43, 125.49, 127.54, 129.6,  132.05, 134.11, 136.17, 138.22, 140.28, 142.34, 144.39, 146.45};

/// Of the QT128, which has two lasers in the directions of channels 80 to 96.
constexpr double kElevationsQt128_deg[] = {
    -52.627, -51.028, -49.515, -48.074, -46.695, -45.369, -44.09,  -42.852, -41.651, -40.482, -39.343, -38.231, -37.143,
    -36.076, -35.03,  -34.002, -32.992, -31.996, -31.015, -30.048, -29.093, -28.149, -27.216, -26.292, -25.378, -24.473,
    -23.575, -22.685, -21.802, -20.926, -20.056, -19.191, -18.331, -17.477, -16.627, -15.781, -14.94,  -14.102, -13.268,
    -12.436, -11.608, -10.783, -9.96,   -9.139,  -8.32,   -7.503,  -6.688,  -5.874,  -5.061,  -4.25,   -3.439,  -2.63,
    -1.82,   -1.012,  -0.203,  0.606,   1.414,   2.223,   3.033,   3.843,   4.654,   5.466,   6.279,   7.094,   7.91,
    8.728,   9.547,   10.369,  11.194,  12.02,   12.85,   13.683,  14.519,  15.359,  16.202,  17.05,   17.902,  18.759,
    19.621,  20.488,  21.362,  22.241,  23.128,  24.022,  24.923,  25.833,  26.751,  27.679,  28.618,  29.567,  30.528,
    31.502,  32.49,   33.493,  34.512,  35.549,  19.191,  20.056,  20.926,  21.802,  22.685,  23.575,  24.473,  25.378,
    26.292,  27.216,  28.149,  29.093,  30.048,  31.015,  31.996,  32.992,  34.002,  35.03,   36.076,  37.143,  38.231,
    39.343,  40.482,  41.651,  42.852,  44.09,   45.369,  46.695,  48.074,  49.515,  51.028,  52.627};
constexpr double kAzimuthsQt128_deg[] = {
    10.108, 9.72,   9.384,  9.091,  8.833,  8.603,  8.396,  8.209,  8.04,   7.885,  7.743,  7.612,  7.492,
    7.38,   7.277,  7.18,   7.09,   7.006,  6.928,  6.854,  6.785,  6.721,  6.66,   6.602,  6.549,  6.498,
    6.45,   6.405,  6.363,  6.323,  6.285,  6.25,   -6.217, -6.186, -6.157, -6.129, -6.104, -6.08,  -6.057,
    -6.037, -6.018, -6,     -5.984, -5.969, -5.955, -5.943, -5.927, -5.923, -5.915, -5.908, -5.902, -5.897,
    -5.894, -5.892, -5.891, -5.891, -5.893, -5.896, -5.899, -5.905, -5.911, -5.919, -5.927, -5.938, 5.949,
    5.962,  5.976,  5.992,  6.008,  6.027,  6.047,  6.068,  6.091,  6.116,  6.143,  6.171,  6.201,  6.233,
    6.267,  6.304,  6.343,  6.384,  6.427,  6.474,  6.523,  6.575,  6.631,  6.69,   6.752,  6.819,  6.89,
    6.966,  7.047,  7.134,  7.227,  7.327,  -6.25,  -6.285, -6.323, -6.363, -6.405, -6.45,  -6.498, -6.549,
    -6.602, -6.66,  -6.721, -6.785, -6.854, -6.928, -7.006, -7.09,  -7.18,  -7.277, -7.38,  -7.492, -7.612,
    -7.743, -7.885, -8.04,  -8.209, -8.396, -8.603, -8.833, -9.091, -9.384, -9.72,  -10.108};

template <std::size_t count>
std::vector<double> listed(const double (&numbers)[count]) {
  return {std::begin(numbers), std::end(numbers)};
}

std::vector<double> stepped(std::size_t count, double first, double step, std::size_t period) {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i) numbers.push_back(first + step * static_cast<double>(i % period));
  return numbers;
}

/// Of the PandarXT: channels in even steps, one after the other; of the XT-32M2X two at once.
HesaiModel even_model(std::string_view name, std::size_t channels, double highest_deg, double step_deg, double time_us,
                      std::size_t fired_apart) {
  constexpr double kTrigger_us = 5.632, kFirst_us = 0.368, kStep_us = 50.0;
  return {.name = name,
          .channels = channels,
          .elevations_deg = stepped(channels, highest_deg, -step_deg, channels),
          .azimuths_deg = std::vector<double>(channels, 0.0),
          .times_us = {stepped(channels, kFirst_us, time_us, fired_apart)},
          .block_step_us = kStep_us,
          .stamp_step_us = kTrigger_us};
}

}  // namespace

const HesaiModel& pandar40() {
  static const HesaiModel model{.name = "Pandar40P",
                                .channels = 40,
                                .elevations_deg = listed(kElevations40_deg),
                                .azimuths_deg = listed(kAzimuths40_deg),
                                .times_us = {listed(kTimes40_us)},
                                .block_step_us = 55.56,
                                .stamp_step_us = -28.58};
  return model;
}
const HesaiModel& pandar64() {
  static const HesaiModel model{.name = "Pandar64",
                                .channels = 64,
                                .elevations_deg = listed(kElevations64_deg),
                                .azimuths_deg = listed(kAzimuths64_deg),
                                .times_us = {listed(kTimes64_us)},
                                .block_step_us = 55.56,
                                .stamp_step_us = -42.58};
  return model;
}
const HesaiModel& pandar_qt() {
  static const HesaiModel model{.name = "PandarQT",
                                .channels = 64,
                                .elevations_deg = listed(kElevationsQt_deg),
                                .azimuths_deg = listed(kAzimuthsQt_deg),
                                .times_us = {listed(kTimesQt_us)},
                                .block_step_us = 500.0 / 3.0,
                                .stamp_step_us = 25.71,
                                .stamp_of_first = true};
  return model;
}

const HesaiModel& qt128() {
  static const HesaiModel model{.name = "QT128",
                                .channels = 128,
                                .elevations_deg = listed(kElevationsQt128_deg),
                                .azimuths_deg = listed(kAzimuthsQt128_deg),
                                .times_us = qt128_times_us(),
                                .block_step_us = 111.11,
                                .stamp_step_us = 9.0,
                                .stamp_of_first = true};
  return model;
}

const HesaiModel& pandar128() {
  static const HesaiModel model{.name = "Pandar128",
                                .channels = 128,
                                .times_us = pandar128_times_us(),
                                .near_m = 2.85,
                                .block_step_us = 27.778,
                                .stamp_step_us = 3.148};
  return model;
}
const HesaiModel& ot128() {
  static const HesaiModel model{
      .name = "OT128", .channels = 128, .times_us = ot128_times_us(), .block_step_us = 27.778};
  return model;
}
const HesaiModel& at128() {
  static const HesaiModel model{.name = "AT128",
                                .channels = 128,
                                .times_us = {at128_times_us()},
                                .mirrored = true,
                                .block_step_us = 41.666,
                                .stamp_step_us = -50.915};
  return model;
}

const HesaiModel* pandar_xt(std::size_t channels, std::size_t blocks) {
  static const HesaiModel xt32 = even_model("PandarXT-32", 32, 15.0, 1.0, 1.512, 32);
  static const HesaiModel xt16 = even_model("PandarXT-16", 16, 15.0, 2.0, 3.024, 16);
  static const HesaiModel xt32m = even_model("PandarXT-32M2X", 32, 19.5, 1.3, 2.888, 16);
  if (channels == 32) return blocks == 8 ? &xt32 : blocks == 6 ? &xt32m : nullptr;
  return channels == 16 && blocks == 8 ? &xt16 : nullptr;
}

}  // namespace remount::formats
