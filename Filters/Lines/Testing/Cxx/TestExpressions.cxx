// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// The language of expressions: what is refused, at which column; what conditions become; that a
// formula has the bits that C++ gives it.
#include "nprExpression.h"
#include "nprLineTesting.h"

#include <cmath>
#include <limits>
#include <random>

using namespace nprtest;
using npr::Expression;

namespace
{
void CheckRefused(Checks& check, const std::string& text, int column, const char* word)
{
  const std::string problem = Expression::FindProblem(text, Expression::Condition);
  const std::string place = "column " + std::to_string(column) + ":";
  check(problem.compare(0, place.size(), place) == 0 && Contains(problem, word),
    (text.substr(0, 40) + " is refused, not: " + problem).c_str());
}

void TestRefused(Checks& check)
{
  CheckRefused(check, "", 1, "Empty");
  CheckRefused(check, "kr +", 5, "end of expression");
  CheckRefused(check, "sin(kr", 4, "bracket");
  CheckRefused(check, "kr)", 3, "bracket");
  CheckRefused(check, "min(kr,)", 7, "','");
  CheckRefused(check, "kr $ 2", 4, "'$' belongs to no number");
  CheckRefused(check, "2 * \xC3\xA4", 5, "'\xC3\xA4' belongs to no number");
  CheckRefused(check, "# kr", 1, "'#'");
  CheckRefused(check, "k1 k2", 4, "");
  CheckRefused(check, "3 k2", 3, "");
  CheckRefused(check, "kr := 2", 4, "':='");
  CheckRefused(check, "kr; kr", 3, "';'");
  CheckRefused(check, "kr[0]", 3, "'['");
  CheckRefused(check, "{kr}", 1, "'{'");
  CheckRefused(check, "'kr'", 1, "");
  CheckRefused(check, "kr + while", 6, "'while' is a reserved word");
  CheckRefused(check, "var x", 1, "'var' is a reserved word");
  CheckRefused(check, "a.b", 1, "'a.b' is no name");
  CheckRefused(check, "kr > 0 && K > 0", 8, "write and");
  CheckRefused(check, "kr > 0 || K > 0", 8, "write or");
  CheckRefused(check, "0 < kr < 1", 8, "comparisons in a row");
  CheckRefused(check, "K > 0 and (0 < kr < 1)", 19, "comparisons in a row");
  CheckRefused(check, "sin kr", 5, "'('");
  CheckRefused(check, std::string(20000, 'k'), 10001, "too long");
  CheckRefused(check, std::string(900, '(') + "kr" + std::string(900, ')'), 1803, "depth");
  std::string many = "kr > 0";
  for (int i = 0; i < 900; ++i)
  {
    many += " & kr > 0";
  }
  CheckRefused(check, many, 1, "too many parts");

  for (const char* text :
    { "kr", "K > 0 and H < 1 or not(kr > 0)", "a ? b : c", "if(a > 0, b, c)", "-kr^2 % 3e-2",
      "Wall_thickness_0 * pi", "0 < a and a < 1", "(a > 0) == (b > 0)", "min(a, b, c) <= 2" })
  {
    const std::string problem = Expression::FindProblem(text, Expression::Condition);
    check(problem.empty(), (text + std::string(" is an expression: ") + problem).c_str());
  }
  const std::vector<std::string> names =
    Expression::GetNames("sin(k) + K * k - 2e5 > if(a, pi, 3)");
  check(names == std::vector<std::string>{ "k", "K", "a" }, "names, told apart by their case");
  check(Expression::GetColumn("kr + krr * kr", "krr") == 6, "the column of a name");
  check(Expression::IsReserved("sin") && Expression::IsReserved("for") &&
      Expression::IsReserved("pi") && !Expression::IsReserved("Sin") &&
      !Expression::IsReserved("kr"),
    "reserved words");
}

double Evaluate(const char* text, Expression::Meaning meaning, double a, double b)
{
  Expression expression(text, meaning, 2.0, { "a", "b" }, { { "two", 2.0 } });
  const double* columns[] = { &a, &b };
  double value;
  expression.Evaluate(columns, 1, &value);
  return value;
}

void TestConditions(Checks& check)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto is = [&](const char* text, double a, double b, double expected)
  {
    const double value = Evaluate(text, Expression::Condition, a, b);
    check(value == expected || (std::isnan(value) && std::isnan(expected)), text, value);
  };
  is("a > b", 5.0, 1.0, 2.0);
  is("a >= b", 5.0, 1.0, 2.0);
  is("a < b", 5.0, 1.0, -2.0);
  is("a <= b + 1", 5.0, 1.0, -1.5);
  is("a > b and a < 6", 5.0, 1.0, 0.5);
  is("a > b & a < 6", 5.0, 1.0, 0.5);
  is("(a > b) and (a < 6)", 5.0, 1.0, 0.5);
  is("((a > b and (a < 6)))", 5.0, 1.0, 0.5);
  is("a > b or a < 6", 5.0, 1.0, 2.0);
  is("a > 9 and b > 0 or a < 6", 5.0, 1.0, 0.5);
  is("a > two", 5.0, 1.0, 1.5);
  is("a", 5.0, 1.0, 5.0);
  is("a > b and b", 5.0, 1.0, 1.0);
  is("a == 5", 5.0, 1.0, 1.0);
  is("not(a > b)", 5.0, 1.0, 0.0);
  is("a > b ? 7 : 8", 5.0, 1.0, 7.0);
  is("(a > b) * 3", 5.0, 1.0, 3.0);
  is("(a) > (b)", 5.0, 1.0, 2.0);
  is("a > b xor b > a", 5.0, 1.0, 1.0);
  for (const char* text :
    { "a > 0 and b > 0", "b > 0 and a > 0", "a > 0 or b > 0", "b > 0 or a > 0" })
  {
    is(text, nan, 1.0, nan);
  }
  check(Evaluate("a > b", Expression::Value, 5.0, 1.0) == 1.0, "a value is not made a margin");
}

// What vtkNPRSuggestiveContours says, and C++ does, with thresholds of many digits.
void TestBits(Checks& check)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-3.0, 3.0);
  for (int round = 0; round < 50; ++round)
  {
    const double threshold = std::abs(number(random));
    const double fade = 0.01 + std::abs(number(random));
    char text[100];
    std::snprintf(
      text, sizeof(text), "min((a - %.17g) * b / %.17g, (b - two) / two)", threshold, fade);
    Expression expression(text, Expression::Condition, 1.0, { "a", "b" }, { { "two", 0.2 } });
    std::vector<double> a(100);
    std::vector<double> b(100);
    std::generate(a.begin(), a.end(), [&] { return number(random); });
    std::generate(b.begin(), b.end(), [&] { return number(random); });
    const double* columns[] = { a.data(), b.data() };
    std::vector<double> values(100);
    expression.Evaluate(columns, 100, values.data());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      check(values[i] == std::min((a[i] - threshold) * b[i] / fade, (b[i] - 0.2) / 0.2),
        "an expression has the bits of C++", values[i]);
    }
  }
}
}

int TestExpressions(int, char*[])
{
  Checks check;
  TestRefused(check);
  TestConditions(check);
  TestBits(check);
  return check.GetResult();
}
