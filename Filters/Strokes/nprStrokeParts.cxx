// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeParts.h"

#include <functional>
#include <queue>
#include <utility>

namespace npr
{
namespace
{
/// Parts in a row or a ring, that become fewer.
class PartMerger
{
public:
  PartMerger(std::vector<StrokePart>& parts, bool isClosed)
    : Parts(parts), Before(parts.size()), After(parts.size()), Gone(parts.size(), 0)
  {
    const std::size_t size = parts.size();
    for (std::size_t i = 0; i < size; ++i)
    {
      this->Before[i] = i > 0 ? i - 1 : isClosed ? size - 1 : None;
      this->After[i] = i + 1 < size ? i + 1 : isClosed ? 0 : None;
    }
  }

  void MergeShorterThan(double least)
  {
    for (std::size_t i = 0; i < this->Parts.size(); ++i)
    {
      this->Push(i, least);
    }
    while (!this->Shortest.empty())
    {
      const auto [length, part] = this->Shortest.top();
      this->Shortest.pop();
      // What has grown since has come again.
      if (!this->Gone[part] && this->Parts[part].Length == length)
      {
        this->MergeOne(part);
        this->Push(part, least);
      }
    }
  }

  /// In order, beginning with the one that had the first place.
  std::vector<StrokePart> GetParts() const
  {
    std::vector<StrokePart> rest;
    for (std::size_t i = 0; i < this->Parts.size(); ++i)
    {
      if (!this->Gone[i])
      {
        rest.push_back(this->Parts[i]);
      }
    }
    return rest;
  }

  /// Makes one of all neighbours that are alike around this one.
  void JoinLike(std::size_t part)
  {
    for (auto* beside : { &this->After, &this->Before })
    {
      const std::size_t other = (*beside)[part];
      if (other != None && other != part && this->Parts[other].Layers == this->Parts[part].Layers)
      {
        this->Absorb(part, other, beside == &this->After);
      }
    }
  }

private:
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  void Push(std::size_t part, double least)
  {
    const bool hasBefore = this->IsUsable(this->Before[part], part);
    const bool hasAfter = this->IsUsable(this->After[part], part);
    // What ends hidden is no gap.
    const bool mayChange =
      this->Parts[part].Layers > 0 ? hasBefore && hasAfter : hasBefore || hasAfter;
    if (this->Parts[part].Layers != StrokePart::Nowhere && this->Parts[part].Length < least &&
      mayChange)
    {
      this->Shortest.push({ this->Parts[part].Length, part });
    }
  }
  bool IsUsable(std::size_t other, std::size_t part) const
  {
    return other != None && other != part && this->Parts[other].Layers != StrokePart::Nowhere;
  }
  void MergeOne(std::size_t part)
  {
    std::size_t other = this->Before[part];
    const std::size_t after = this->After[part];
    if (!this->IsUsable(other, part) ||
      (this->IsUsable(after, part) && this->Parts[after].Length > this->Parts[other].Length))
    {
      other = after;
    }
    if (this->IsUsable(other, part))
    {
      this->Parts[part].Layers = this->Parts[other].Layers;
      this->JoinLike(part);
    }
  }
  void Absorb(std::size_t part, std::size_t other, bool isAfter)
  {
    StrokePart& merged = this->Parts[part];
    merged.Length += this->Parts[other].Length;
    this->Gone[other] = 1;
    if (isAfter)
    {
      merged.End = this->Parts[other].End;
      this->After[part] = this->After[other];
      if (this->After[part] != None)
      {
        this->Before[this->After[part]] = part;
      }
    }
    else
    {
      merged.Begin = this->Parts[other].Begin;
      this->Before[part] = this->Before[other];
      if (this->Before[part] != None)
      {
        this->After[this->Before[part]] = part;
      }
    }
  }

  using LengthAndPart = std::pair<double, std::size_t>;
  std::vector<StrokePart>& Parts;
  std::vector<std::size_t> Before;
  std::vector<std::size_t> After;
  std::vector<unsigned char> Gone;
  std::priority_queue<LengthAndPart, std::vector<LengthAndPart>, std::greater<>> Shortest;
};
}

//------------------------------------------------------------------------------
std::vector<StrokePart> MergeParts(
  std::vector<StrokePart> parts, double least, bool isClosed, std::size_t size)
{
  if (parts.size() < 2)
  {
    return parts;
  }
  PartMerger merger(parts, isClosed);
  if (isClosed)
  {
    merger.JoinLike(0);
  }
  merger.MergeShorterThan(least);
  std::vector<StrokePart> merged = merger.GetParts();
  if (merged.size() == 1)
  {
    // A ring that is all alike begins where it did.
    merged[0].Begin = 0.0;
    merged[0].End = static_cast<double>(size);
  }
  return merged;
}
}
