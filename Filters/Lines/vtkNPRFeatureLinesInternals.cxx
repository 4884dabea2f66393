// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRFeatureLinesInternals.h"

#include <vtkSMPTools.h>

//------------------------------------------------------------------------------
// Calls work(entry, bench) for all, in parallel.
template<typename Work>
void vtkNPRFeatureLines::Internals::ForEach(const std::vector<Entry*>& entries, const Work& work)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(entries.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        work(*entries[i], this->Benches[i]);
      }
    });
}

//------------------------------------------------------------------------------
void vtkNPRFeatureLines::Internals::Extract(
  const std::vector<Entry*>& entries, const npr::LineView& view)
{
  {
    const StageTimer timer(*this, EXTRACT);
    for (std::size_t i = 0; i < entries.size(); ++i)
    {
      Entry& entry = *entries[i];
      entry.Definition->BeginView(*this->Surface, view);
      entry.Extractor->Extract(view, this->Options, *this->Values, this->Benches[i].Segments);
      entry.Definition->EndView(*this->Surface);
      entry.IsExtracted = true;
      entry.IsWritten = false;
    }
  }
  {
    const StageTimer timer(*this, JOIN);
    this->ForEach(entries,
      [this](Entry&, Bench& bench)
      {
        if (!bench.Joiner)
        {
          bench.Joiner = std::make_unique<npr::LineJoiner>(*this->Surface);
        }
        bench.Joiner->Join(bench.Segments, bench.Paths);
      });
  }
  const StageTimer timer(*this, PLACE);
  this->ForEach(entries,
    [this](Entry& entry, Bench& bench)
    { entry.Chains.Make(*this->Surface, bench.Segments, bench.Paths, this->OutputSources); });
}

//------------------------------------------------------------------------------
void vtkNPRFeatureLines::Internals::Add(
  const std::vector<Entry*>& entries, const std::vector<Entry*>& changed)
{
  const StageTimer timer(*this, WRITE);
  const auto choose = [this](Entry& entry)
  { entry.Choice = this->Output.Choose(entry.Chains, entry.Ids); };
  const auto remember = [](Entry& entry)
  { entry.Ids.Remember(entry.Chains, entry.Choice.Chains, entry.Choice.Ids); };
  this->ForEach(changed, [&](Entry& entry, Bench&) { choose(entry); });
  for (Entry* const entry : entries)
  {
    const int type = static_cast<int>(entry - this->Entries.data());
    if (!entry->IsWritten || !this->Output.AddLast(entry->Chains, type))
    {
      if (entry->IsWritten)
      {
        choose(*entry);
      }
      this->Output.Add(entry->Chains, type, this->GetLevels(*entry), entry->Choice, this->NextId);
      if (entry->IsWritten)
      {
        remember(*entry);
      }
    }
    entry->IsWritten = !entry->Definition->IsViewDependent();
  }
  this->ForEach(changed, [&](Entry& entry, Bench&) { remember(entry); });
}

//------------------------------------------------------------------------------
// What the output says of the levels.
std::vector<double> vtkNPRFeatureLines::Internals::GetLevels(const Entry& entry) const
{
  const std::vector<float>& levels = entry.Extractor->GetLevels();
  std::vector<double> result(levels.begin(), levels.end());
  for (double& level : result)
  {
    level += entry.Definition->GetLevelOffset(*this->Surface);
  }
  return result;
}

//------------------------------------------------------------------------------
void vtkNPRFeatureLines::Internals::SetSurface(vtkPolyData* input, double lengthScale)
{
  for (Entry& entry : this->Entries)
  {
    entry.Extractor.reset();
  }
  if (!this->Surface || !this->Surface->Move(input, lengthScale))
  {
    this->Values.reset();
    this->Clusters.reset();
    this->Surface = std::make_unique<npr::LineSurface>(input, lengthScale);
    for (Bench& bench : this->Benches)
    {
      bench.Joiner.reset();
    }
    this->NextId = 0;
    for (Entry& entry : this->Entries)
    {
      entry.Ids = npr::ChainIds();
    }
  }
  this->Input = input;
  this->InputMTime = input->GetMTime();
  this->LengthScale = lengthScale;
}

//------------------------------------------------------------------------------
void vtkNPRFeatureLines::Internals::SetClusters(bool haveMoved)
{
  if (!this->Clusters)
  {
    this->Clusters = std::make_unique<npr::LineClusters>(*this->Surface);
    this->Values = std::make_unique<npr::FieldValues>(*this->Surface, *this->Clusters);
  }
  else if (haveMoved)
  {
    this->Clusters->UpdateBounds();
  }
}
