# clang compiles this tree in about half of GCC's processor time: most of it goes into what is instantiated of Eigen,
# before anything is optimised. Where it is installed and nobody chose a compiler, it is taken. GCC 12 compiles all of it,
# too: cmake --preset release -B build/gcc -DCMAKE_C_COMPILER=gcc -DCMAKE_CXX_COMPILER=g++
if(NOT DEFINED CMAKE_CXX_COMPILER AND NOT DEFINED CMAKE_C_COMPILER AND NOT DEFINED CMAKE_TOOLCHAIN_FILE
   AND NOT DEFINED ENV{CXX} AND NOT DEFINED ENV{CC})
  find_program(REMOUNT_CLANG clang)
  find_program(REMOUNT_CLANGXX clang++)
  if(REMOUNT_CLANG AND REMOUNT_CLANGXX)
    set(CMAKE_C_COMPILER ${REMOUNT_CLANG})
    set(CMAKE_CXX_COMPILER ${REMOUNT_CLANGXX})
  endif()
endif()
