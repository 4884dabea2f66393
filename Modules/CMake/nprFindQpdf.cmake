# Version 11 is the first with a CMake file. To ask for it by number would refuse 12, which serves
# as well.
find_package(qpdf CONFIG QUIET)
if (NOT TARGET qpdf::libqpdf)
  message(FATAL_ERROR "qpdf 11 or newer was not found (Debian package libqpdf-dev). Install it, or "
    "configure with -DNPR_USE_CAIRO=OFF to build without the writer of PDF.")
endif ()
add_library(npr_qpdf INTERFACE)
target_link_libraries(npr_qpdf INTERFACE qpdf::libqpdf)
# Version 11 warns where nobody says that its old pointers are not used.
target_compile_definitions(npr_qpdf INTERFACE POINTERHOLDER_TRANSITION=4)
