# Headers that most files of a target include are read once: reading them takes a third of the time of a build.
# Further ones of a target come after its name. -fpch-preprocess lets ccache see them.
set(REMOUNT_COMMON_HEADERS <algorithm> <array> <cmath> <cstdint> <cstdio> <filesystem> <functional> <limits> <memory>
    <optional> <random> <span> <string> <string_view> <vector> <Eigen/Core> <Eigen/Geometry>)
set(REMOUNT_QT_HEADERS <QHBoxLayout> <QLabel> <QPainter> <QPushButton> <QString> <QVBoxLayout> <QWidget>)
function(remount_precompile target)
  target_precompile_headers(${target} PRIVATE ${REMOUNT_COMMON_HEADERS} ${ARGN})
  remount_precompiled_options(${target})
endfunction()
# Those of `other`, which is compiled with the same options: making them takes five seconds.
function(remount_precompile_as target other)
  target_precompile_headers(${target} REUSE_FROM ${other})
  remount_precompiled_options(${target})
endfunction()
function(remount_precompiled_options target)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC 12 is wrong about std::string and Eigen in these; it is silent where their headers are read as system
    # headers, but not where they come precompiled.
    set(quiet -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread -Wno-maybe-uninitialized -Wno-restrict)
    target_compile_options(${target} PRIVATE "$<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess;${quiet}>")
  else()
    # A precompiled header from the compiler's cache is as good as one that was made here: clang would refuse it where
    # the header it was made of is younger.
    target_compile_options(${target} PRIVATE "$<$<COMPILE_LANGUAGE:CXX>:SHELL:-Xclang -fno-pch-timestamp>")
  endif()
endfunction()
