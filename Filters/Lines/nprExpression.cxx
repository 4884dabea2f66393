// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprExpression.h"

#include <algorithm>
#include <locale>
#include <set>
#include <sstream>
#include <utility>

// ExprTk stands in this file alone, for it takes long to compile. Without enhanced features it does
// not rearrange formulas, so they are computed as they are written, to the last bit. VTK calls the
// namespace vtkexprtk, and has the same templates compiled with other settings; ours needs a name
// of its own.
#define exprtk_disable_caseinsensitivity
#define exprtk_disable_comments
#define exprtk_disable_enhanced_features
#define exprtk_disable_return_statement
#define exprtk_disable_rtl_io
#define exprtk_disable_rtl_io_file
#define exprtk_disable_rtl_vecops
#define exprtk_disable_string_capabilities
#define exprtk_disable_superscalar_unroll
#define vtkexprtk nprExprtk
#include <vtk_exprtk.h>

namespace npr
{
namespace
{
namespace et = nprExprtk;
using Token = et::lexer::token;

constexpr std::size_t LongestText = 10000;
constexpr const char* Least = "npr.least"; // no name that a text can have: of the points in it
constexpr const char* Greatest = "npr.greatest";
constexpr const char* Fade = "npr.fade";
constexpr const char* Number = "npr.number"; // and its index

const std::vector<std::string>& GetFunctionList()
{
  static const std::vector<std::string> functions = { "abs", "acos", "acosh", "asin", "asinh",
    "atan", "atan2", "atanh", "avg", "ceil", "clamp", "cos", "cosh", "cot", "csc", "deg2rad", "erf",
    "erfc", "exp", "expm1", "floor", "frac", "hypot", "if", "inrange", "log", "log10", "log1p",
    "log2", "logn", "max", "min", "mod", "mul", "ncdf", "pow", "rad2deg", "root", "round", "roundn",
    "sec", "sgn", "sin", "sinc", "sinh", "sqrt", "sum", "tan", "tanh", "trunc" };
  return functions;
}

const std::set<std::string>& GetWords()
{
  static const std::set<std::string> words = { "and", "or", "not", "nand", "nor", "xor", "xnor",
    "true", "false", "pi", "&", "|" };
  return words;
}

bool IsOfLanguage(const std::string& symbol)
{
  const std::vector<std::string>& functions = GetFunctionList();
  return GetWords().count(symbol) > 0 ||
    std::find(functions.begin(), functions.end(), symbol) != functions.end();
}

std::string At(std::size_t position, const std::string& what)
{
  return "column " + std::to_string(position + 1) + ": " + what;
}

using Tokens = std::vector<Token>;

// False when a character belongs to nothing; it is then the last token.
bool Split(const std::string& text, Tokens& tokens)
{
  et::lexer::generator generator;
  const bool good = generator.process(text);
  for (std::size_t i = 0; i < generator.size(); ++i)
  {
    tokens.push_back(generator[i]);
  }
  return good;
}

bool IsOrder(const Token& token)
{
  return token.type == Token::e_lt || token.type == Token::e_lte || token.type == Token::e_gt ||
    token.type == Token::e_gte;
}

bool IsComparison(const Token& token)
{
  return IsOrder(token) || token.type == Token::e_eq || token.type == Token::e_ne;
}

bool IsWord(const Token& token, const char* word, const char* sign)
{
  return token.type == Token::e_symbol && (token.value == word || token.value == sign);
}

bool IsAnd(const Token& token)
{
  return IsWord(token, "and", "&");
}

bool IsOr(const Token& token)
{
  return IsWord(token, "or", "|");
}

bool IsOtherLogic(const Token& token)
{
  return IsWord(token, "nand", "nor") || IsWord(token, "xor", "xnor") ||
    token.type == Token::e_ternary || token.type == Token::e_colon || token.type == Token::e_comma;
}

bool Opens(const Token& token)
{
  return token.type == Token::e_lbracket;
}

bool Closes(const Token& token)
{
  return token.type == Token::e_rbracket;
}

bool IsAllowed(const Token& token)
{
  switch (token.type)
  {
    case Token::e_number:
    case Token::e_symbol:
    case Token::e_lbracket:
    case Token::e_rbracket:
    case Token::e_comma:
    case Token::e_add:
    case Token::e_sub:
    case Token::e_mul:
    case Token::e_div:
    case Token::e_mod:
    case Token::e_pow:
    case Token::e_ternary:
    case Token::e_colon:
      return true;
    default:
      return IsComparison(token);
  }
}

// With all its bytes.
std::string GetCharacter(const std::string& text, std::size_t position)
{
  std::size_t end = position + 1;
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80)
  {
    ++end;
  }
  return text.substr(position, end - position);
}

// What each token may be, without what they are together.
std::string FindWrongToken(const std::string& text, const Tokens& tokens)
{
  for (const Token& token : tokens)
  {
    if (token.is_error())
    {
      return At(token.position,
        "'" + GetCharacter(text, token.position) + "' belongs to no number, name or operator");
    }
    const std::string value =
      text.substr(token.position, std::max<std::size_t>(1, token.value.size()));
    if (!IsAllowed(token))
    {
      return At(token.position,
        "'" + value + "' has no place in an expression, which changes and repeats nothing");
    }
    if ((value == "&" || value == "|") && text.compare(token.position + 1, 1, value) == 0)
    {
      return At(token.position, "write " + std::string(value == "&" ? "and" : "or"));
    }
    if (token.type == Token::e_symbol && !IsOfLanguage(token.value))
    {
      if (et::details::is_reserved_symbol(token.value))
      {
        return At(token.position, "'" + value + "' is a reserved word that has no meaning here");
      }
      if (!Expression::IsName(token.value))
      {
        return At(
          token.position, "'" + value + "' is no name: a letter, then letters, digits and _");
      }
    }
  }
  return {};
}

// Comparisons in a row, which mean something else than people think.
std::string FindRow(const Tokens& tokens)
{
  std::vector<int> comparisons = { 0 };
  for (const Token& token : tokens)
  {
    if (Opens(token))
    {
      comparisons.push_back(0);
    }
    else if (Closes(token) && comparisons.size() > 1)
    {
      comparisons.pop_back();
    }
    else if (IsAnd(token) || IsOr(token) || IsOtherLogic(token))
    {
      comparisons.back() = 0;
    }
    else if (IsComparison(token) && ++comparisons.back() > 1)
    {
      return At(token.position, "two comparisons in a row; write (a < b) and (b < c)");
    }
  }
  return {};
}

// The library rounds numbers carelessly. So they become names, of constants that are rounded well.
std::string TakeNumbers(const std::string& text, Expression::Constants& numbers)
{
  Tokens tokens;
  Split(text, tokens);
  std::string result;
  std::size_t last = 0;
  for (const Token& token : tokens)
  {
    if (token.type == Token::e_number)
    {
      const std::string name = Number + std::to_string(numbers.size());
      std::istringstream stream(token.value);
      stream.imbue(std::locale::classic());
      stream >> numbers[name];
      result += text.substr(last, token.position - last) + name;
      last = token.position + token.value.size();
    }
  }
  return result + text.substr(last);
}

// The text between two tokens of it, the second not included.
class Range
{
public:
  Range(const std::string& text, const Tokens& tokens)
    : Text(text), All(tokens), First(0), Last(tokens.size())
  {
  }

  std::string GetText() const
  {
    const std::size_t from = this->First == 0 ? 0 : this->All[this->First].position;
    const std::size_t to =
      this->Last == this->All.size() ? this->Text.size() : this->All[this->Last].position;
    return this->Text.substr(from, to - from);
  }

  /// What becomes of a condition: a formula that is > 0 where it holds.
  std::string GetMargin() const
  {
    if (this->FindOuter(IsOtherLogic) < this->Last)
    {
      return this->GetText();
    }
    for (const auto& [separates, function] :
      { std::make_pair(&IsOr, Greatest), std::make_pair(&IsAnd, Least) })
    {
      const std::size_t place = this->FindOuter(*separates);
      if (place < this->Last)
      {
        return std::string(function) + "(" + this->GetPart(this->First, place).GetMargin() + ", " +
          this->GetPart(place + 1, this->Last).GetMargin() + ")";
      }
    }
    if (this->IsInBrackets())
    {
      return this->GetPart(this->First + 1, this->Last - 1).GetMargin();
    }
    const std::size_t place = this->FindOuter(IsOrder);
    if (place == this->Last || IsWord(this->All[this->First], "not", "not"))
    {
      return "(" + this->GetText() + ")";
    }
    std::string low = "(" + this->GetPart(this->First, place).GetText() + ")";
    std::string high = "(" + this->GetPart(place + 1, this->Last).GetText() + ")";
    if (this->All[place].type == Token::e_gt || this->All[place].type == Token::e_gte)
    {
      std::swap(low, high);
    }
    return "((" + high + " - " + low + ") / " + Fade + ")";
  }

private:
  Range GetPart(std::size_t first, std::size_t last) const
  {
    Range part = *this;
    part.First = first;
    part.Last = last;
    return part;
  }

  /// The first token of the kind outside all brackets; Last when there is none.
  template<typename Kind>
  std::size_t FindOuter(const Kind& isOfKind) const
  {
    int depth = 0;
    for (std::size_t i = this->First; i < this->Last; ++i)
    {
      if (depth == 0 && isOfKind(this->All[i]))
      {
        return i;
      }
      depth += Opens(this->All[i]) - Closes(this->All[i]);
    }
    return this->Last;
  }

  bool IsInBrackets() const
  {
    int depth = 0;
    for (std::size_t i = this->First; i + 1 < this->Last; ++i)
    {
      depth += Opens(this->All[i]) - Closes(this->All[i]);
      if (depth == 0)
      {
        return false;
      }
    }
    return this->Last > this->First + 1;
  }

  const std::string& Text;
  const Tokens& All;
  std::size_t First;
  std::size_t Last;
};

// The extreme of two numbers; unlike std::min a NaN stays, wherever it stands.
template<bool Lesser>
struct Extreme : et::ifunction<double>
{
  Extreme() : et::ifunction<double>(2) {}
  double operator()(const double& a, const double& b) override
  {
    const bool first = Lesser ? a < b : a > b;
    return first || a != a ? a : b;
  }
};
}

class Expression::Internals
{
public:
  std::vector<double> Current; // the variables, where the formula reads them
  Extreme<true> LeastFunction;
  Extreme<false> GreatestFunction;
  et::symbol_table<double> Symbols;
  et::expression<double> Formula;

  Internals(const std::vector<std::string>& variables, const Constants& constants, double fade)
    : Current(variables.size())
  {
    for (std::size_t i = 0; i < variables.size(); ++i)
    {
      this->Symbols.add_variable(variables[i], this->Current[i]);
    }
    for (const auto& [name, value] : constants)
    {
      this->Symbols.add_constant(name, value);
    }
    this->Symbols.add_constant(Fade, fade);
    this->Symbols.add_pi();
    this->Symbols.add_function(Least, this->LeastFunction);
    this->Symbols.add_function(Greatest, this->GreatestFunction);
  }

  /// The problem, or nothing.
  std::string Compile(const std::string& text)
  {
    this->Formula.register_symbol_table(this->Symbols);
    // Without the check that makes "a b" a product.
    using Settings = et::parser<double>::settings_store;
    et::parser<double> parser(Settings(Settings::compile_all_opts - Settings::e_commutative_check));
    if (parser.compile(text, this->Formula))
    {
      return {};
    }
    if (parser.error_count() == 0)
    {
      return At(0, "there is no expression");
    }
    const auto error = parser.get_error(0);
    // The library's own numbers of errors say nothing to people.
    const std::size_t dash = error.diagnostic.find(" - ");
    std::string what = error.diagnostic.substr(dash == std::string::npos ? 0 : dash + 3);
    what.erase(std::min(what.size(), what.find('[')));
    return At(std::min(error.token.position, text.size()), what);
  }

  std::string CompileMargin(const std::string& condition)
  {
    Tokens tokens;
    Split(condition, tokens);
    // What is wrong with the condition itself is known by now.
    return this->Compile(Range(condition, tokens).GetMargin()).empty()
      ? std::string()
      : At(0, "the condition has too many parts");
  }
};

//------------------------------------------------------------------------------
std::vector<std::string> Expression::GetFunctions()
{
  return GetFunctionList();
}

//------------------------------------------------------------------------------
bool Expression::IsReserved(const std::string& name)
{
  return IsOfLanguage(name) || et::details::is_reserved_symbol(name);
}

//------------------------------------------------------------------------------
bool Expression::IsName(const std::string& text)
{
  return !text.empty() && et::details::is_letter(text[0]) &&
    std::all_of(text.begin(), text.end(),
      [](char c) { return et::details::is_letter_or_digit(c) || c == '_'; });
}

//------------------------------------------------------------------------------
std::vector<std::string> Expression::GetNames(const std::string& text)
{
  Tokens tokens;
  Split(text, tokens);
  std::vector<std::string> names;
  for (const Token& token : tokens)
  {
    if (token.type == Token::e_symbol && !IsReserved(token.value) &&
      std::find(names.begin(), names.end(), token.value) == names.end())
    {
      names.push_back(token.value);
    }
  }
  return names;
}

//------------------------------------------------------------------------------
int Expression::GetColumn(const std::string& text, const std::string& name)
{
  Tokens tokens;
  Split(text, tokens);
  const auto found = std::find_if(tokens.begin(), tokens.end(),
    [&](const Token& token) { return token.type == Token::e_symbol && token.value == name; });
  return found == tokens.end() ? 1 : static_cast<int>(found->position) + 1;
}

//------------------------------------------------------------------------------
std::string Expression::FindProblem(const std::string& text, Meaning meaning)
{
  if (text.size() > LongestText)
  {
    return At(LongestText, "the expression is too long");
  }
  Tokens tokens;
  Split(text, tokens);
  std::string problem = FindWrongToken(text, tokens);
  if (problem.empty())
  {
    problem = FindRow(tokens);
  }
  if (problem.empty())
  {
    problem = Internals(GetNames(text), {}, 1.0).Compile(text);
  }
  if (problem.empty() && meaning == Condition)
  {
    problem = Internals(GetNames(text), {}, 1.0).CompileMargin(text);
  }
  return problem;
}

//------------------------------------------------------------------------------
Expression::Expression(const std::string& text, Meaning meaning, double fade,
  const std::vector<std::string>& variables, const Constants& constants)
{
  Constants all = constants;
  const std::string named = TakeNumbers(text, all);
  this->Internal = std::make_unique<Internals>(variables, all, fade);
  meaning == Value ? this->Internal->Compile(named) : this->Internal->CompileMargin(named);
}

//------------------------------------------------------------------------------
Expression::~Expression() = default;

//------------------------------------------------------------------------------
void Expression::Evaluate(const double* const* columns, vtkIdType count, double* values)
{
  std::vector<double>& current = this->Internal->Current;
  for (vtkIdType i = 0; i < count; ++i)
  {
    for (std::size_t c = 0; c < current.size(); ++c)
    {
      current[c] = columns[c][i];
    }
    values[i] = this->Internal->Formula.value();
  }
}
}
