// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprEdgePieces.h"

#include "vtkNPRLineDefinition.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;

// Large enough that a virtual call a block costs nothing, small enough to balance the threads.
constexpr vtkIdType EdgesOfBlock = 4096;
constexpr vtkIdType RowsOfBlock = 64;
// Few enough that most rows are on one side of the outline.
constexpr Index TrianglesOfRow = 32;

// Appends what add(begin, end, pieces) finds, in the order of the elements.
template<typename Add>
void AddInBlocks(
  vtkIdType size, vtkIdType sizeOfBlock, std::vector<LinePiece>& pieces, const Add& add)
{
  std::vector<std::vector<LinePiece>> blocks((size + sizeOfBlock - 1) / sizeOfBlock);
  vtkSMPTools::For(0, static_cast<vtkIdType>(blocks.size()), 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType block = first; block < last; ++block)
      {
        add(static_cast<Index>(block * sizeOfBlock),
          static_cast<Index>(std::min(size, (block + 1) * sizeOfBlock)), blocks[block]);
      }
    });
  for (const std::vector<LinePiece>& block : blocks)
  {
    pieces.insert(pieces.end(), block.begin(), block.end());
  }
}

// Takes out what is for other pieces of the surface to draw.
void DropOthers(const LineSurface& surface, std::vector<LinePiece>& pieces)
{
  if (surface.HasGhosts())
  {
    pieces.erase(std::remove_if(pieces.begin(), pieces.end(),
                   [&surface](const LinePiece& piece)
                   { return !surface.IsOwned(piece.Sides, piece.SidesEnd); }),
      pieces.end());
  }
}

LinePiece GetWholeEdge(
  const LineSurface& surface, const Index* sides, const Index* sidesEnd, float strength)
{
  // In the direction of its first triangle, which is then on the left, or against it.
  const Index start = strength < 0.0f ? surface.GetEnd(*sides) : surface.GetStart(*sides);
  const Index stop = strength < 0.0f ? surface.GetStart(*sides) : surface.GetEnd(*sides);
  const float fromLow = start == surface.GetLowAndHigh(*sides)[0] ? 0.0f : 1.0f;
  return { sides, sidesEnd, { LineNode{ start, start, 0.0f }, LineNode{ stop, stop, 0.0f } },
    { LinePiece::NoHalfEdge, LinePiece::NoHalfEdge }, { fromLow, 1.0f - fromLow },
    std::abs(strength) };
}

// One side of a seam, which has a field of its own along it.
struct Side
{
  bool Forward;                 // the triangle runs from the low point to the high one
  std::array<bool, 2> Positive; // at low, at high
  std::size_t Change;           // the first interval after the change of sign
  bool IsPositive(std::size_t interval) const { return this->Positive[interval >= this->Change]; }
};

struct Place
{
  LineNode Node;
  Index HalfEdge;
  float FromLow;
  std::size_t Owner; // the side whose sign changes here
};

// Where the field is 0 on a half-edge that is crossed, with the same bits as in its triangle.
Place GetPlace(
  const LineSurface& surface, const FieldValues& values, Index halfEdge, std::size_t owner)
{
  Index from = surface.GetStart(halfEdge);
  Index to = surface.GetEnd(halfEdge);
  if (values[from] < 0.0f)
  {
    std::swap(from, to);
  }
  const double distance = std::abs(double(values[from]));
  const float t = static_cast<float>(distance / (distance + std::abs(double(values[to]))));
  return { { from, to, t }, t == 0.0f ? LinePiece::NoHalfEdge : halfEdge,
    from == surface.GetLowAndHigh(halfEdge)[0] ? t : 1.0f - t, owner };
}

void AddJumpPiecesOfEdge(const LineSurface& surface, const FieldValues& values, const Index* begin,
  const Index* end, std::vector<Side>& sides, std::vector<Place>& places,
  std::vector<LinePiece>& pieces)
{
  sides.clear();
  places.clear();
  for (const Index* h = begin; h != end; ++h)
  {
    const auto [low, high] = surface.GetLowAndHigh(*h);
    if (!std::isfinite(values[low]) || !std::isfinite(values[high]))
    {
      continue;
    }
    sides.push_back(
      { low == surface.GetStart(*h), { values[low] >= 0.0f, values[high] >= 0.0f }, 0 });
    if (sides.back().Positive[0] != sides.back().Positive[1])
    {
      places.push_back(GetPlace(surface, values, *h, sides.size() - 1));
    }
  }
  // Mostly there is one value on all of both sides.
  if (places.empty() &&
    std::all_of(sides.begin(), sides.end(),
      [&sides](const Side& side) { return side.Positive[0] == sides[0].Positive[0]; }))
  {
    return;
  }
  std::stable_sort(places.begin(), places.end(),
    [](const Place& a, const Place& b) { return a.FromLow < b.FromLow; });
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    sides[places[i].Owner].Change = i + 1;
  }
  const auto [low, high] = surface.GetLowAndHigh(*begin);
  places.insert(places.begin(), { { low, low, 0.0f }, LinePiece::NoHalfEdge, 0.0f, 0 });
  places.push_back({ { high, high, 0.0f }, LinePiece::NoHalfEdge, 1.0f, 0 });
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
  {
    const auto isPositive = [i](const Side& side) { return side.IsPositive(i); };
    const auto front = std::find_if(sides.begin(), sides.end(), isPositive);
    const bool mixed = front != sides.end() && !std::all_of(sides.begin(), sides.end(), isPositive);
    if (mixed &&
      GetKey(surface, places[i].Node, places[i].HalfEdge) !=
        GetKey(surface, places[i + 1].Node, places[i + 1].HalfEdge))
    {
      const Place& from = places[front->Forward ? i : i + 1];
      const Place& to = places[front->Forward ? i + 1 : i];
      pieces.push_back({ begin, end, { from.Node, to.Node }, { from.HalfEdge, to.HalfEdge },
        { from.FromLow, to.FromLow }, 1.0f });
    }
  }
}
}

//------------------------------------------------------------------------------
void AddJumpPieces(
  const LineSurface& surface, const FieldValues& values, std::vector<LinePiece>& pieces)
{
  const EdgeList& seams = surface.GetSeams();
  std::vector<LinePiece> found;
  AddInBlocks(seams.GetNumberOfEdges(), EdgesOfBlock, found,
    [&](Index first, Index last, std::vector<LinePiece>& jumps)
    {
      std::vector<Side> sides;
      std::vector<Place> places;
      for (Index edge = first; edge < last; ++edge)
      {
        const Index* begin = seams.Begin(edge);
        const Index* end = seams.End(edge);
        if (end - begin == 1)
        {
          // Nothing is on the other side of a border, so the line runs along all of it.
          jumps.push_back(GetWholeEdge(surface, begin, end, 1.0f));
        }
        else
        {
          AddJumpPiecesOfEdge(surface, values, begin, end, sides, places, jumps);
        }
      }
    });
  DropOthers(surface, found);
  pieces.insert(pieces.end(), found.begin(), found.end());
}

//------------------------------------------------------------------------------
EdgePieces::EdgePieces(const LineSurface& surface, const vtkNPRLineDefinition& definition)
  : Surface(surface), Definition(definition), Fans(surface)
{
  if (definition.ComparesTriangles())
  {
    this->BuildRows();
  }
}

//------------------------------------------------------------------------------
void EdgePieces::BuildRows()
{
  const TriangleMesh& mesh = this->Surface.GetMesh();
  const EdgeList& edges = this->Surface.GetInnerEdges();
  const Index size = mesh.GetNumberOfTriangles();
  this->Values.resize(size);
  this->Rows.reserve((size + TrianglesOfRow - 1) / TrianglesOfRow);
  this->RowValues.resize(this->Rows.capacity());
  Index edge = 0;
  for (Index begin = 0; begin < size; begin += TrianglesOfRow)
  {
    const Index end = std::min(size, begin + TrianglesOfRow);
    const auto first = static_cast<std::ptrdiff_t>(this->Neighbours.size());
    for (; edge < edges.GetNumberOfEdges() && *edges.Begin(edge) < 3 * end; ++edge)
    {
      const Index row = edges.Begin(edge)[1] / 3 / TrianglesOfRow;
      if (std::find(this->Neighbours.begin() + first, this->Neighbours.end(), row) ==
        this->Neighbours.end())
      {
        this->Neighbours.push_back(row);
      }
    }
    this->Rows.push_back({ PlaneBounds(mesh, begin, end), edge, this->Neighbours.size() });
  }
}

//------------------------------------------------------------------------------
void EdgePieces::EvaluateTriangles(const LineView& view)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Rows.size()), RowsOfBlock,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType row = first; row < last; ++row)
      {
        const vtkIdType begin = row * TrianglesOfRow;
        const vtkIdType end =
          std::min(begin + TrianglesOfRow, static_cast<vtkIdType>(this->Values.size()));
        const signed char value = this->Definition.BoundTriangles(this->Rows[row].Planes, view);
        this->RowValues[row] = value;
        if (value == vtkNPRLineDefinition::MixedTriangles)
        {
          this->Definition.EvaluateTriangles(this->Surface, view, begin, end, this->Values.data());
        }
        else
        {
          std::fill(this->Values.begin() + begin, this->Values.begin() + end, value);
        }
      }
    });
}

//------------------------------------------------------------------------------
// Whether the triangles of a row and those beyond its edges are all known to have one value.
bool EdgePieces::HasOneValue(Index row) const
{
  const signed char value = this->RowValues[row];
  const auto begin = this->Neighbours.begin() + (row == 0 ? 0 : this->Rows[row - 1].NeighboursEnd);
  return value != vtkNPRLineDefinition::MixedTriangles &&
    std::all_of(begin, this->Neighbours.begin() + this->Rows[row].NeighboursEnd,
      [&](Index neighbour) { return this->RowValues[neighbour] == value; });
}

//------------------------------------------------------------------------------
void EdgePieces::AddSpan(const LineView& view, const EdgeList& edges, Index begin, Index end,
  std::vector<LinePiece>& accepted) const
{
  std::array<float, EdgesOfBlock> strength;
  std::fill_n(strength.begin(), end - begin, 0.0f);
  if (this->Definition.ComparesTriangles())
  {
    this->Definition.CompareTriangles(
      this->Surface, edges, begin, end, this->Values.data(), strength.data());
  }
  else
  {
    this->Definition.EvaluateEdges(this->Surface, view, edges, begin, end, strength.data());
  }
  for (Index edge = begin; edge < end; ++edge)
  {
    // False where the strength is not a number.
    if (std::abs(strength[edge - begin]) > 0.0f)
    {
      accepted.push_back(
        GetWholeEdge(this->Surface, edges.Begin(edge), edges.End(edge), strength[edge - begin]));
    }
  }
}

//------------------------------------------------------------------------------
void EdgePieces::Add(const LineView& view, std::vector<LinePiece>& pieces)
{
  const vtkNPRLineDefinition::EdgeKind kind = this->Definition.GetEdges();
  if (kind == vtkNPRLineDefinition::NoEdges)
  {
    return;
  }
  this->EvaluateTriangles(view);
  this->Found.clear();
  const auto addAll = [&](const EdgeList& edges)
  {
    AddInBlocks(edges.GetNumberOfEdges(), EdgesOfBlock, this->Found,
      [&](Index begin, Index end, std::vector<LinePiece>& accepted)
      { this->AddSpan(view, edges, begin, end, accepted); });
  };
  addAll(this->Surface.GetSeams());
  if (kind == vtkNPRLineDefinition::AllEdges && this->Rows.empty())
  {
    addAll(this->Surface.GetInnerEdges());
  }
  else if (kind == vtkNPRLineDefinition::AllEdges)
  {
    AddInBlocks(static_cast<vtkIdType>(this->Rows.size()), RowsOfBlock, this->Found,
      [&](Index first, Index last, std::vector<LinePiece>& accepted)
      {
        for (Index row = first; row < last; ++row)
        {
          if (!this->HasOneValue(row))
          {
            this->AddSpan(view, this->Surface.GetInnerEdges(),
              row == 0 ? 0 : this->Rows[row - 1].EdgesEnd, this->Rows[row].EdgesEnd, accepted);
          }
        }
      });
  }
  if (this->Definition.GetLeastRow() > 1.0)
  {
    DropShortRows(this->Surface, this->Definition.GetLeastRow(), this->Found);
  }
  if (this->Definition.ComparesTriangles())
  {
    this->Fans.Join(this->Values, this->Found);
  }
  DropOthers(this->Surface, this->Found);
  pieces.insert(pieces.end(), this->Found.begin(), this->Found.end());
}
}
