#include "remount/exporters.h"

#include "api/bridge.h"
#include "messages/programs.h"
#include "model/formats/files/atomic_save.h"
#include "model/results/exporters/exporter.h"

namespace remount::api {

std::vector<ExportFormat> export_formats() {
  std::vector<ExportFormat> formats;
  for (const auto& format : results::exporters())
    formats.push_back({std::string(format->id()), Text(format->description()), Text(format->direction()),
                       std::string(format->file_name())});
  return formats;
}

std::string export_text(const Result& result, std::string_view format, const FrameNames& frames) {
  return guarded([&] {
    const results::Exporter& exporter = results::exporter(format);
    const results::ResultFile& file = result.file();
    if (!calibration::is_usable(file.result))
      throw remount::Error(remount::ErrorCode::Contract, std::string(format),
                           say::api_nothing_to_export(file.result.message));
    return exporter.write(file, {frames.ins, frames.lidar});
  });
}

std::vector<Text> export_warnings(const Result& result) {
  return texts_of(results::export_warnings(result.file().result));
}

void save_text(const std::filesystem::path& path, std::string_view text) {
  guarded([&] { formats::save_atomically(path, text); });
}

}  // namespace remount::api
