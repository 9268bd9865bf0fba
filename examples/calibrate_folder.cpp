// Calibrates from a recorded drive and says what was found.
#include <remount/calibrate.h>
#include <remount/error.h>

#include <cstdio>

namespace api = remount::api;

int main(int argc, char** argv) {
  if (argc < 2) return std::fprintf(stderr, "usage: calibrate_folder SESSION [RESULT.yaml]\n"), 2;
  try {
    const api::Session session = api::open_session(argv[1]);
    for (const api::Stream& sensor : session.sensors())
      std::printf("%s: %zu at %.1f Hz\n", sensor.sensor.c_str(), sensor.count, sensor.rate_hz);
    for (const api::Finding& finding : session.findings())
      std::printf("%s: %s\n", finding.code.c_str(), finding.explanation.english().c_str());

    api::CalibrateOptions options;
    options.settings.set("run.map_check", false);
    std::string stage;
    const api::Progress progress([&](const api::Step& step) {
      if (step.stage.code() != stage) std::printf("... %s\n", step.stage.english().c_str());
      stage = step.stage.code();
    });
    const api::Result result = api::calibrate({session}, options, progress);

    std::printf("%s: %s\n", std::string(to_string(result.status())).c_str(), result.message().english().c_str());
    for (const api::Parameter parameter : api::kParameters) {
      const api::Estimate estimate = result.estimate(parameter);
      const std::string name(to_string(parameter));
      if (estimate.observed)
        std::printf("%s %.4f +- %.2g\n", name.c_str(), estimate.value, *estimate.sigma);
      else
        std::printf("%s: %s\n", name.c_str(), estimate.why_not_observed.english().c_str());
    }
    if (argc > 2) result.save(argv[2]);
    return result.usable() ? 0 : 1;
  } catch (const api::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
