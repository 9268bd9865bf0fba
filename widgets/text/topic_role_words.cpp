#include "widgets/text/topic_role_words.h"

#include <QCoreApplication>

#include "model/drive/topic_offer.h"

namespace remount {

QString role_label(std::string_view role) {
  if (role == "lidar") return QCoreApplication::translate("remount::TopicsDialog", "&LiDAR");
  if (role == "ins") return QCoreApplication::translate("remount::TopicsDialog", "&INS");
  if (role == "ins-position") return QCoreApplication::translate("remount::TopicsDialog", "&Position of the INS");
  if (role == "gnss") return QCoreApplication::translate("remount::TopicsDialog", "&GNSS");
  return QCoreApplication::translate("remount::TopicsDialog", "I&MU");
}

QString role_name(std::string_view role) {
  if (role == kNominalRole) return QCoreApplication::translate("remount::TopicsDialog", "nominal mounting");
  return role_label(role).remove('&');
}

}  // namespace remount
