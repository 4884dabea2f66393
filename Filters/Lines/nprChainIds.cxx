// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprChainIds.h"

#include "nprLineClusters.h"

#include <algorithm>
#include <tuple>

namespace npr
{
namespace
{
// A part of the surface that lines are known by.
std::size_t GetPlace(const LineChains& chains, std::size_t vertex)
{
  return static_cast<std::size_t>(chains.Triangles[vertex] / LineClusters::TrianglesOfCluster);
}

// Calls visit(place, votes, triangle) for the places of a chain, in its order.
template<typename Visit>
void VisitPlaces(const LineChains& chains, std::size_t chain, const Visit& visit)
{
  for (std::size_t v = chains.Begins[chain]; v < chains.Ends[chain];)
  {
    const std::size_t place = GetPlace(chains, v);
    const std::size_t begin = v;
    while (v < chains.Ends[chain] && GetPlace(chains, v) == place)
    {
      ++v;
    }
    visit(place, static_cast<int>(v - begin), chains.Triangles[begin]);
  }
}
}

//------------------------------------------------------------------------------
void ChainIds::GetClaims(
  const LineChains& chains, std::size_t begin, std::size_t end, Claim* claims) const
{
  std::vector<Vote> votes;
  for (std::size_t chain = begin; chain < end; ++chain)
  {
    votes.clear();
    this->CountVotes(chains, chain, votes);
    claims[chain - begin] = this->Choose(votes, static_cast<int>(chains.GetSize(chain)));
  }
}

//------------------------------------------------------------------------------
void ChainIds::CountVotes(
  const LineChains& chains, std::size_t chain, std::vector<Vote>& votes) const
{
  VisitPlaces(chains, chain,
    [&](std::size_t place, int size, TriangleMesh::Index triangle)
    {
      int next = place < this->FirstPassages.size() ? this->FirstPassages[place] : NoPassage;
      while (next != NoPassage)
      {
        const Passage& passage = this->Passages[next];
        next = passage.Next;
        if (this->Chains[passage.Chain].Level != chains.Levels[chain])
        {
          continue;
        }
        auto vote = std::find_if(votes.rbegin(), votes.rend(),
          [&passage](const Vote& other) { return other.Before == passage.Chain; });
        if (vote == votes.rend())
        {
          votes.push_back({ passage.Chain, 0, 0 });
          vote = votes.rbegin();
        }
        vote->Votes += std::min(size, passage.Votes);
        vote->SameTriangles += passage.Triangle == triangle;
      }
    });
}

//------------------------------------------------------------------------------
ChainIds::Claim ChainIds::Choose(const std::vector<Vote>& votes, int size) const
{
  Claim best = { NoChain, 0, 0.0f };
  int sameTriangles = 0;
  for (const Vote& vote : votes)
  {
    const float share =
      static_cast<float>(vote.Votes) / std::max(size, this->Chains[vote.Before].Size);
    if (std::tie(share, vote.SameTriangles, best.Before) >
      std::tie(best.Share, sameTriangles, vote.Before))
    {
      best = { vote.Before, vote.Votes, share };
      sameTriangles = vote.SameTriangles;
    }
  }
  return best;
}

//------------------------------------------------------------------------------
std::vector<int> ChainIds::Give(const std::vector<Claim>& claims) const
{
  std::vector<int> claimants(this->Chains.size(), NoChain); // the best, of each chain before
  for (std::size_t i = 0; i < claims.size(); ++i)
  {
    if (claims[i].Before != NoChain)
    {
      int& best = claimants[claims[i].Before];
      best = best == NoChain || claims[i].Share > claims[best].Share ? static_cast<int>(i) : best;
    }
  }
  std::vector<int> ids(claims.size(), NoId);
  for (std::size_t before = 0; before < claimants.size(); ++before)
  {
    if (claimants[before] != NoChain)
    {
      ids[claimants[before]] = this->Chains[before].Id;
    }
  }
  return ids;
}

//------------------------------------------------------------------------------
void ChainIds::Remember(
  const LineChains& chains, const std::vector<std::size_t>& chosen, const std::vector<int>& ids)
{
  std::fill(this->FirstPassages.begin(), this->FirstPassages.end(), NoPassage);
  this->Passages.clear();
  this->Chains.clear();
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    const int now = static_cast<int>(i);
    this->Chains.push_back(
      { ids[i], chains.Levels[chosen[i]], static_cast<int>(chains.GetSize(chosen[i])) });
    VisitPlaces(chains, chosen[i],
      [&](std::size_t place, int votes, TriangleMesh::Index triangle)
      {
        if (place >= this->FirstPassages.size())
        {
          this->FirstPassages.resize(place + 1, NoPassage);
        }
        int& first = this->FirstPassages[place];
        if (first != NoPassage && this->Passages[first].Chain == now)
        {
          this->Passages[first].Votes += votes;
          return;
        }
        this->Passages.push_back({ now, votes, triangle, first });
        first = static_cast<int>(this->Passages.size()) - 1;
      });
  }
}
}
