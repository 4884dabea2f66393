// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprEdgeFans.h"

#include <algorithm>

namespace npr
{
//------------------------------------------------------------------------------
void EdgeFans::Join(const std::vector<signed char>& values, std::vector<LinePiece>& pieces)
{
  this->Counts.resize(this->Surface.GetMesh().GetNumberOfPoints(), 0);
  const auto getCount = [this](const LinePiece& piece, int end) -> unsigned char&
  { return this->Counts[this->Surface.GetWelded(piece.Nodes[end].From)]; };
  for (const LinePiece& piece : pieces)
  {
    for (int end = 0; end < 2; ++end)
    {
      unsigned char& count = getCount(piece, end);
      count = static_cast<unsigned char>(std::min(count + 1, 3));
    }
  }
  for (LinePiece& piece : pieces)
  {
    const bool starts = getCount(piece, 0) > 2;
    const bool stops = getCount(piece, 1) > 2;
    const Index side = starts || stops ? this->FindSide(values, piece) : None;
    if (side != None)
    {
      piece.HalfEdges[0] = starts ? side : None;
      piece.HalfEdges[1] = stops ? this->FindNext(values, side) : None;
    }
  }
  for (const LinePiece& piece : pieces)
  {
    getCount(piece, 0) = 0;
    getCount(piece, 1) = 0;
  }
}

//------------------------------------------------------------------------------
// The half-edge across which the fan of a half-edge goes on; none where it ends.
EdgeFans::Index EdgeFans::FindMatch(const std::vector<signed char>& values, Index halfEdge) const
{
  const LineSurface& surface = this->Surface;
  const signed char value = values[halfEdge / 3];
  const Index twin = surface.GetTwin(halfEdge);
  if (twin != LineSurface::NoTwin)
  {
    const bool isOpposite = surface.GetStart(twin) == surface.GetEnd(halfEdge);
    return isOpposite && values[twin / 3] == value ? twin : None;
  }
  const Index start = surface.GetWelded(surface.GetStart(halfEdge));
  const auto [begin, end] = surface.FindSeam(halfEdge);
  const auto isAlike = [&](Index side, bool forward)
  {
    return values[side / 3] == value &&
      (surface.GetWelded(surface.GetStart(side)) == start) == forward;
  };
  auto rank = std::count_if(
    begin, std::find(begin, end, halfEdge), [&](Index side) { return isAlike(side, true); });
  const Index* const match =
    std::find_if(begin, end, [&](Index side) { return isAlike(side, false) && rank-- == 0; });
  return match == end ? None : *match;
}

//------------------------------------------------------------------------------
// The half-edge that runs as the piece does and bounds a fan.
EdgeFans::Index EdgeFans::FindSide(
  const std::vector<signed char>& values, const LinePiece& piece) const
{
  const Index start = this->Surface.GetWelded(piece.Nodes[0].From);
  const Index* const side = std::find_if(piece.Sides, piece.SidesEnd,
    [&](Index halfEdge)
    {
      return this->Surface.GetWelded(this->Surface.GetStart(halfEdge)) == start &&
        this->FindMatch(values, halfEdge) == None;
    });
  return side == piece.SidesEnd ? None : *side;
}

//------------------------------------------------------------------------------
// From a half-edge that bounds a fan around its end to the one that bounds it on the other side. No
// two half-edges have the same match, and the first is not one, so this does not go in circles.
EdgeFans::Index EdgeFans::FindNext(const std::vector<signed char>& values, Index side) const
{
  Index next = None;
  for (Index entered = side; entered != None; entered = this->FindMatch(values, next))
  {
    next = entered % 3 == 2 ? entered - 2 : entered + 1;
  }
  return next;
}
}
