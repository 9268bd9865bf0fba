# What Qt's moc writes comes from the class in the header alone. With the folders of what a header includes it reads all
# of Qt and of the standard library first, which takes a third of a second for every header and changes nothing.
get_target_property(moc Qt6::moc IMPORTED_LOCATION)
configure_file(${CMAKE_SOURCE_DIR}/cmake/moc_alone.in ${CMAKE_BINARY_DIR}/generated/moc_alone @ONLY
               FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
function(remount_moc target)
  set_target_properties(${target} PROPERTIES AUTOMOC ON AUTOMOC_EXECUTABLE ${CMAKE_BINARY_DIR}/generated/moc_alone
                        ${ARGN})
endfunction()
