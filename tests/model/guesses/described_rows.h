// Tables that are written row by row beside the scans of a drive, and what is said of them.
#pragma once

#include <functional>
#include <string_view>

#include "algorithms/messages/render.h"
#include "tests/model/guesses/described_drive.h"

namespace remount::guesses {

using Fields = std::vector<std::string>;

inline constexpr const char* kGeodeticHead = ",lat,lon,h,roll,pitch,heading\n";

inline Fields geodetic(const WrittenSample& sample) {
  return joined(place_deg(sample), angles(heading_angles(sample)));
}

/// Round and round, with a compass heading.
inline std::vector<WrittenSample> circles(std::int64_t first_ns, double duration_s) {
  constexpr double kRadius_m = 40.0, kRate_radps = 0.2, kEarth_m = 6'371'000.0;
  std::vector<WrittenSample> samples;
  for (int i = 0; i < static_cast<int>(20.0 * duration_s); ++i) {
    const double angle_rad = kRate_radps * 0.05 * i;
    WrittenSample sample;
    sample.ins.stamp_ns = first_ns + i * 50'000'000LL;
    sample.ins.latitude_rad = 0.85 + kRadius_m * std::sin(angle_rad) / kEarth_m;
    sample.ins.longitude_rad = 0.15 - kRadius_m * std::cos(angle_rad) / kEarth_m / std::cos(0.85);
    sample.ins.height_m = 250.0;
    sample.ins.enu_from_ins = drive::enu_from_ins({angle_rad, 0.0, 0.0}, drive::AttitudeConvention::Heading);
    samples.push_back(sample);
  }
  return samples;
}

class DescribedRows : public DescribedDrive {
 protected:
  /// Rows by the number of the sample.
  static void write_rows(const std::filesystem::path& file, const std::string& head,
                         const std::function<Fields(std::size_t, const WrittenSample&)>& row,
                         const std::vector<WrittenSample>& samples) {
    std::ofstream out(file);
    out << head;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const Fields fields = row(i, samples[i]);
      for (std::size_t k = 0; k < fields.size(); ++k) out << (k == 0 ? "" : ",") << fields[k];
      out << "\n";
    }
  }
  static void write_rows(const std::filesystem::path& file, const std::string& head,
                         const std::function<Fields(std::size_t, const WrittenSample&)>& row) {
    write_rows(file, head, row, *samples_);
  }

  /// Of the INS that was found; null where there is none.
  static const Guess* guess_of(const Description& found, GuessKind kind) {
    return found.ins ? find_guess(found.ins->guesses, kind) : nullptr;
  }

  static bool says_why(const Description& found, std::string_view words) {
    return std::ranges::any_of(found.not_used,
                               [&](const NotUsed& one) { return formats::contains(english(one.why), words); });
  }
};

}  // namespace remount::guesses
