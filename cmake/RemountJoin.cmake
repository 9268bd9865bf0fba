# A build from nothing reads the same headers for every file and instantiates the same templates of Eigen again and
# again. Joined, the files of a folder are compiled as one: faster from nothing, slower after a change of one
# file. So names of helpers (in anonymous namespaces, too) are unique within a folder. Files given behind the target
# stand alone: those with compile options of their own, or with a library's headers by the thousand.
option(REMOUNT_JOIN "Compile the files of a folder as one: faster from nothing, slower after a change" ON)

function(remount_join target)
  if(NOT REMOUNT_JOIN)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    if(source MATCHES "\\.cpp$")
      cmake_path(ABSOLUTE_PATH source OUTPUT_VARIABLE folder)
      cmake_path(GET folder PARENT_PATH folder)
      cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${CMAKE_SOURCE_DIR})
      string(MAKE_C_IDENTIFIER "${folder}" group)
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${group}")
    endif()
  endforeach()
  if(ARGN)
    set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
