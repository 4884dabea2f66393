// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprTupleArrays.h
 * @brief Between data arrays and the vectors of fixed-size tuples that the kernels take and give.
 */
#ifndef nprTupleArrays_h
#define nprTupleArrays_h

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace npr
{
/**
 * @class Tuples
 * @brief What std::vector would be for tuples of floats, in memory that a vtkFloatArray can have.
 *
 * New tuples are not set to anything, so that the threads that fill them are the first to touch
 * them.
 */
template<int Size>
class Tuples
{
public:
  using value_type = Eigen::Matrix<float, Size, 1>;
  using iterator = value_type*;
  using const_iterator = const value_type*;
  static_assert(sizeof(value_type) == Size * sizeof(float), "packed tuples");

  Tuples() = default;
  explicit Tuples(std::size_t size) { this->Allocate(size); }
  Tuples(std::size_t size, const value_type& value) { this->assign(size, value); }
  Tuples(const_iterator first, const_iterator last)
  {
    this->Allocate(static_cast<std::size_t>(last - first));
    std::copy(first, last, this->begin());
  }
  Tuples(const Tuples& other) { *this = other; }
  Tuples(Tuples&& other) noexcept { this->swap(other); }
  ~Tuples() = default;
  Tuples& operator=(const Tuples& other)
  {
    if (this != &other)
    {
      if (this->Count != other.Count)
      {
        this->Allocate(other.Count);
      }
      std::copy(other.begin(), other.end(), this->begin());
    }
    return *this;
  }
  Tuples& operator=(Tuples&& other) noexcept
  {
    Tuples(std::move(other)).swap(*this);
    return *this;
  }
  void swap(Tuples& other) noexcept
  {
    std::swap(this->Array, other.Array);
    std::swap(this->First, other.First);
    std::swap(this->Count, other.Count);
  }

  /// What was there stays; what is new is not set to anything.
  void resize(std::size_t size)
  {
    if (size == this->Count)
    {
      return;
    }
    Tuples resized;
    resized.Allocate(size);
    std::copy_n(this->begin(), std::min(size, this->Count), resized.begin());
    resized.swap(*this);
  }
  void assign(std::size_t size, const value_type& value)
  {
    if (size != this->Count)
    {
      this->Allocate(size);
    }
    std::fill(this->begin(), this->end(), value);
  }
  void clear() { Tuples().swap(*this); }

  std::size_t size() const { return this->Count; }
  bool empty() const { return this->Count == 0; }
  value_type* data() { return this->First; }
  const value_type* data() const { return this->First; }
  value_type& operator[](std::size_t i) { return this->First[i]; }
  const value_type& operator[](std::size_t i) const { return this->First[i]; }
  iterator begin() { return this->First; }
  iterator end() { return this->First + this->Count; }
  const_iterator begin() const { return this->First; }
  const_iterator end() const { return this->First + this->Count; }

  /// The array that has the tuples; they are left empty.
  vtkSmartPointer<vtkFloatArray> TakeArray()
  {
    auto array = this->Array;
    if (!array)
    {
      array = vtkSmartPointer<vtkFloatArray>::New();
      array->SetNumberOfComponents(Size);
    }
    this->clear();
    return array;
  }

private:
  void Allocate(std::size_t size)
  {
    this->clear();
    if (size > 0)
    {
      this->Array = vtkSmartPointer<vtkFloatArray>::New();
      this->Array->SetNumberOfComponents(Size);
      this->Array->SetNumberOfTuples(static_cast<vtkIdType>(size));
      this->First = reinterpret_cast<value_type*>(this->Array->GetPointer(0));
      this->Count = size;
    }
  }

  vtkSmartPointer<vtkFloatArray> Array; // null without tuples
  value_type* First = nullptr;
  std::size_t Count = 0;
};

/// The array's tuples as floats. It must have `Size` components.
template<int Size>
Tuples<Size> ReadTuples(vtkDataArray* array)
{
  Tuples<Size> tuples(array->GetNumberOfTuples());
  auto* const floats = vtkFloatArray::FastDownCast(array);
  vtkSMPTools::For(0, array->GetNumberOfTuples(),
    [&](vtkIdType begin, vtkIdType end)
    {
      if (floats)
      {
        std::copy_n(floats->GetPointer(begin * Size), (end - begin) * Size, tuples[begin].data());
        return;
      }
      double tuple[Size];
      for (vtkIdType i = begin; i < end; ++i)
      {
        array->GetTuple(i, tuple);
        tuples[i] = Eigen::Map<Eigen::Matrix<double, Size, 1>>(tuple).template cast<float>();
      }
    });
  return tuples;
}

/// A named float array that has the tuples' memory.
template<int Size>
vtkSmartPointer<vtkFloatArray> MakeArray(const char* name, Tuples<Size>&& tuples)
{
  vtkSmartPointer<vtkFloatArray> array = tuples.TakeArray();
  array->SetName(name);
  return array;
}

/// A named float array of a copy of the tuples.
template<int Size>
vtkSmartPointer<vtkFloatArray> MakeArray(const char* name, const Tuples<Size>& tuples)
{
  return MakeArray<Size>(name, Tuples<Size>(tuples));
}

/// A named float array of single values.
inline vtkSmartPointer<vtkFloatArray> MakeArray(const char* name, const std::vector<float>& values)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

/// A named array of flags, 0 or 1.
inline vtkSmartPointer<vtkUnsignedCharArray> MakeFlagArray(
  const char* name, const std::vector<unsigned char>& flags)
{
  auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(flags.size()));
  std::copy(flags.begin(), flags.end(), array->GetPointer(0));
  return array;
}
}

#endif
