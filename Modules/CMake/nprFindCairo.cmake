# cairo comes without a CMake file.
find_path(Cairo_INCLUDE_DIR cairo-pdf.h PATH_SUFFIXES cairo)
find_library(Cairo_LIBRARY cairo)
mark_as_advanced(Cairo_INCLUDE_DIR Cairo_LIBRARY)
if (NOT Cairo_INCLUDE_DIR OR NOT Cairo_LIBRARY)
  message(FATAL_ERROR "cairo was not found (Debian package libcairo2-dev). Install it, or configure "
    "with -DNPR_USE_CAIRO=OFF to build without the writer of PDF.")
endif ()
add_library(npr_cairo INTERFACE)
target_include_directories(npr_cairo SYSTEM INTERFACE "${Cairo_INCLUDE_DIR}")
target_link_libraries(npr_cairo INTERFACE "${Cairo_LIBRARY}")
