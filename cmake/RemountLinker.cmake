# A fast linker where there is one.
find_program(REMOUNT_LLD ld.lld)
if(REMOUNT_LLD)
  add_link_options(-fuse-ld=lld)
endif()
