# find_package(remount): the target remount::remount, a shared library whose headers need Eigen.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 NO_MODULE)
include(${CMAKE_CURRENT_LIST_DIR}/remount-targets.cmake)
