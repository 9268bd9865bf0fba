// Whether settings of the user are kept from one start to the next.
#pragma once

#include <QCoreApplication>

namespace remount::widgets {

/// Layout, keys and lists are remembered for the application; a test's window, which has no organisation, leaves no
/// trace.
inline bool remembers() { return !QCoreApplication::organizationName().isEmpty(); }

}  // namespace remount::widgets
