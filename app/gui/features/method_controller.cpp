#include "app/gui/features/method_controller.h"

#include <QFileInfo>
#include <algorithm>

#include "algorithms/core/error.h"
#include "app/gui/jobs/error_words.h"
#include "model/drive/session_frames.h"
#include "model/method_registry/calibration_method.h"
#include "widgets/map/path_view.h"
#include "widgets/methods/method_view.h"
#include "widgets/result/comparison_view.h"
#include "widgets/text/model_text.h"

namespace remount::gui {
namespace {

QString title_of(const std::string& id) {
  const method_registry::CalibrationMethod* method = method_registry::find_method(id);
  return method ? widgets::model_text(method->title()) : QString::fromStdString(id);
}

}  // namespace

MethodController::MethodController(Workbench& workbench, widgets::MethodView& view, widgets::PathView& paths,
                                   widgets::ComparisonView& comparison, QObject* parent)
    : QObject(parent), workbench_(workbench), view_(view), paths_(paths), comparison_(comparison) {
  connect(&comparison_, &widgets::ComparisonView::clear_requested, this, &MethodController::clear_files);
  connect(&workbench_.outcome(), &Outcome::changed, this, &MethodController::show_output);
  connect(&workbench_.sessions(), &SessionList::changed, this, &MethodController::change_sessions);
  sessions_ = workbench_.sessions().all();
  show_output();
}

void MethodController::change_sessions() {
  if (workbench_.sessions().all() == sessions_) return;
  std::erase_if(compared_.before, [](const KeptResults::OfSessions& kept) {
    return std::any_of(kept.sessions.begin(), kept.sessions.end(), [](const auto& one) { return one.expired(); });
  });
  if (!compared_.of_methods.empty())
    compared_.before.push_back({{sessions_.begin(), sessions_.end()}, std::move(compared_.of_methods)});
  compared_.of_methods.clear();  // other sessions may be of another vehicle
  sessions_ = workbench_.sessions().all();
  const auto same = [this](const KeptResults::OfSessions& kept) {
    return std::equal(kept.sessions.begin(), kept.sessions.end(), sessions_.begin(), sessions_.end(),
                      [](const auto& then, const auto& now) { return then.lock() == now; });
  };
  if (const auto kept = std::find_if(compared_.before.begin(), compared_.before.end(), same);
      kept != compared_.before.end()) {
    compared_.of_methods = std::move(kept->of_methods);
    compared_.before.erase(kept);
  }
  show_comparison();
}

void MethodController::show_output() {
  const OutputPtr output = workbench_.outcome().output();
  if (!output) {
    shown_.reset();
    view_.show_message(tr("After a calibration the figures and plots of its method are shown here."));
    paths_.show_plots({}, tr("After a calibration the ways that its method found are shown here in space."));
    return show_comparison();
  }
  if (output == shown_) return;
  shown_ = output;
  const QString title = title_of(output->method);
  if (output->quantities.empty() && output->plots.empty())
    view_.show_message(tr("Method: %1. Its figures are in the other panels.").arg(title));
  else
    view_.show_method(tr("Method: %1").arg(title), output->quantities, output->plots);
  paths_.show_plots(output->plots,
                    output->keyframes.empty()
                        ? tr("The method drew nothing in space.")
                        : tr("The method drew no way of its own: its scans are in the views \"Pair\" and \"Map\"."));
  if (calibration::is_usable(output->result)) {
    report::NamedResult& named = compared_.of_methods[output->method];
    named.name = title_of(output->method).toStdString();
    named.file = {};
    named.file.method = output->method;
    named.file.result = output->result;
    named.file.ins_axes = drive::common_axes(workbench_.outcome().input().sessions);
  }
  show_comparison();
}

void MethodController::show_comparison() {
  std::vector<report::NamedResult> results;
  for (const auto& [id, result] : compared_.of_methods) results.push_back(result);
  results.insert(results.end(), compared_.of_files.begin(), compared_.of_files.end());
  comparison_.show_results(results);
}

void MethodController::add_files(const QStringList& paths) {
  for (const QString& path : paths) {
    try {
      compared_.of_files.push_back(
          {QFileInfo(path).completeBaseName().toStdString(), results::load_result(path.toStdString())});
    } catch (const Error& error) {
      const JobFailure failure = failure_of(error);
      workbench_.notices().say(drive::Severity::Problem, failure.where, failure.what);
    }
  }
  show_comparison();
}

void MethodController::take_over(KeptResults compared) {
  compared_ = std::move(compared);
  for (auto& [id, result] : compared_.of_methods) result.name = title_of(id).toStdString();
  for (KeptResults::OfSessions& before : compared_.before)
    for (auto& [id, result] : before.of_methods) result.name = title_of(id).toStdString();
  show_comparison();
}

void MethodController::clear_files() {
  compared_.of_files.clear();
  show_comparison();
}

}  // namespace remount::gui
