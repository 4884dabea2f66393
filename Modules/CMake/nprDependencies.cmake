# Everything that comes from outside, found once.

# Every VTK module that a vtk.module of ours names in DEPENDS or PRIVATE_DEPENDS, and what their
# own targets need at generate time.
set(NPR_VTK_COMPONENTS
  CommonColor CommonComputationalGeometry CommonCore CommonDataModel CommonExecutionModel CommonMath
  CommonMisc CommonSystem CommonTransforms
  FiltersCore FiltersGeneral FiltersGeometry FiltersModeling FiltersSources FiltersTexture
  IOExport IOGeometry IOImage IOImport IOLegacy IOPLY IOXML
  ImagingCore ImagingGeneral InteractionStyle
  RenderingCore RenderingOpenGL2 RenderingUI
  vtksys zlib)
if (NPR_WRAP_PYTHON)
  find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
  list(APPEND NPR_VTK_COMPONENTS WrappingPythonCore Python)
endif ()
find_package(VTK 9.1 REQUIRED COMPONENTS ${NPR_VTK_COMPONENTS})

find_package(Eigen3 REQUIRED NO_MODULE)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
if (NPR_USE_OPENVDB)
  include(nprFindOpenVDB)
endif ()
