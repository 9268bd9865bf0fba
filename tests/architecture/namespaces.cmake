# The namespace of a source file is that of its folder, and of its tests that of what they test. Arguments: SOURCE;
# FOLDERS, comma-separated, below it.
#
# Another namespace is opened only to declare what lies there, for a member of a class of it, or to describe a record of it
# (`describe`), which is looked for beside the record.
cmake_policy(VERSION 3.25)
if(NOT FOLDERS)
  set(FOLDERS algorithms,model,api,widgets,app,tests)
endif()
string(REPLACE "," ";" tops "${FOLDERS}")
# Folders and their namespaces; the first that fits.
set(rules
    "^(tests/)?algorithms/(core|messages|geometry)/=remount"
    "^(tests/)?model/formats/bags/=remount::bags"
    "^tests/(algorithms/|widgets/)?(support|long|benchmark|screenshots)/=remount::testing"
    "^tests/fuzz/=remount::formats"
    "^tests/model/[^/]+\$=remount::testing"
    "^tests/examples/method_=remount::methods"
    "^tests/examples/exporter_=remount::results"
    "^tests/examples/data_check_=remount::checks"
    "^tests/examples/session_format_=remount::formats"
    "^tests/examples/contributing_=remount"
    "^api/python/=remount::python"
    "^api/=remount::api"
    "^widgets/scene/=remount::scene"
    "^(tests/)?widgets/=remount::widgets"
    "^(tests/)?app/(cli|gui)/=remount::\\2"
    "^(tests/)?(algorithms|model)/([a-z_]+)/=remount::\\3")

# Main functions and the like, which nobody includes.
set(without_namespace api/remount/remount.h app/cli/main.cpp app/gui/main.cpp tests/widgets/main.cpp tests/fuzz/write_seeds.cpp
    tests/examples/contributing_test.cpp)

set(failures "")
set(checked 0)
foreach(top ${tops})
  file(GLOB_RECURSE files RELATIVE ${SOURCE} ${SOURCE}/${top}/*.h ${SOURCE}/${top}/*.cpp)
  list(FILTER files EXCLUDE REGEX "^tests/architecture/")
  foreach(file ${files})
    math(EXPR checked "${checked} + 1")
    set(space "")
    foreach(rule ${rules})
      string(REGEX MATCH "^(.*)=(.*)$" unused "${rule}")
      set(folder "${CMAKE_MATCH_1}")
      set(name "${CMAKE_MATCH_2}")
      if(file MATCHES "${folder}")
        string(REGEX REPLACE "${folder}.*" "${name}" space "${file}")
        break()
      endif()
    endforeach()
    if(space STREQUAL "")
      list(APPEND failures "${file}: its folder has no namespace in tests/architecture/namespaces.cmake")
      continue()
    endif()
    set(nested "^${space}(::.*)?$")
    if(space STREQUAL "remount")
      set(nested "^remount$")
    endif()
    set(other "")
    set(opened FALSE)
    file(STRINGS ${SOURCE}/${file} lines REGEX "^[A-Za-z}]")
    foreach(line ${lines})
      if(line MATCHES "^namespace (remount[a-z0-9_:]*) {")
        set(other "${CMAKE_MATCH_1}")
        if(other MATCHES "${nested}")
          set(opened TRUE)
          set(other "")
        endif()
      elseif(line MATCHES "^}.*// namespace remount")
        set(other "")
      elseif(NOT other STREQUAL "" AND NOT line MATCHES "^(class|struct|enum class|extern) [^{]*$|^[A-Za-z}].*\\);( +//.*)?$|^void describe\\(|^[A-Za-z]+ [A-Za-z]+::[a-z_]+\\(.*}$|^}$")
        list(APPEND failures "${file}: ${line}: in ${other}, but the folder's namespace is ${space}")
      endif()
    endforeach()
    if(NOT opened AND NOT file IN_LIST without_namespace)
      list(APPEND failures "${file}: does not open ${space}")
    endif()
  endforeach()
endforeach()

if(checked EQUAL 0)
  message(FATAL_ERROR "no files were looked at: is ${SOURCE} the root of the sources?")
endif()
if(failures)
  list(JOIN failures "\n" text)
  message(FATAL_ERROR "sources in another namespace than their folder's:\n${text}")
endif()
message(STATUS "${checked} files, each in the namespace of its folder")
