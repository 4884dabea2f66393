// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprSurfacePipeline_h
#define nprSurfacePipeline_h

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

class vtkAlgorithm;
class vtkAlgorithmOutput;
class vtkNPRCurvatureTensor;
class vtkNPRFeatureLines;
class vtkNPRSurfaceNormals;
class vtkNPRSurfaceOrder;
class vtkNPRSurfacePreparation;
class vtkNPRSurfaceRefinement;
class vtkObject;

namespace npr
{
struct GeometryStyle;

/**
 * @class SurfacePipeline
 * @brief The filters from any surface to its feature lines, connected and tuned to a view.
 *
 * preparation -> normals -> curvature -> refinement -> its own normals -> feature lines.
 * The refined surface is shaded with the normals that it was made from, which are smooth; its lines
 * are taken with its own, so that its outline is where its facets turn away.
 * Curvature and its derivatives are taken from the mesh as it is; refinement then carries them to a
 * finer, smooth mesh, so that coarse models get smooth outlines, too.
 * What is shaded has its triangles in an order that is drawn faster: neighbours share vertices that
 * have just been transformed. Lines keep the surface's own order, as strokes are numbered by it.
 */
class SurfacePipeline
{
public:
  SurfacePipeline();
  ~SurfacePipeline();
  SurfacePipeline(const SurfacePipeline&) = delete;
  void operator=(const SurfacePipeline&) = delete;

  void SetInputConnection(vtkAlgorithmOutput* surface);

  /// Lengths on the page become lengths on the surface by unit: what a thousandth of the image's
  /// shorter side is in the coordinates of the surface. Prepares the surface, for its length scale.
  /// A surface that is shown as it is (for its texture, say) is not refined; where it is coarse, so
  /// that its facets are seen, its outline is that of the facets.
  void Tune(const GeometryStyle& geometry, double unit, bool refine);

  /// Whether lines follow the edges of facets, and so are to be straight.
  bool IsFaceted() const { return this->Faceted; }

  /// The prepared, smooth surface with its normals, and the same to be shaded.
  vtkAlgorithmOutput* GetSurfacePort();
  vtkAlgorithmOutput* GetShadedPort();
  vtkNPRFeatureLines* GetFeatureLines() { return this->Lines; }

  /// Of the prepared surface; 0 when it has no area.
  double GetLengthScale();

  /// Whether none of what can be seen from outside is the back of the surface, which is brought up
  /// to date for this.
  bool ShowsOnlyFronts();

  /// Where no lines are wanted, neither are curvatures.
  void SkipCurvature();

  /// Run everything that does not depend on the view.
  void Update();

  /// Called with the fraction that is done of what does not depend on the view.
  void SetProgress(std::function<void(double)> progress) { this->Progress = std::move(progress); }

  /// Seconds in "prepare", "curvature" and "lines".
  double GetSeconds(const std::string& stage) const;

private:
  void Watch(vtkAlgorithm* filter, const std::string& stage);
  void OnStart(vtkObject* filter, unsigned long event, void* data);
  void OnEnd(vtkObject* filter, unsigned long event, void* data);
  void OnProgress(vtkObject* filter, unsigned long event, void* data);

  vtkNew<vtkNPRSurfacePreparation> Preparation;
  vtkNew<vtkNPRSurfaceNormals> Normals;
  vtkNew<vtkNPRCurvatureTensor> Tensor;
  vtkNew<vtkNPRSurfaceRefinement> Refinement;
  vtkNew<vtkNPRSurfaceOrder> ShadedOrder;
  vtkNew<vtkNPRSurfaceNormals> RefinedNormals;
  vtkNew<vtkNPRFeatureLines> Lines;

  std::function<void(double)> Progress;
  std::map<vtkObject*, std::string> Stages;
  std::vector<std::pair<vtkSmartPointer<vtkObject>, unsigned long>> Observers;
  std::map<std::string, double> Seconds;
  double StartTime = 0.0;
  bool Faceted = false;
  bool OnlyFronts = false;
  vtkMTimeType TimeOfFronts = 0; // of the surface that this was found for
};
}

#endif
