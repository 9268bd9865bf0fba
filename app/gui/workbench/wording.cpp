#include "app/gui/workbench/wording.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>

#include "model/method_registry/calibration_method.h"
#include "model/results/preliminary.h"
#include "widgets/text/model_text.h"
#include "widgets/text/parameter_text.h"

namespace remount::gui {
namespace {
struct Wording {
  Q_DECLARE_TR_FUNCTIONS(remount::gui::wording)
};
}  // namespace

QString in_short(const QStringList& entries, const QString& separator) {
  constexpr qsizetype kShown = 4;
  const QString list = entries.first(std::min(kShown, entries.size())).join(separator);
  return entries.size() <= kShown
             ? list
             : list + separator + Wording::tr("and %1 more").arg(static_cast<int>(entries.size() - kShown));
}

QStringList names_of(const std::vector<std::shared_ptr<const drive::Session>>& sessions) {
  QStringList names;
  for (const auto& session : sessions) names << QString::fromStdString(session->name);
  return names;
}

QString scan_name(const std::vector<std::shared_ptr<const drive::Session>>& sessions,
                  const motion::Keyframe& keyframe) {
  const drive::Session& session = *sessions.at(keyframe.session);
  return session.scans ? QString::fromStdString(session.scans->name(keyframe.scan))
                       : Wording::tr("pose %1").arg(keyframe.scan);
}

QString no_pair_text(const Workbench& workbench) {
  const OutputPtr output = workbench.outcome().output();
  return output && output->pairs.empty() && !method_registry::is_from_pairs(output->method)
             ? Wording::tr("This method works without pairs. What it found is on the page Method (Ctrl+Shift+D).")
             : Wording::tr("Select a pair to see its two scans.");
}

QString idle_text(const Workbench& workbench) {
  if (workbench.solutions().refining())
    return Wording::tr(
        "The mounting is solved again; its sigmas, the candidates and the judgement of other pairs follow…");
  if (workbench.activity().solving()) return Wording::tr("Solving again…");
  if (workbench.calibrations().out_of_date()) return Wording::tr("The result is out of date: calibrate again (F5)");
  return Wording::tr("Ready");
}

QString next_text(const Workbench& workbench) {
  if (workbench.activity().opening()) return Wording::tr("The sessions are being opened.");
  if (workbench.activity().calibrating()) {
    const Message& so_far = workbench.activity().so_far();
    return so_far.empty() ? Wording::tr("The calibration is running.") : widgets::model_text(so_far);
  }
  if (workbench.sessions().all().empty()) return Wording::tr("Open the sessions of a vehicle first.");
  return Wording::tr("Calibrate (F5).");
}

QString next_hint(const Workbench& workbench) {
  if (workbench.activity().opening()) return Wording::tr("Opening sessions…");
  if (workbench.activity().calibrating() && workbench.setup().settings().run.method->id == calibration::kPairwise)
    return Wording::tr(
        "Calibrating: choosing scans, aligning pairs, solving.\nPairs and result appear together when all of it is "
        "done. Esc stops, and keeps the pairs that are aligned by then.");
  if (workbench.activity().calibrating())
    return Wording::tr("Calibrating.\nThe result appears when all of it is done. Esc stops.");
  return Wording::tr("Say on the left roughly where the LiDAR sits, or leave it unknown.\nThen calibrate: F5.");
}

widgets::ResultStanding standing_of(const Workbench& workbench) {
  if (!workbench.outcome().output()) return widgets::ResultStanding::Current;
  if (workbench.solutions().refining()) return widgets::ResultStanding::BeingRefined;
  if (workbench.activity().calibrating() || workbench.activity().solving())
    return widgets::ResultStanding::BeingReplaced;
  return workbench.calibrations().out_of_date() ? widgets::ResultStanding::OutOfDate : widgets::ResultStanding::Current;
}

QString standing_note(const Workbench& workbench) {
  if (!workbench.outcome().output()) return {};
  if (workbench.activity().calibrating()) return Wording::tr("Calibrating; this is the result before.");
  if (workbench.solutions().refining())
    return Wording::tr(
        "The mounting is solved again; its sigmas, the candidates and the judgement of other pairs follow.");
  if (workbench.activity().solving()) return Wording::tr("Solving again…");
  const QStringList changes = workbench.calibrations().changes_since_output();
  if (changes.isEmpty()) return {};
  return Wording::tr("This result was made with other settings or files: %1. Calibrate again (F5).")
      .arg(in_short(changes, QStringLiteral("; ")));
}

QString distance_caution(const Workbench& workbench) {
  const OutputPtr output = workbench.outcome().output();
  if (!output) return {};
  QStringList lines;
  if (!output->nominal_known)
    lines << Wording::tr(
        "No nominal mounting was given: \"start\" is the program's own first estimate, not where the LiDAR was "
        "before.");
  if (const QString blind = widgets::shown_parameter_names(~output->result.observed()); !blind.isEmpty())
    lines
        << Wording::tr("Not observed: %1. Distances and heights rest on values there that nobody measured.").arg(blind);
  return lines.join('\n');
}

QString holder_text(const project::LockHolder& holder) {
  if (holder.user.empty()) return Wording::tr("it does not say whose");
  return Wording::tr("%1 on %2 (process %3), since %4")
      .arg(QString::fromStdString(holder.user), QString::fromStdString(holder.host))
      .arg(holder.process)
      .arg(QLocale().toString(QDateTime::fromSecsSinceEpoch(holder.since_s), QLocale::ShortFormat));
}

QString export_warning(const Workbench& workbench) {
  QStringList lines;
  if (const QString note = standing_note(workbench); !note.isEmpty()) lines << note;
  if (const OutputPtr now = workbench.outcome().output(); now && results::is_preliminary(now->result))
    lines << widgets::model_text(now->result.message);
  if (workbench.map_checks().checking())
    lines << Wording::tr("The map is still being compared under this result: what it says is not known yet.");
  const OutputPtr output = workbench.outcome().output();
  const QString blind = output ? widgets::shown_parameter_names(~output->result.observed()) : QString();
  if (!blind.isEmpty())
    lines << Wording::tr(
                 "Not observed: %1. What a file holds for these is not measured: for a translation the nominal "
                 "value or 0, for a rotation the best guess.")
                 .arg(blind);
  return lines.join('\n');
}

}  // namespace remount::gui
