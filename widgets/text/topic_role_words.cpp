#include "widgets/text/topic_role_words.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include "model/drive/topic_offer.h"

namespace remount::widgets {

QString role_label(std::string_view role) {
  if (role == "lidar") return QCoreApplication::translate("remount::widgets::TopicsDialog", "&LiDAR");
  if (role == "ins") return QCoreApplication::translate("remount::widgets::TopicsDialog", "&INS");
  if (role == "ins-position")
    return QCoreApplication::translate("remount::widgets::TopicsDialog", "&Position of the INS");
  if (role == "gnss") return QCoreApplication::translate("remount::widgets::TopicsDialog", "&GNSS");
  return QCoreApplication::translate("remount::widgets::TopicsDialog", "I&MU");
}

QString role_name(std::string_view role) {
  if (role == drive::kNominalRole)
    return QCoreApplication::translate("remount::widgets::TopicsDialog", "nominal mounting");
  static const QRegularExpression kKey(QStringLiteral(R"(\(&\w\)|&)"));  // Chinese has its key in brackets
  return role_label(role).remove(kKey);
}

}  // namespace remount::widgets
