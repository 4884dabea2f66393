// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprAlignedVector_h
#define nprAlignedVector_h

#include <cstddef>
#include <new>
#include <vector>

namespace npr
{
/// Gives memory that begins where a line of the processor's cache does, so that what has the size
/// of a line, or divides it, lies in one and not across two.
template<typename Value>
struct CacheLineAllocator
{
  using value_type = Value;
  static constexpr std::align_val_t Alignment{ 64 };

  CacheLineAllocator() = default;
  template<typename Other>
  CacheLineAllocator(const CacheLineAllocator<Other>&)
  {
  }

  Value* allocate(std::size_t count)
  {
    return static_cast<Value*>(::operator new(count * sizeof(Value), Alignment));
  }
  void deallocate(Value* values, std::size_t) { ::operator delete(values, Alignment); }

  template<typename Other>
  bool operator==(const CacheLineAllocator<Other>&) const
  {
    return true;
  }
  template<typename Other>
  bool operator!=(const CacheLineAllocator<Other>&) const
  {
    return false;
  }
};

/// For what is read and written far apart, some at a time.
template<typename Value>
using AlignedVector = std::vector<Value, CacheLineAllocator<Value>>;
}

#endif
