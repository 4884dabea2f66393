# Everything that comes from outside, found once.

# Every VTK module that a vtk.module of ours names in DEPENDS or PRIVATE_DEPENDS. Whoever uses the
# installed package needs them, too.
set(NPR_VTK_COMPONENTS
  CommonColor CommonCore CommonDataModel CommonExecutionModel CommonMath CommonSystem CommonTransforms
  FiltersCore FiltersGeneral FiltersGeometry
  IOCore IOGeometry IOImage IOLegacy IOPLY IOXML
  ImagingCore ImagingGeneral
  RenderingCore RenderingOpenGL2 RenderingUI
  exprtk vtksys zlib)

# What only the build needs.
set(build_components RenderingFreeType)
set(python_components)
if (BUILD_TESTING)
  list(APPEND build_components
    CommonComputationalGeometry CommonMisc
    FiltersHybrid FiltersParallel FiltersSources FiltersTexture IOExport IOXMLParser)
  list(APPEND python_components Interpreter)
endif ()
if (NPR_WRAP_PYTHON)
  list(APPEND build_components WrappingPythonCore Python)
  list(APPEND python_components Interpreter Development.Module)
endif ()
if (python_components)
  find_package(Python3 REQUIRED COMPONENTS ${python_components})
endif ()
find_package(VTK 9.1 REQUIRED COMPONENTS ${NPR_VTK_COMPONENTS} ${build_components})

find_package(Eigen3 REQUIRED NO_MODULE)
find_package(OpenMesh REQUIRED CONFIG)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
if (NPR_USE_OPENVDB)
  include(nprFindOpenVDB)
endif ()
if (NPR_USE_CAIRO)
  include(nprFindCairo)
  include(nprFindQpdf)
endif ()
if (NPR_USE_EMBREE)
  include(nprFindEmbree)
endif ()
