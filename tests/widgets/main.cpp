// One QApplication for all tests of widgets: on the display there is, or offscreen where there is none.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include "tests/widgets/support/turn_profile.h"
#include "widgets/basics/gl_support.h"
#include "widgets/basics/theme.h"

#ifdef REMOUNT_SANITIZED
// What drivers keep until the process ends is told from what we lose by the name of the library, which an unloaded one
// has no more.
extern "C" int dlclose(void*) noexcept { return 0; }
#endif

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  if (::testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();  // at build time, where no display may be had
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM") && qEnvironmentVariableIsEmpty("DISPLAY"))
    qputenv("QT_QPA_PLATFORM", "offscreen");
#ifdef REMOUNT_SANITIZED
  // Qt's own loop wakes by its own locked queue; GLib's, which is not built with the sanitizer, looks like a race.
  qputenv("QT_NO_GLIB", "1");
#endif
  remount::widgets::prepare_gl();
  remount::widgets::prepare_theme();
  const remount::testing::ProfiledApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
