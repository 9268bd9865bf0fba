# One interface target carries warnings and sanitizers to every target of the project.
add_library(remount_flags INTERFACE)
target_compile_options(remount_flags INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Wno-psabi)
if(REMOUNT_SANITIZE)
  target_compile_options(remount_flags INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  target_link_options(remount_flags INTERFACE -fsanitize=address,undefined)
endif()
