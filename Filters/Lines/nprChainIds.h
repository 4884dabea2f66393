// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprChainIds_h
#define nprChainIds_h

#include "nprLineChains.h"
#include "vtkNPRFiltersLinesModule.h"

#include <cstddef>
#include <vector>

namespace npr
{
/**
 * @class ChainIds
 * @brief Gives the lines of one definition numbers that they keep from view to view.
 *
 * A chain claims the number of the chain before, at the same level, that it shares most with: the
 * vertices at places that both run through, as a part of those of the longer one, so that a short
 * line beside a long one is not taken for it. Of several that claim one number the one that shares
 * most has it, and the others get new ones.
 */
class VTKNPRFILTERSLINES_EXPORT ChainIds
{
public:
  /// Which chain before a chain goes on from, how many of its vertices are at places that the other
  /// ran through, and what part that is of the longer one's. 0 for none.
  struct Claim
  {
    int Before;
    int Votes;
    float Share;
  };
  static constexpr int NoChain = -1;
  /// Those of the chains begin <= chain < end; claims[0] is that of the first.
  void GetClaims(const LineChains& chains, std::size_t begin, std::size_t end, Claim* claims) const;

  /// What chains with these claims get; NoId is for those that are to get a new number.
  static constexpr int NoId = -1;
  std::vector<int> Give(const std::vector<Claim>& claims) const;

  /// The numbers that chains have got, for the next view.
  void Remember(
    const LineChains& chains, const std::vector<std::size_t>& chosen, const std::vector<int>& ids);

private:
  struct Chain
  {
    int Id;
    int Level;
    int Size;
  };
  // The way of a chain through a place.
  struct Passage
  {
    int Chain;
    int Votes;                    // vertices at the place
    TriangleMesh::Index Triangle; // that it comes to first
    int Next;                     // passage at the place; NoPassage for none
  };
  static constexpr int NoPassage = -1;
  // What a chain shares with one before.
  struct Vote
  {
    int Before;
    int Votes;
    int SameTriangles;
  };

  void CountVotes(const LineChains& chains, std::size_t chain, std::vector<Vote>& votes) const;
  Claim Choose(const std::vector<Vote>& votes, int size) const;

  std::vector<Chain> Chains;      // before
  std::vector<int> FirstPassages; // of places on the surface
  std::vector<Passage> Passages;
};
}

#endif
