// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprExpression_h
#define nprExpression_h

#include "vtkNPRFiltersLinesModule.h"

#include <vtkType.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace npr
{
/**
 * @class Expression
 * @brief A formula as a text, such as "kr" or "dwkr > 2 and ndotv > 0", over named numbers.
 *
 * Numbers, names, + - * / % ^, comparisons (< <= > >= == !=), and, or, not, a ? b : c, if(a, b, c),
 * parentheses, and the functions of GetFunctions(). Upper and lower case differ. It is ExprTk's
 * language without all that changes or repeats something. A name is a letter and then letters,
 * digits and underscores.
 *
 * An object may be used by one thread at a time.
 */
class VTKNPRFILTERSLINES_EXPORT Expression
{
public:
  using Constants = std::map<std::string, double>;

  /// What functions there are, as for a message.
  static std::vector<std::string> GetFunctions();
  /// Whether a name belongs to the language, so that nothing else can have it.
  static bool IsReserved(const std::string& name);
  static bool IsName(const std::string& text);

  /// The names in a text that do not belong to the language, each once.
  static std::vector<std::string> GetNames(const std::string& text);

  enum Meaning
  {
    Value,    ///< The text as it is.
    Condition ///< Comparisons become margins, see below.
  };

  /// What is wrong with a text, after its column, such as "column 3: ..."; empty when nothing is.
  /// Every name may be one that exists.
  static std::string FindProblem(const std::string& text, Meaning meaning);
  /// Where a name first stands in a text that has it, from 1 on.
  static int GetColumn(const std::string& text, const std::string& name);

  /**
   * The text must have no problem, and all its names must be variables or constants.
   *
   * A *condition* is a number > 0 where it holds. At its top level a comparison a > b becomes the
   * margin (a - b) / fade, so it knows how far it holds; `and` takes the least of its parts, `or`
   * the greatest. Equalities and all else stay as they are. A part that is not a number makes the
   * whole not a number.
   */
  Expression(const std::string& text, Meaning meaning, double fade,
    const std::vector<std::string>& variables, const Constants& constants);
  ~Expression();
  Expression(const Expression&) = delete;
  void operator=(const Expression&) = delete;

  /// values[i] for i < count, from columns[variable][i].
  void Evaluate(const double* const* columns, vtkIdType count, double* values);

private:
  class Internals;
  std::unique_ptr<Internals> Internal;
};
}

#endif
