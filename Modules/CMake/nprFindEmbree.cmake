# By hand, for one way suits Embree wherever it is from.
find_path(Embree_INCLUDE_DIR embree3/rtcore.h)
find_library(Embree_LIBRARY embree3)
mark_as_advanced(Embree_INCLUDE_DIR Embree_LIBRARY)
if (NOT Embree_INCLUDE_DIR OR NOT Embree_LIBRARY)
  message(FATAL_ERROR "Embree 3 was not found (Debian package libembree-dev). Install it, or configure "
    "with -DNPR_USE_EMBREE=OFF to build without vtkNPRStrokeVisibility, which finds hidden lines.")
endif ()
add_library(npr_embree INTERFACE)
target_include_directories(npr_embree SYSTEM INTERFACE "${Embree_INCLUDE_DIR}")
target_link_libraries(npr_embree INTERFACE "${Embree_LIBRARY}")
