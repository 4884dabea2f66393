// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprLineFormula_h
#define nprLineFormula_h

#include "nprExpression.h"
#include "nprViewQuantities.h"
#include "vtkNPRFiltersLinesModule.h"

#include <memory>
#include <mutex>
#include <string>
#include <vector>

class vtkPointData;

namespace npr
{
/**
 * @class LineNames
 * @brief All names that a formula about lines may use, and what stands behind each.
 */
class VTKNPRFILTERSLINES_EXPORT LineNames
{
public:
  /// What a name is: a component of a quantity, or of a point array.
  struct Meaning
  {
    std::string Name;
    const ViewQuantity* Quantity; ///< Null for an array.
    std::string Array;
    int Components;
    int Component;
    bool operator==(const Meaning& other) const;
    bool operator!=(const Meaning& other) const { return !(*this == other); }
  };

  /// The quantities alone, or with the arrays of an input.
  LineNames();
  explicit LineNames(vtkPointData* arrays);

  /// Null when the name means nothing.
  const Meaning* Find(const std::string& name) const;
  /// All names, for a message.
  std::string Describe() const;

private:
  void AddArray(const std::string& array, const std::string& name, int components);

  std::vector<Meaning> Meanings;
};

/**
 * @class LineFormula
 * @brief An expression over the points of a surface, evaluated by several threads at a time.
 */
class VTKNPRFILTERSLINES_EXPORT LineFormula
{
public:
  using Index = TriangleMesh::Index;

  /// All names of the text are among the variables or the constants.
  LineFormula(const std::string& text, Expression::Meaning meaning, double fade,
    std::vector<LineNames::Meaning> variables, Expression::Constants constants);

  const std::vector<LineNames::Meaning>& GetVariables() const { return this->Variables; }

  /// Where the result is not a finite number, the point is remembered.
  void Evaluate(
    const LineSurface& surface, const LineView& view, const PointSpan& points, float* values);

  /// The points where the results were no finite numbers, in ascending order, since the last call.
  std::vector<Index> TakeUndefinedPoints();

private:
  std::unique_ptr<Expression> TakeExpression();

  const std::string Text;
  const Expression::Meaning Meaning;
  const double Fade;
  const std::vector<LineNames::Meaning> Variables;
  const Expression::Constants Constants;

  std::mutex Mutex;                              // of what follows
  std::vector<std::unique_ptr<Expression>> Idle; // one is needed for each thread
  std::vector<Index> Undefined;
};
}

#endif
