# remount_discover_suites(target [ALONE suite...] [WITHOUT suite...] PROPERTIES name value...): a ctest entry for each
# suite of a binary of GoogleTest, after it is built. Most tests take less time than a start of their process: an entry
# for each took a minute of the whole run. Tests of the suites in ALONE have an entry each, for they measure what their
# process holds; those in WITHOUT have none. Suites whose names end in _speed measure
# time: no other test runs beside them.
function(remount_discover_suites target)
  cmake_parse_arguments(ARG "" "" "ALONE;WITHOUT;PROPERTIES" ${ARGN})
  set(list ${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake)
  add_custom_command(TARGET ${target} POST_BUILD
    COMMAND ${CMAKE_COMMAND} -E env QT_QPA_PLATFORM=offscreen ${CMAKE_COMMAND} "-DBINARY=$<TARGET_FILE:${target}>"
            "-DLIST=${list}" "-DALONE=${ARG_ALONE}" "-DWITHOUT=${ARG_WITHOUT}" "-DPROPERTIES=${ARG_PROPERTIES}"
            -P ${CMAKE_SOURCE_DIR}/cmake/list_suites.cmake
    BYPRODUCTS ${list} VERBATIM)
  set(include ${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake)
  file(WRITE ${include} "if(EXISTS \"${list}\")\n  include(\"${list}\")\nelse()\n"
                        "  add_test(${target}_NOT_BUILT ${target}_NOT_BUILT)\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${include})
endfunction()
