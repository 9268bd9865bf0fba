// How the sessions look from above and over time, found out in the background.
#include <algorithm>

#include "app/gui/workbench/workbench.h"
#include "widgets/text/model_text.h"

namespace remount {

std::vector<std::shared_ptr<const DriveOverview>> Workbench::overviews() const {
  std::vector<std::shared_ptr<const DriveOverview>> found;
  for (const auto& session : sessions_) {
    const auto known = overviews_.find(session);
    found.push_back(known == overviews_.end() ? nullptr : known->second);
  }
  return found;
}

void Workbench::look_over_sessions() {
  std::erase_if(overviews_, [this](const auto& known) {
    return std::find(sessions_.begin(), sessions_.end(), known.first) == sessions_.end();
  });
  emit overviews_changed();
  if (jobs_.running(overview_job_)) return;  // it looks again when it is done
  std::vector<std::shared_ptr<const Session>> unknown;
  for (const auto& session : sessions_)
    if (!overviews_.contains(session)) unknown.push_back(session);
  if (unknown.empty()) return;
  overview_job_ = jobs_.start(
      [this, unknown](Progress& progress) -> JobRunner::Deliver {
        std::vector<std::shared_ptr<const DriveOverview>> found;
        for (const auto& session : unknown)
          if (!progress.cancelled()) found.push_back(std::make_shared<const DriveOverview>(drive_overview(*session)));
        return [this, unknown, found] {
          for (std::size_t i = 0; i < found.size(); ++i) {
            overviews_[unknown[i]] = found[i];
            for (const Finding& finding : found[i]->findings)
              emit logged(finding.severity, model_text(finding.where.words()), model_text(finding.explanation));
          }
          if (found.size() == unknown.size()) look_over_sessions();
        };
      },
      [this, unknown](const JobFailure& failure) {
        // Said once; the drive has no map then.
        for (const auto& session : unknown) overviews_[session] = nullptr;
        emit logged(Severity::Warning, failure.where, failure.what);
      });
}

}  // namespace remount
