# OpenVDB's own CMake file asks for Boost parts that nothing here uses, so it is found by hand.
find_path(OpenVDB_INCLUDE_DIR openvdb/openvdb.h)
find_library(OpenVDB_LIBRARY openvdb)
mark_as_advanced(OpenVDB_INCLUDE_DIR OpenVDB_LIBRARY)
if (NOT OpenVDB_INCLUDE_DIR OR NOT OpenVDB_LIBRARY)
  message(FATAL_ERROR "OpenVDB was not found (Debian package libopenvdb-dev). Install it, or configure "
    "with -DNPR_USE_OPENVDB=OFF to build without the .vdb reader.")
endif ()
find_package(TBB QUIET)
if (NOT TARGET TBB::tbb)
  message(FATAL_ERROR "TBB, which OpenVDB's headers use, was not found (Debian package libtbb-dev). "
    "Install it, or configure with -DNPR_USE_OPENVDB=OFF to build without the .vdb reader.")
endif ()
add_library(npr_openvdb INTERFACE)
target_include_directories(npr_openvdb SYSTEM INTERFACE "${OpenVDB_INCLUDE_DIR}")
target_link_libraries(npr_openvdb INTERFACE "${OpenVDB_LIBRARY}" TBB::tbb)
# OpenVDB's headers convert half floats by Imath's table, where it was built with Imath.
find_package(Imath CONFIG QUIET)
if (TARGET Imath::Imath)
  target_link_libraries(npr_openvdb INTERFACE Imath::Imath)
endif ()
