# Headers that most files of a target include are read once: reading them takes a third of the time of a build.
# Further ones of a target come after its name. -fpch-preprocess lets ccache see them.
set(REMOUNT_COMMON_HEADERS <algorithm> <array> <cmath> <cstdint> <cstdio> <filesystem> <functional> <limits> <memory>
    <optional> <random> <span> <string> <string_view> <vector> <Eigen/Core> <Eigen/Geometry>)
set(REMOUNT_QT_HEADERS <QHBoxLayout> <QLabel> <QPainter> <QPushButton> <QString> <QVBoxLayout> <QWidget>)
function(remount_precompile target)
  target_precompile_headers(${target} PRIVATE ${REMOUNT_COMMON_HEADERS} ${ARGN})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC 12 is wrong about std::string and Eigen in these; it is silent where their headers are read as system
    # headers, but not where they come precompiled.
    set(quiet -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread -Wno-maybe-uninitialized -Wno-restrict)
    target_compile_options(${target} PRIVATE "$<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess;${quiet}>")
  endif()
endfunction()
