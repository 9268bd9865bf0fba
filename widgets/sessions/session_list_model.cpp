#include "widgets/sessions/session_list_model.h"

#include <QBrush>
#include <algorithm>

#include "algorithms/core/stamps.h"
#include "model/checks/data_check.h"
#include "model/method_registry/calibration_method.h"
#include "widgets/basics/rows.h"
#include "widgets/basics/theme.h"
#include "widgets/text/model_text.h"

namespace remount::widgets {
namespace {

constexpr quintptr kTop = 0;  // internalId of a session; a finding carries its session's row + 1

double duration_s(const drive::Session& session) {
  if (session.scans && session.scans->size() > 1)
    return seconds(session.scans->stamp_ns(session.scans->size() - 1) - session.scans->stamp_ns(0));
  const auto& poses = session.odometry_from_lidar;
  return poses.size() > 1 ? seconds(poses.back().stamp_ns - poses.front().stamp_ns) : 0.0;
}

drive::Severity worst(const std::vector<drive::Finding>& findings) {
  drive::Severity severity = drive::Severity::Note;
  for (const drive::Finding& finding : findings) severity = std::max(severity, finding.severity);
  return severity;
}

/// What was found, what it means and what to do.
QString told_in_full(const drive::Finding& finding) {
  QString text = model_text(finding.where.words()) + '\n' + model_text(finding.explanation);
  if (const checks::FindingKind* kind = checks::finding_kind(finding.code))
    text += "\n\n" + model_text(kind->meaning()) + '\n' +
            SessionListModel::tr("What to do: %1").arg(model_text(kind->remedy()));
  return text + "\n[" + QString::fromStdString(finding.code) + ']';
}

}  // namespace

QString session_summary(const drive::Session& session) {
  QStringList parts{QString::fromStdString(session.format)};
  if (!session.lidar_name.empty()) parts << QString::fromStdString(session.lidar_name);
  const QString seconds = SessionListModel::tr("%1 s").arg(duration_s(session), 0, 'f', 1);
  if (session.scans)
    parts << SessionListModel::tr("%n scans in %1", nullptr, qt_count(session.scans->size())).arg(seconds);
  if (!session.odometry_from_lidar.empty())
    parts
        << SessionListModel::tr("%1 LiDAR poses in %2, no scans").arg(session.odometry_from_lidar.size()).arg(seconds);
  if (!session.ins.empty()) parts << SessionListModel::tr("%1 INS samples").arg(session.ins.size());
  if (!session.world_from_ins.empty()) parts << SessionListModel::tr("%1 INS poses").arg(session.world_from_ins.size());
  return parts.join(QStringLiteral(" · "));
}

void SessionListModel::show_sessions(std::vector<std::shared_ptr<const drive::Session>> sessions) {
  beginResetModel();
  sessions_ = std::move(sessions);
  drives_.clear();
  collect_findings();
  uses_.clear();
  endResetModel();
}

void SessionListModel::show_drives(std::vector<std::shared_ptr<const overview::DriveOverview>> drives) {
  if (drives == drives_) return;
  beginResetModel();
  drives_ = std::move(drives);
  collect_findings();
  endResetModel();
}

void SessionListModel::collect_findings() {
  findings_.clear();
  for (std::size_t i = 0; i < sessions_.size(); ++i) {
    std::vector<drive::Finding> all = sessions_[i]->findings;
    if (i < drives_.size() && drives_[i])
      all.insert(all.end(), drives_[i]->findings.begin(), drives_[i]->findings.end());
    findings_.push_back(std::move(all));
  }
}

void SessionListModel::show_use(const std::shared_ptr<const pipeline::PipelineOutput>& output, std::size_t calibrated) {
  uses_.clear();
  if (output && method_registry::is_from_pairs(output->method) && !output->pairs.empty())
    uses_ = count_by_session(*output, std::min(calibrated, sessions_.size()));
  if (!sessions_.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, 0));
}

QString SessionListModel::use_text(motion::SessionIndex session) const {
  if (session >= uses_.size()) return {};
  const SessionUse& use = uses_[session];
  if (!use.unused()) return '\n' + tr("%1 of %2 pairs accepted").arg(use.accepted).arg(use.pairs);
  return '\n' + (use.pairs == 0 ? tr("not in the result: it has no pairs")
                                : tr("not in the result: none of its %1 pairs is accepted").arg(use.pairs));
}

void SessionListModel::set_palette(const QPalette& palette) { palette_ = palette; }

std::optional<motion::SessionIndex> SessionListModel::session_of(const QModelIndex& index) const {
  if (!index.isValid()) return std::nullopt;
  return index.internalId() == kTop ? at_row<motion::SessionIndex>(index.row())
                                    : index_at<motion::SessionIndex>(index.internalId() - 1);
}

bool SessionListModel::has_topics(motion::SessionIndex session) const { return !sessions_.at(session)->topics.empty(); }

QModelIndex SessionListModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row() + 1) : kTop);
}

QModelIndex SessionListModel::parent(const QModelIndex& child) const {
  if (!child.isValid() || child.internalId() == kTop) return {};
  return createIndex(qt_row(session_of(child)), 0, kTop);
}

int SessionListModel::rowCount(const QModelIndex& parent) const {
  if (!parent.isValid()) return qt_count(sessions_.size());
  if (parent.internalId() != kTop || parent.column() != 0) return 0;
  return qt_count(findings_[index_at(parent.row())].size());
}

int SessionListModel::columnCount(const QModelIndex&) const { return ColumnCount; }

QVariant SessionListModel::data(const QModelIndex& index, int role) const {
  const std::optional<motion::SessionIndex> place = session_of(index);
  if (!place) return {};
  const motion::SessionIndex number = *place;
  const drive::Session& session = *sessions_[number];
  const bool is_session = index.internalId() == kTop;
  if (is_session) {
    const drive::Severity found = worst(findings_[number]);
    const drive::Severity severity = is_unused(number) ? std::max(drive::Severity::Warning, found) : found;
    if (role == Qt::DisplayRole) {
      const QString sign = severity == drive::Severity::Note ? QString() : severity_sign(severity) + ' ';
      return sign + QString::fromStdString(session.name) + '\n' + session_summary(session) + use_text(number);
    }
    if (role == Qt::ToolTipRole) return QString::fromStdString(session.path.string()) + '\n' + session_summary(session);
    if (role == Qt::ForegroundRole && severity != drive::Severity::Note)
      return QBrush(severity_color(severity, palette_));
    return {};
  }
  const drive::Finding& finding = findings_[number][index_at(index.row())];
  const QString explanation = model_text(finding.explanation);
  if (role == Qt::DisplayRole)
    return severity_sign(finding.severity) + ' ' + model_text(finding.where.words()) + QStringLiteral(": ") +
           explanation;
  if (role == Qt::ToolTipRole) return told_in_full(finding);
  if (role == Qt::ForegroundRole) return QBrush(severity_color(finding.severity, palette_));
  return {};
}

QVariant SessionListModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return section == Name ? tr("Session") : QString();
}

}  // namespace remount::widgets
