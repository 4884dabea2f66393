// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprFaceBatch_h
#define nprFaceBatch_h

#include "nprLanes.h"
#include "nprTriangleMesh.h"
#include "nprTupleArrays.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace npr
{
/// In units of the mesh.
inline std::array<TriangleMesh::Vector, 3> GetPositions(
  const TriangleMesh& mesh, const TriangleMesh::Triangle& corners)
{
  const float perUnit = 1.0f / mesh.GetUnit();
  return { mesh.GetPoint(corners[0]) * perUnit, mesh.GetPoint(corners[1]) * perUnit,
    mesh.GetPoint(corners[2]) * perUnit };
}

/// The numbers of a triangle's corners, that opposite the longest edge first.
inline std::array<int, 3> FindOrder(const std::array<TriangleMesh::Vector, 3>& p)
{
  const float squares[3] = { (p[2] - p[1]).squaredNorm(), (p[0] - p[2]).squaredNorm(),
    (p[1] - p[0]).squaredNorm() };
  const int longer = squares[1] > squares[0] ? 1 : 0;
  const int longest = squares[2] > squares[longer] ? 2 : longer;
  constexpr int next[4] = { 1, 2, 0, 1 };
  return { longest, next[longest], next[longest + 1] };
}

/**
 * Some triangles at once, each number of theirs in a row: read one by one, worked on in lanes, and
 * written one by one.
 */
class FaceBatch
{
public:
  using Index = TriangleMesh::Index;
  static constexpr int Capacity = 64;
  using Row = float[Capacity];

  explicit FaceBatch(const TriangleMesh& mesh) : Mesh(mesh) {}

  /// Reads triangles, and for each corner what `read(point, rows, place)` puts there.
  template<typename Read>
  void Fill(Index begin, Index end, const Read& read)
  {
    this->Begin = begin;
    this->Size = end - begin;
    for (int i = 0; i < this->Size; ++i)
    {
      const TriangleMesh::Triangle& corners = this->Mesh.GetTriangle(begin + i);
      const std::array<TriangleMesh::Vector, 3> positions = GetPositions(this->Mesh, corners);
      this->Orders[i] = FindOrder(positions);
      for (int c = 0; c < 3; ++c)
      {
        const Index point = corners[this->Orders[i][c]];
        const TriangleMesh::Vector& position = positions[this->Orders[i][c]];
        this->Points[c][0][i] = position.x();
        this->Points[c][1][i] = position.y();
        this->Points[c][2][i] = position.z();
        read(point, this->Values[c], i);
      }
    }
  }

  /// Calls `work(points, place)` for each group of lanes. The last group is filled up with what was
  /// there before.
  template<typename Work>
  void ForLanes(const Work& work)
  {
    for (int i = 0; i < this->Size; i += NumberOfLanes)
    {
      std::array<Vector3<Lanes>, 3> points;
      for (int c = 0; c < 3; ++c)
      {
        points[c] = LoadVector(this->Points[c], i);
      }
      work(points, i);
    }
  }

  static Vector3<Lanes> LoadVector(const Row* rows, int i)
  {
    return { Load<Lanes>(rows[0] + i), Load<Lanes>(rows[1] + i), Load<Lanes>(rows[2] + i) };
  }
  const Row* GetValues(int corner) const { return this->Values[corner]; }
  void SetPart(int corner, int i, const std::array<Lanes, 4>& part)
  {
    for (int k = 0; k < 4; ++k)
    {
      Store(part[k], this->Results[corner][k] + i);
    }
  }

  /// The results, in the places of the corners.
  void Write(Tuples<4>& parts) const
  {
    for (int i = 0; i < this->Size; ++i)
    {
      Eigen::Vector4f* const part = &parts[3 * static_cast<std::size_t>(this->Begin + i)];
      for (int c = 0; c < 3; ++c)
      {
        part[this->Orders[i][c]] = { this->Results[c][0][i], this->Results[c][1][i],
          this->Results[c][2][i], this->Results[c][3][i] };
      }
    }
  }

private:
  const TriangleMesh& Mesh;
  Index Begin = 0;
  int Size = 0;
  std::array<std::array<int, 3>, Capacity> Orders;
  alignas(16) Row Points[3][3] = {};
  alignas(16) Row Values[3][6] = {};
  alignas(16) Row Results[3][4];
};
}

#endif
