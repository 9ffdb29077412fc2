// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Read access to an array of a block: any type, fast for the types of the scanner.

#ifndef heliosColumn_h
#define heliosColumn_h

#include <vtkDataArray.h>
#include <vtkVariant.h>

namespace helios
{

class Column
{
public:
  Column() = default;
  explicit Column(vtkDataArray* array)
    : Array(array)
    , Values(array->HasStandardMemoryLayout() ? array->GetVoidPointer(0) : nullptr)
    , Type(array->GetDataType())
    , Components(array->GetNumberOfComponents())
  {
  }

  bool IsSet() const { return this->Array != nullptr; }
  bool HasIntegers() const { return this->Type != VTK_FLOAT && this->Type != VTK_DOUBLE; }

  double GetNumber(vtkIdType row, int component = 0) const
  {
    switch (this->Values ? this->Type : VTK_VOID)
    {
      case VTK_DOUBLE:
        return this->Get<double>(row * this->Components + component);
      case VTK_FLOAT:
        return static_cast<double>(this->Get<float>(row * this->Components + component));
      default:
        return this->Array->GetComponent(row, component);
    }
  }

  /// Full 64-bit value; the array has one component and is of integer type.
  vtkTypeInt64 GetInteger(vtkIdType row) const
  {
    switch (this->Values ? this->Type : VTK_VOID)
    {
      case VTK_INT:
        return this->Get<int>(row);
      case VTK_UNSIGNED_CHAR:
        return this->Get<unsigned char>(row);
      case VTK_UNSIGNED_SHORT:
        return this->Get<unsigned short>(row);
      case VTK_LONG:
        return this->Get<long>(row);
      case VTK_LONG_LONG: // NOLINT(bugprone-branch-clone): the type of ids, if they have 64 bits
        return this->Get<long long>(row);
      case VTK_ID_TYPE:
        return this->Get<vtkIdType>(row);
      default:
        return this->Array->GetVariantValue(row).ToTypeInt64();
    }
  }

private:
  template <typename T>
  T Get(vtkIdType index) const
  {
    return static_cast<const T*>(this->Values)[index];
  }

  vtkDataArray* Array = nullptr;
  const void* Values = nullptr;
  int Type = VTK_VOID;
  int Components = 1;
};

} // namespace helios

#endif
