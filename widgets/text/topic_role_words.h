// What the topics of a bag serve as, in the window.
#pragma once

#include <QString>
#include <string_view>

namespace remount::widgets {

/// "LiDAR", "position of the INS".
QString role_name(std::string_view role);

/// The same with the key that leads to it.
QString role_label(std::string_view role);

}  // namespace remount::widgets
