// The motion between two scans of a recording.
#include <remount/error.h>
#include <remount/registration.h>

#include <cstdio>
#include <cstdlib>

namespace api = remount::api;

int main(int argc, char** argv) {
  if (argc < 4) return std::fprintf(stderr, "usage: register_scans SESSION SOURCE TARGET\n"), 2;
  try {
    const api::Session session = api::open_session(argv[1]);
    const api::Scan source = session.load_scan(std::strtoul(argv[2], nullptr, 10));
    const api::Scan target = session.load_scan(std::strtoul(argv[3], nullptr, 10));
    const api::Registration found = api::register_scans(source, target, api::Matrix4::Identity());
    if (!found.failure.empty()) return std::printf("%s\n", found.failure.english().c_str()), 1;
    const Eigen::Vector3d moved_m = found.target_from_source.topRightCorner<3, 1>();
    std::printf("moved by %.3f %.3f %.3f m, overlap %.2f, rmse %.3f m\n", moved_m.x(), moved_m.y(), moved_m.z(),
                found.overlap, found.rmse_m);
    return 0;
  } catch (const api::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
