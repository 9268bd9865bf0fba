// Writes a result in a format of one's own, with what whoever uses it must know; and in the formats that there are.
#include <remount/error.h>
#include <remount/exporters.h>

#include <cstdio>
#include <sstream>

namespace api = remount::api;

std::string my_format(const api::Result& result) {
  std::ostringstream text;
  text << "# point_in_ins = R point_in_lidar + t\n";
  for (const api::Text& warning : api::export_warnings(result)) text << "# " << warning.english() << "\n";
  const api::Matrix4 ins_from_lidar = result.ins_from_lidar();
  for (int row = 0; row < 3; ++row) text << ins_from_lidar.row(row) << "\n";
  return text.str();
}

int main(int argc, char** argv) {
  if (argc < 3) return std::fprintf(stderr, "usage: own_exporter RESULT.yaml FILE\n"), 2;
  try {
    const api::Result result = api::Result::load(argv[1]);
    api::save_text(argv[2], my_format(result));
    for (const api::ExportFormat& format : api::export_formats())
      std::printf("%s: %s\n", format.id.c_str(), format.description.english().c_str());
    std::printf("%s", api::export_text(result, "matrix").c_str());
    return 0;
  } catch (const api::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
