// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRLineDefinition
 * @brief What a kind of line is: where on a surface it runs, and how strong it is there.
 *
 * A definition has a *field part*, an *edge part*, or both.
 * - Field part: the line is the zero set of a scalar field given at the points, where a test holds.
 *   The field may be one whose sign belongs to an axis that is known only up to its sign, as a
 *   derivative along a principal direction is.
 * - Edge part: the line runs along edges of the mesh that the definition accepts.
 *
 * vtkNPRFeatureLines evaluates definitions over whole spans of points or edges, so a virtual call
 * never falls on a single point. To add a kind of line, derive from this class and name the new
 * class in the list at the top of vtkNPRLineDefinition.cxx; nothing else knows the kinds. A program
 * adds kinds of its own at run time by AddKind().
 *
 * A field may be drawn at several levels at once: the line is where it has one of them.
 *
 * Thresholds are numbers without dimension: curvatures are multiplied by the surface's length
 * scale, their derivatives by its square.
 *
 * @sa vtkNPRFeatureLines
 */
#ifndef vtkNPRLineDefinition_h
#define vtkNPRLineDefinition_h

#include "nprVTKCompat.h"
#include "vtkNPRFiltersLinesModule.h"
#include <vtkObject.h>

#ifndef __VTK_WRAP__
#include "nprLineSurface.h"
namespace npr
{
class PlaneBounds;
struct AxisPoint;
}
#endif

#include <array>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

class VTKNPRFILTERSLINES_EXPORT vtkNPRLineDefinition : public vtkObject
{
public:
  vtkAbstractTypeMacro(vtkNPRLineDefinition, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// @name All kinds of lines
  ///@{
  static int GetNumberOfLineNames();
  /// The name of a kind, such as "contours"; null when the index is out of range.
  static const char* GetLineName(int index);
  /// A new definition of the named kind, which the caller owns; null when there is none.
  static VTK_NEWINSTANCE vtkNPRLineDefinition* NewFromName(const char* name);
  ///@}

  /// @name Kinds of lines made at run time
  /// From the registration on, in this process, filters, styles and messages know the kind by the
  /// name that the definition says: NewFromName() makes copies of it (see CopyParameters()).
  /// Another registration of the name takes its place. Not for several threads at a time.
  ///@{
  /// False, and nothing is added, where the name is empty or that of a built-in kind.
  static bool AddKind(vtkNPRLineDefinition* definition);
  static void RemoveKind(const char* name);
  ///@}

  /// The name of this kind of line, in lower case; it stands in LineTypeNames of the output.
  virtual const char* GetName() const = 0;
  /// One line for people: what these lines show.
  virtual const char* GetDescription() const = 0;
  /// Whether the lines move with the view.
  virtual bool IsViewDependent() const = 0;
  /// Whether the lines can be drawn on any surface. False for those that need a cell array, which
  /// only the user's data can have, or a text that is empty as yet.
  bool IsForAnySurface() const;

  /// @name Parameters by name
  /// What the command line and style files set; the same values have Set and Get functions of their
  /// own. A parameter is either numbers, mostly one, or a text.
  ///@{
  int GetNumberOfParameters() const { return static_cast<int>(this->Parameters.size()); }
  /// Null when the index is out of range.
  const char* GetParameterName(int index) const;
  const char* GetParameterDescription(int index) const;
  /// The size of a list: it takes any number of numbers up to this.
  static constexpr int AnyNumber = 4096;
  /// How many numbers a parameter takes; 0 for a text, -1 when there is no such parameter.
  int GetParameterSize(const char* name) const;
  /// False, and nothing is set, when there is no such parameter of so many numbers or a value is
  /// out of its range.
  bool SetParameter(const char* name, double value);
  bool SetParameter(const char* name, const std::vector<double>& values);
  /// False, and nothing is set, when there is no such text.
  bool SetTextParameter(const char* name, const std::string& text);
  /// Its first number; NaN when there is no such parameter or number.
  double GetParameter(const char* name) const;
  /// All its numbers; none for a text, or when there is no such parameter.
  std::vector<double> GetParameterValues(const char* name) const;
  /// Empty when there is no such text.
  std::string GetTextParameter(const char* name) const;
  /// Takes over the parameters of another definition of the same class.
  virtual void CopyParameters(vtkNPRLineDefinition* other);
  /// What is wrong with the parameters, beyond the range of each; empty when nothing is.
  virtual std::string FindProblem() const { return std::string(); }
  ///@}

#ifndef __VTK_WRAP__
  using Index = npr::TriangleMesh::Index;

  /// Which edges an edge part looks at. Seams are those where no two triangles share both points:
  /// borders, split creases, and edges of more than two triangles.
  enum EdgeKind
  {
    NoEdges,
    SeamEdges,
    AllEdges
  };

  /// As the number of components of a RequiredArray.
  static constexpr int AnyComponents = 0;
  /// A point array that the definition reads, mostly one of nprArrayNames.h, and what makes it:
  /// null where that is the user.
  struct RequiredArray
  {
    const char* Name;
    int Components;
    const char* Maker;
  };
  virtual std::vector<RequiredArray> GetRequiredArrays() const
  {
    return {};
  }
  /// Whether the lines go by the size of derivatives of curvature, so that there are none where the
  /// array DerivativeDoubt says that these mean nothing. Default is whether these are required, but
  /// not to find a maximum: that of the curvature across a fillet shows on slivers, too.
  virtual bool NeedsDerivatives() const;
  /// How doubtful the lines are at each point: they fade out while that grows to 1. Only asked
  /// where they need derivatives and the surface has the array DerivativeDoubt, which is the
  /// default.
  virtual const float* GetDoubts(const npr::LineSurface& surface) const;
  /// The name of the cell array whose values the definition compares (see
  /// npr::LineSurface::GetRegions()); null for none.
  virtual const char* GetRequiredCellArray() const
  {
    return nullptr;
  }
  /// What is wrong with the parameters for this surface, whose required arrays are loaded; empty
  /// when nothing is. Words that go after "The lines "NAME":".
  virtual std::string FindError(const npr::LineSurface&) const
  {
    return {};
  }

  /// How many rings of triangles beyond those of a piece its lines depend on.
  virtual double GetReach() const
  {
    return this->GetLeastRow();
  }

  /// @name Calls before and after the work
  /// On the thread that updates the filter.
  ///@{
  /// Before anything is asked about the required arrays.
  virtual void BindInput(vtkPolyData*) {}
  /// Once for a surface that has the required arrays, and again when parameters have changed: adds
  /// arrays to it that no view changes.
  virtual void PrepareSurface(npr::LineSurface&) {}
  /// Before the first evaluation in a view, and after the last; views do not matter to a definition
  /// that depends on none.
  virtual void BeginView(const npr::LineSurface&, const npr::LineView&) {}
  virtual void EndView(const npr::LineSurface&) {}
  ///@}

  /// @name Field part
  /// The functions must be safe to call from several threads at a time.
  ///@{
  virtual bool HasField() const
  {
    return false;
  }
  /// The values of the field that the lines are at, in ascending order. Default is 0 alone.
  virtual std::vector<float> GetLevels(const npr::LineSurface&) const
  {
    return { 0.0f };
  }
  /// What the output adds to a level, where the field is relative to the origin of the surface.
  virtual double GetLevelOffset(const npr::LineSurface&) const
  {
    return 0.0;
  }
  /// Writes field[i] for the points begin <= i < end. The line runs where the field has a level,
  /// the side of higher values on its left (either way where the field has axes).
  virtual void EvaluateField(const npr::LineSurface& surface, const npr::LineView& view,
    vtkIdType begin, vtkIdType end, float* field) const;
  /// Writes 1 or -1 where the field is positive (negative) in every view, else 0. Triangles whose
  /// three points agree are never looked at. Only for fields without axes whose one level is 0.
  virtual void BoundField(
    const npr::LineSurface& surface, vtkIdType begin, vtkIdType end, signed char* sign) const;
  /// Where a line may be: only where n.v, the cosine of the angle between the normal and the
  /// direction of the eye, is in this range somewhere in the triangle. Triangles whose points are
  /// all outside need not be looked at. Default is everywhere.
  virtual std::array<float, 2> GetFacingRange() const
  {
    return { -1.0f, 1.0f };
  }
  /// The arrays that EvaluateSlopes() needs, loaded where the input has them and slopes are wanted;
  /// none where slopes are not known.
  virtual std::vector<RequiredArray> GetSlopeArrays() const
  {
    return {};
  }
  /// Writes how fast the field changes at both ends of the edges from[i] to[i], i < count, per
  /// length of the edge: its derivatives along to - from on the surface that the points are of, not
  /// along the chord.
  virtual void EvaluateSlopes(const npr::LineSurface& surface, const npr::LineView& view,
    const Index* from, const Index* to, vtkIdType count, float* atFrom, float* atTo) const;
  /// Whether the line also runs where the field jumps: along split edges on whose sides its signs
  /// differ, and along borders.
  virtual bool FollowsJumps() const
  {
    return false;
  }
  /// The required array of unit vectors that the field's sign belongs to, so that vector and value
  /// may be turned over together at any point (see npr::FieldAxes; it also needs the normals). Null
  /// for a field with one value.
  virtual const char* GetAxes() const
  {
    return nullptr;
  }
  /// Whether the field keeps its sign when its axis is turned over. Then axes only keep lines away
  /// from where they are not comparable.
  virtual bool HasEvenField() const
  {
    return false;
  }
  /// Whether the field has axes that change with the view: EvaluateFieldAndAxes() is called instead
  /// of EvaluateField(), and there are no GetAxes().
  virtual bool HasViewAxes() const
  {
    return false;
  }
  /// Writes field[i], and Axis and Bound of points[i], for the points begin <= i < end, all at
  /// once, for they are mostly made together. Axes are unit vectors in the tangent plane, 0 where
  /// there is none. A bound is > 0 where the test may be, as far as is known without its fall: a
  /// triangle without is not looked at.
  virtual void EvaluateFieldAndAxes(const npr::LineSurface& surface, const npr::LineView& view,
    vtkIdType begin, vtkIdType end, float* field, npr::AxisPoint* points) const;
  /// Whether the field is the derivative along its axes of something that has a maximum on the
  /// line, so that EvaluateTest() is to be given its fall.
  virtual bool IsMaximum() const
  {
    return false;
  }
  virtual bool HasTest() const
  {
    return false;
  }
  /// Writes test[i] for points[i], i < count. The line is accepted where the test is > 0, and its
  /// strength rises smoothly from 0 there to 1 where the test is 1 or more. fall[i] is how fast the
  /// field falls there along its axis, in its unit / length; null unless IsMaximum().
  virtual void EvaluateTest(const npr::LineSurface& surface, const npr::LineView& view,
    const Index* points, vtkIdType count, const float* fall, float* test) const;
  ///@}

  /// @name Edge part
  ///@{
  virtual EdgeKind GetEdges() const
  {
    return NoEdges;
  }
  /// Writes strength[i - begin] for the edges begin <= i < end; 0 leaves an edge out. The line runs
  /// as the edge's first half-edge does, or where the strength is negative, the other way. Must be
  /// safe to call from several threads at a time.
  virtual void EvaluateEdges(const npr::LineSurface& surface, const npr::LineView& view,
    const npr::EdgeList& edges, vtkIdType begin, vtkIdType end, float* strength) const;
  /// Whether edges follow from a value of each triangle that only the view decides: then
  /// EvaluateTriangles() is called once a view, and CompareTriangles() instead of EvaluateEdges().
  virtual bool ComparesTriangles() const
  {
    return false;
  }
  /// Writes values[t] for the triangles begin <= t < end. Must be safe to call from several threads
  /// at a time.
  virtual void EvaluateTriangles(const npr::LineSurface& surface, const npr::LineView& view,
    vtkIdType begin, vtkIdType end, signed char* values) const;
  /// What BoundTriangles() says where triangles may have several values.
  static constexpr signed char MixedTriangles = -1;
  /// The value that EvaluateTriangles() finds for all triangles whose planes are within bounds.
  /// Edges between triangles of one value that is found so are not looked at: CompareTriangles()
  /// must leave them out.
  virtual signed char BoundTriangles(const npr::PlaneBounds&, const npr::LineView&) const
  {
    return MixedTriangles;
  }
  /// As EvaluateEdges(); values are those of all triangles.
  virtual void CompareTriangles(const npr::LineSurface& surface, const npr::EdgeList& edges,
    vtkIdType begin, vtkIdType end, const signed char* values, float* strength) const;
  /// Accepted edges that hang together are left out as noise when they are fewer than this; each of
  /// their points at a border counts as one more.
  virtual double GetLeastRow() const
  {
    return 1.0;
  }
  ///@}
#endif

protected:
  vtkNPRLineDefinition() = default;
  ~vtkNPRLineDefinition() override = default;

  /// @name Makes a member a parameter that can be set by its name
  /// Names and descriptions must be literals.
  ///@{
  void AddParameter(
    const char* name, const char* description, double& value, double minimum, double maximum);
  void AddParameter(
    const char* name, const char* description, double (&values)[3], double minimum, double maximum);
  void AddParameter(const char* name, const char* description, std::vector<double>& values,
    double minimum, double maximum);
  void AddTextParameter(const char* name, const char* description, std::string& text);
  ///@}

private:
  struct Parameter
  {
    const char* Name;
    const char* Description;
    double* Values; // null for a list or a text
    int Size;
    double Minimum;
    double Maximum;
    std::vector<double>* List;
    std::string* Text;
    std::vector<double> GetNumbers() const;
  };
  const Parameter* FindParameter(const char* name) const;
  std::vector<Parameter> Parameters;

  vtkNPRLineDefinition(const vtkNPRLineDefinition&) = delete;
  void operator=(const vtkNPRLineDefinition&) = delete;
};

#endif
