// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprBruteForceLines.h
 * @brief Lines by going through all triangles and looking up every place in a map: an oracle.
 *
 * It knows nothing of half-edges, clusters or order. A place where a line crosses is either at a
 * point, or on an edge, which is a pair of points; two pieces join where just they have a place.
 */
#ifndef nprBruteForceLines_h
#define nprBruteForceLines_h

#include "nprSegmentMatching.h"

#include <map>
#include <set>

namespace nprtest
{
struct BruteForceMesh
{
  std::vector<Vector> Points;
  std::vector<std::array<int, 3>> Triangles;
};

/// Values at the points of a mesh; without tests all is accepted, without axes the sign is the
/// field's own.
struct BruteForceField
{
  std::vector<double> Field;
  std::vector<double> Test;
  std::vector<Vector> Axes;
};

class BruteForceLines
{
public:
  explicit BruteForceLines(const BruteForceMesh& mesh) : Mesh(mesh)
  {
    for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      for (int e = 0; e < 3; ++e)
      {
        this->Edges[this->GetEdge(t, e)].push_back(static_cast<int>(t));
      }
    }
  }

  using Edge = std::pair<int, int>; // the lesser point first
  const std::map<Edge, std::vector<int>>& GetEdges() const { return this->Edges; }

  void AddEdge(const Edge& edge)
  {
    const Place from = { AtPoint(edge.first), this->Mesh.Points[edge.first] };
    const Place to = { AtPoint(edge.second), this->Mesh.Points[edge.second] };
    this->AddPiece({ from, to });
  }

  void AddField(const BruteForceField& values)
  {
    for (std::size_t t = 0; t < this->Mesh.Triangles.size(); ++t)
    {
      std::vector<Place> places;
      std::vector<double> tests;
      for (int e = 0; e < 3; ++e)
      {
        auto [from, to] = this->GetEdge(t, e);
        if (!IsCrossed(values, from, to))
        {
          continue;
        }
        // At 0 itself it is the point on the positive side that the line goes through; where there
        // is no such side, the one where the field is 0.
        const double a = values.Field[from];
        const double b = values.Field[to];
        if (values.Axes.empty() ? a < 0.0 : std::abs(b) < std::abs(a))
        {
          std::swap(from, to);
        }
        const double here = std::abs(values.Field[from]);
        const double there = std::abs(values.Field[to]);
        const double s = here + there > 0.0 ? here / (here + there) : 0.5;
        const Vector& p = this->Mesh.Points[from];
        places.push_back(
          { s == 0.0 ? AtPoint(from) : this->OnEdge(t, e), p + s * (this->Mesh.Points[to] - p) });
        tests.push_back(values.Test.empty()
            ? 1.0
            : values.Test[from] + s * (values.Test[to] - values.Test[from]));
      }
      if (places.size() != 2 || places[0].Key == places[1].Key ||
        std::max(tests[0], tests[1]) <= 0.0)
      {
        continue;
      }
      Piece piece = { places[0], places[1] };
      for (int i = 0; i < 2; ++i)
      {
        if (tests[i] < 0.0)
        {
          const double s = tests[i] / (tests[i] - tests[1 - i]);
          piece[i] = Place{ { Cut, static_cast<int>(t), 0, 0 },
            places[i].Position + s * (places[1 - i].Position - places[i].Position) };
        }
      }
      this->AddPiece(piece);
    }
  }

  std::vector<Segment> GetSegments() const
  {
    std::vector<Segment> segments;
    for (const Piece& piece : this->Pieces)
    {
      const Vector& a = piece[0].Position;
      const Vector& b = piece[1].Position;
      if (HasLength(piece))
      {
        segments.push_back({ a[0], a[1], a[2], b[0], b[1], b[2] });
      }
    }
    return segments;
  }

  /// What the pieces come to when joined.
  std::vector<Form> GetForms() const
  {
    const auto ends = this->GetEnds();
    std::vector<std::size_t> parents(this->Pieces.size());
    for (std::size_t i = 0; i < parents.size(); ++i)
    {
      parents[i] = i;
    }
    const auto findRoot = [&parents](std::size_t piece)
    {
      while (parents[piece] != piece)
      {
        piece = parents[piece];
      }
      return piece;
    };
    std::vector<int> joints(this->Pieces.size(), 0);
    for (const auto& [key, pieces] : ends)
    {
      if (pieces.size() == 2)
      {
        parents[findRoot(pieces[0])] = findRoot(pieces[1]);
      }
    }
    for (const auto& [key, pieces] : ends)
    {
      joints[findRoot(pieces[0])] += pieces.size() == 2;
    }
    std::vector<int> sizes(this->Pieces.size(), 0);
    std::vector<std::size_t> lengths(this->Pieces.size(), 0);
    for (std::size_t i = 0; i < parents.size(); ++i)
    {
      ++sizes[findRoot(i)];
      lengths[findRoot(i)] += HasLength(this->Pieces[i]);
    }
    std::vector<Form> forms;
    for (std::size_t i = 0; i < parents.size(); ++i)
    {
      // A line of n pieces has n joints if it is closed, else one less.
      if (lengths[i] > 0)
      {
        forms.emplace_back(lengths[i], joints[i] == sizes[i]);
      }
    }
    std::sort(forms.begin(), forms.end());
    return forms;
  }

  /// @name How often the rarer things happen, for a test that wants them
  ///@{
  std::size_t CountPointPlaces() const
  {
    return this->CountPlaces([](const PlaceKey& key, std::size_t) { return key[0] == Point; });
  }
  std::size_t CountMeetings() const
  {
    return this->CountPlaces([](const PlaceKey&, std::size_t ends) { return ends > 2; });
  }
  std::size_t CountCuts() const
  {
    return this->CountPlaces([](const PlaceKey& key, std::size_t) { return key[0] == Cut; });
  }
  ///@}

private:
  enum Kind
  {
    Point,
    Between,
    Cut
  };
  using PlaceKey = std::array<int, 4>; // kind, point, point, triangle
  struct Place
  {
    PlaceKey Key;
    Vector Position;
  };
  using Piece = std::array<Place, 2>;

  Edge GetEdge(std::size_t t, int e) const
  {
    const std::array<int, 3>& c = this->Mesh.Triangles[t];
    return std::minmax({ c[e], c[(e + 1) % 3] });
  }

  /// In a triangle without area, a point and a place on the edge across from it may be one.
  static bool HasLength(const Piece& piece)
  {
    return (piece[1].Position - piece[0].Position).norm() > 1.0e-9;
  }

  static PlaceKey AtPoint(int point) { return { Point, point, 0, 0 }; }

  /// Lines run on between two triangles only.
  PlaceKey OnEdge(std::size_t t, int e) const
  {
    const Edge edge = this->GetEdge(t, e);
    const bool joins = this->Edges.at(edge).size() == 2;
    return { Between, edge.first, edge.second, joins ? 0 : static_cast<int>(t) };
  }

  static bool IsPositive(const BruteForceField& values, int point)
  {
    const double value = values.Field[point];
    if (values.Axes.empty() || value != 0.0)
    {
      return value >= 0.0;
    }
    // Zero is slightly off, to one side in space.
    const Vector& axis = values.Axes[point];
    return axis[0] != 0.0 ? axis[0] > 0.0 : axis[1] != 0.0 ? axis[1] > 0.0 : axis[2] >= 0.0;
  }

  static bool IsCrossed(const BruteForceField& values, int a, int b)
  {
    const bool differ = IsPositive(values, a) != IsPositive(values, b);
    if (values.Axes.empty())
    {
      return differ;
    }
    const double cosine = values.Axes[a].dot(values.Axes[b]);
    return std::abs(cosine) > std::sqrt(0.5) && differ == (cosine > 0.0);
  }

  /// A piece between two points that is there already is not added again.
  void AddPiece(const Piece& piece)
  {
    const auto keys = std::minmax(piece[0].Key, piece[1].Key);
    if (piece[0].Key[0] != Point || piece[1].Key[0] != Point || this->Doubles.insert(keys).second)
    {
      this->Pieces.push_back(piece);
    }
  }

  std::map<PlaceKey, std::vector<std::size_t>> GetEnds() const
  {
    std::map<PlaceKey, std::vector<std::size_t>> ends;
    for (std::size_t i = 0; i < this->Pieces.size(); ++i)
    {
      ends[this->Pieces[i][0].Key].push_back(i);
      ends[this->Pieces[i][1].Key].push_back(i);
    }
    return ends;
  }

  template<typename Predicate>
  std::size_t CountPlaces(const Predicate& predicate) const
  {
    std::size_t count = 0;
    for (const auto& [key, pieces] : this->GetEnds())
    {
      count += predicate(key, pieces.size());
    }
    return count;
  }

  const BruteForceMesh& Mesh;
  std::map<Edge, std::vector<int>> Edges;
  std::vector<Piece> Pieces;
  std::set<std::pair<PlaceKey, PlaceKey>> Doubles;
};
}

#endif
