# What is installed, in components: cli, window, library, dev and python. packaging/deb makes a package of each.
# What the programs write of themselves (man pages, completions) is made by the target package_files, which
# packaging/deb builds: `cmake --install` leaves out what is not there.
include(GNUInstallDirs)
# Who answers for the packages. To be replaced by whoever publishes them.
set(REMOUNT_MAINTAINER "Remount developers <remount@localhost.invalid>" CACHE STRING "Maintainer of the packages")
set(REMOUNT_PACKAGE_REVISION 1 CACHE STRING "Revision of the packages, behind the version of the program")
set(package_files ${CMAKE_SOURCE_DIR}/packaging/files)
set(made ${CMAKE_BINARY_DIR}/package)
set(made_files "")

# SOURCE_DATE_EPOCH in the environment makes these, and the packages, the same again.
string(TIMESTAMP REMOUNT_PACKAGE_DAY "%Y-%m-%d" UTC)
string(TIMESTAMP REMOUNT_PACKAGE_TIME "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(${package_files}/invalid.localhost.remount.metainfo.xml.in ${made}/invalid.localhost.remount.metainfo.xml @ONLY)
configure_file(${package_files}/changelog.Debian.in ${made}/changelog.Debian @ONLY)

# remount_made(FILE DEPENDS … COMMAND …): the standard output of the command, compressed where the name ends so. Never
# through a pipe, of which only the last command's failure is seen; and under another name until it is whole.
function(remount_made file)
  cmake_parse_arguments(ARG "" "" "DEPENDS;COMMAND" ${ARGN})
  cmake_path(GET file PARENT_PATH folder)
  file(MAKE_DIRECTORY ${made}/${folder})
  set(part ${made}/${file}.part)
  set(whole ${part})
  set(compress "")
  if(file MATCHES "\\.gz$")
    set(compress COMMAND gzip -9nf ${part})
    set(whole ${part}.gz)
  endif()
  add_custom_command(OUTPUT ${made}/${file} COMMAND ${ARG_COMMAND} > ${part} ${compress}
    COMMAND ${CMAKE_COMMAND} -E rename ${whole} ${made}/${file}
    DEPENDS ${ARG_DEPENDS} COMMENT "Package: ${file}" VERBATIM)
  list(APPEND made_files ${made}/${file})
  set(made_files ${made_files} PARENT_SCOPE)
endfunction()

function(remount_install_documents package component)
  set(folder ${CMAKE_INSTALL_DATADIR}/doc/${package})
  install(FILES ${package_files}/copyright DESTINATION ${folder} COMPONENT ${component})
  install(FILES ${made}/changelog.gz ${made}/changelog.Debian.gz DESTINATION ${folder} COMPONENT ${component} OPTIONAL)
  install(FILES ${package_files}/${package}.lintian-overrides DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides
          RENAME ${package} COMPONENT ${component})
endfunction()

set(cli $<TARGET_FILE:remount-cli>)
remount_made(changelog.gz DEPENDS ${CMAKE_SOURCE_DIR}/CHANGELOG.md COMMAND cat ${CMAKE_SOURCE_DIR}/CHANGELOG.md)
remount_made(changelog.Debian.gz DEPENDS ${made}/changelog.Debian COMMAND cat ${made}/changelog.Debian)
remount_made(completions/remount-cli DEPENDS remount-cli COMMAND ${cli} --completion bash)
remount_made(completions/_remount-cli DEPENDS remount-cli COMMAND ${cli} --completion zsh)
remount_made(man1/remount-cli.1.gz DEPENDS remount-cli COMMAND ${cli} --man-page)
remount_made(zh_CN/man1/remount-cli.1.gz DEPENDS remount-cli COMMAND ${cli} --language zh_CN --man-page)

install(TARGETS remount-cli RUNTIME COMPONENT cli)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/resources/sample DESTINATION ${CMAKE_INSTALL_DATADIR}/remount COMPONENT cli
        PATTERN make_sample.sh EXCLUDE)
install(FILES ${made}/completions/remount-cli DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
        COMPONENT cli OPTIONAL)
install(FILES ${made}/completions/_remount-cli DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT cli
        OPTIONAL)
install(FILES ${made}/man1/remount-cli.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT cli OPTIONAL)
install(FILES ${made}/zh_CN/man1/remount-cli.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/zh_CN/man1 COMPONENT cli OPTIONAL)
remount_install_documents(remount-cli cli)
set(components cli)

if(REMOUNT_BUILD_GUI)
  # Translations and help are inside the program.
  install(TARGETS remount RUNTIME COMPONENT window)
  install(FILES ${package_files}/remount.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT window)
  install(FILES ${package_files}/remount-mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME remount.xml
          COMPONENT window)
  install(FILES ${made}/invalid.localhost.remount.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT window)
  set(icons ${CMAKE_INSTALL_DATADIR}/icons/hicolor)
  install(FILES ${package_files}/remount.svg DESTINATION ${icons}/scalable/apps COMPONENT window)
  find_program(REMOUNT_RSVG_CONVERT rsvg-convert)
  if(REMOUNT_RSVG_CONVERT)
    foreach(size 16 24 32 48 64 128 256)
      set(icon icons/${size}/remount.png)
      remount_made(${icon} DEPENDS ${package_files}/remount.svg
        COMMAND ${REMOUNT_RSVG_CONVERT} -w ${size} -h ${size} ${package_files}/remount.svg)
      install(FILES ${made}/${icon} DESTINATION ${icons}/${size}x${size}/apps COMPONENT window OPTIONAL)
    endforeach()
  endif()
  remount_made(man1/remount.1.gz DEPENDS remount ${CMAKE_SOURCE_DIR}/packaging/man_of_window
    COMMAND ${CMAKE_SOURCE_DIR}/packaging/man_of_window $<TARGET_FILE:remount>)
  install(FILES ${made}/man1/remount.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT window OPTIONAL)
  remount_install_documents(remount window)
  list(APPEND components window)
endif()
if(TARGET remount_library)
  set(libraries ${CMAKE_INSTALL_LIBDIR})
  if(CMAKE_LIBRARY_ARCHITECTURE)  # as Debian has them, whatever the prefix
    set(libraries lib/${CMAKE_LIBRARY_ARCHITECTURE})
  endif()
  install(TARGETS remount_library EXPORT remount LIBRARY DESTINATION ${libraries} COMPONENT library NAMELINK_COMPONENT dev
          INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(EXPORT remount NAMESPACE remount:: FILE remount-targets.cmake DESTINATION ${libraries}/cmake/remount COMPONENT dev)
  include(CMakePackageConfigHelpers)
  write_basic_package_version_file(${made}/remount-config-version.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${CMAKE_SOURCE_DIR}/cmake/remount-config.cmake ${made}/remount-config-version.cmake
          DESTINATION ${libraries}/cmake/remount COMPONENT dev)
  install(DIRECTORY ${CMAKE_SOURCE_DIR}/api/remount ${CMAKE_BINARY_DIR}/generated/api/remount
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev FILES_MATCHING PATTERN "*.h")
  install(DIRECTORY ${CMAKE_SOURCE_DIR}/examples DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libremount-dev COMPONENT dev)
  # The library itself comes with its headers, but in packages, where theirs depends on that of the library.
  install(CODE "if(NOT \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}\" MATCHES \"_CPack_Packages\")
    execute_process(COMMAND \"${CMAKE_COMMAND}\" --install \"${CMAKE_BINARY_DIR}\" --component library
                    --prefix \"\${CMAKE_INSTALL_PREFIX}\" COMMAND_ERROR_IS_FATAL ANY)
  endif()" COMPONENT dev)
  remount_install_documents(libremount${PROJECT_VERSION_MAJOR} library)
  remount_install_documents(libremount-dev dev)
  list(APPEND components library dev)
endif()
if(TARGET remount_python)
  set(folder lib/python3/dist-packages/remount)
  install(TARGETS remount_python LIBRARY DESTINATION ${folder} COMPONENT python)
  set(sources ${CMAKE_SOURCE_DIR}/api/python/remount)
  install(FILES ${sources}/__init__.py ${sources}/__init__.pyi ${sources}/errors.py ${sources}/py.typed DESTINATION ${folder}
          COMPONENT python)
  remount_install_documents(python3-remount python)
  list(APPEND components python)
endif()
add_custom_target(package_files DEPENDS ${made_files})

set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # tests need not be built to be packaged
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME remount)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_VENDOR "Remount developers")
set(CPACK_PACKAGE_CONTACT ${REMOUNT_MAINTAINER})
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
    WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL ${components})
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_RELEASE ${REMOUNT_PACKAGE_REVISION})
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # what is linked; named below is what is not
# What is linked to the library of this tree is told by name, below.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_BINARY_DIR}/lib)
set(CPACK_DEBIAN_CLI_PACKAGE_NAME remount-cli)
set(CPACK_COMPONENT_CLI_DESCRIPTION "calibrates where a LiDAR sits on a vehicle (command line)
Remount finds where a LiDAR sits on a vehicle, relative to its GNSS/INS, from
recorded drives: pairs of scans are registered, compared with the motion of
the INS, and explained by one rigid transform, of which each parameter has its
uncertainty. It reads logs of INS, captures of LiDARs and bags of ROS.

This package has the program for terminals, scripts and fleets, and a sample
drive. It needs no display.")
set(CPACK_DEBIAN_WINDOW_PACKAGE_NAME remount)
set(CPACK_DEBIAN_WINDOW_PACKAGE_DEPENDS "remount-cli (= ${PROJECT_VERSION}-${REMOUNT_PACKAGE_REVISION}), libgl1-mesa-dri")
set(CPACK_DEBIAN_WINDOW_PACKAGE_RECOMMENDS "qt6-translations-l10n, qt6-wayland, fonts-noto-cjk")
set(CPACK_COMPONENT_WINDOW_DESCRIPTION "calibrates where a LiDAR sits on a vehicle (window)
Remount finds where a LiDAR sits on a vehicle, relative to its GNSS/INS, from
recorded drives: pairs of scans are registered, compared with the motion of
the INS, and explained by one rigid transform, of which each parameter has its
uncertainty. It reads logs of INS, captures of LiDARs and bags of ROS.

This package has the workbench with views in 3-D, which needs OpenGL 3.2.")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libremount${PROJECT_VERSION_MAJOR})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
# What CPack's own would be made for every component.
configure_file(${package_files}/library/shlibs.in ${made}/library/shlibs @ONLY)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${package_files}/library/triggers ${made}/library/shlibs)
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "calibrates where a LiDAR sits on a vehicle (shared library)
Remount finds where a LiDAR sits on a vehicle, relative to its GNSS/INS, from
recorded drives: pairs of scans are registered, compared with the motion of
the INS, and explained by one rigid transform, of which each parameter has its
uncertainty. It reads logs of INS, captures of LiDARs and bags of ROS.

This package has the library for other programs.")
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libremount-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
    "libremount${PROJECT_VERSION_MAJOR} (= ${PROJECT_VERSION}-${REMOUNT_PACKAGE_REVISION}), libeigen3-dev")
set(CPACK_COMPONENT_DEV_DESCRIPTION "calibrates where a LiDAR sits on a vehicle (headers)
Remount finds where a LiDAR sits on a vehicle, relative to its GNSS/INS, from
recorded drives: pairs of scans are registered, compared with the motion of
the INS, and explained by one rigid transform, of which each parameter has its
uncertainty. It reads logs of INS, captures of LiDARs and bags of ROS.

This package has what programs are compiled with: headers, the package of
CMake, and examples.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-remount)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
# The module is of one version of Python.
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "libremount${PROJECT_VERSION_MAJOR} (= ${PROJECT_VERSION}-${REMOUNT_PACKAGE_REVISION}), ${REMOUNT_PYTHON_VERSIONS}, python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${package_files}/python3/postinst ${package_files}/python3/prerm)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "calibrates where a LiDAR sits on a vehicle (Python)
Remount finds where a LiDAR sits on a vehicle, relative to its GNSS/INS, from
recorded drives: pairs of scans are registered, compared with the motion of
the INS, and explained by one rigid transform, of which each parameter has its
uncertainty. It reads logs of INS, captures of LiDARs and bags of ROS.

This package has the module remount for Python, with arrays of NumPy.")
include(CPack)
