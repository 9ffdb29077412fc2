// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosReturnSelection.h"

#include "heliosPointSelection.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <new>
#include <string>

vtkStandardNewMacro(vtkHeliosReturnSelection);

namespace names = vtkHeliosArrayNames;

/// Whether a point passes, by the arrays of an input.
class vtkHeliosReturnSelection::Test
{
public:
  explicit Test(const vtkHeliosReturnSelection& selection)
    : Selection(selection)
  {
  }

  /// Reads the arrays needed.
  helios::Status Set(vtkPolyData* input)
  {
    const int* range = this->Selection.ReturnRange;
    const bool isRange = range[0] > 0 || range[1] < 255;
    const bool isKind = this->Selection.Returns != AllReturns;
    const struct
    {
      const char* Name;
      bool IsNeeded;
      vtkDataArray** Array;
    } arrays[] = { { names::ReturnNumber, isRange || isKind, &this->Number },
      { names::NumberOfReturns, isKind && this->Selection.Returns != FirstReturns, &this->Total },
      { names::ClassificationIds, !this->Selection.Classes.empty(), &this->Class } };
    for (const auto& array : arrays)
    {
      vtkDataArray* found = input->GetPointData()->GetArray(array.Name);
      if (array.IsNeeded && !IsIntegers(found, input->GetNumberOfPoints()))
      {
        return helios::Status::Error(std::string("the point array ") + array.Name +
          (found ? " is not one integer per point" : " does not exist") +
          "; add it, or do not select by it");
      }
      *array.Array = array.IsNeeded ? found : nullptr;
    }
    return {};
  }

  bool Passes(vtkIdType point) const
  {
    const int* range = this->Selection.ReturnRange;
    const int number = Get(this->Number, point);
    return (!this->Number || (number >= range[0] && number <= range[1])) &&
      this->PassesKind(number, Get(this->Total, point)) && this->PassesClass(point);
  }

private:
  static bool IsIntegers(vtkDataArray* array, vtkIdType count)
  {
    return array && array->GetNumberOfComponents() == 1 && array->GetNumberOfTuples() == count &&
      array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
  }

  static int Get(vtkDataArray* array, vtkIdType point)
  {
    return array ? static_cast<int>(array->GetComponent(point, 0)) : 0;
  }

  bool PassesKind(int number, int total) const
  {
    switch (this->Selection.Returns)
    {
      case FirstReturns:
        return number == 1;
      case LastReturns:
        return number == total;
      case OnlyReturns:
        return total == 1;
      case IntermediateReturns:
        return number > 1 && number < total;
      case FirstOfMany:
        return number == 1 && total > 1;
      case LastOfMany:
        return number == total && total > 1;
      default:
        return true;
    }
  }

  bool PassesClass(vtkIdType point) const
  {
    const std::vector<int>& classes = this->Selection.Classes;
    return !this->Class ||
      std::find(classes.begin(), classes.end(), Get(this->Class, point)) != classes.end();
  }

  const vtkHeliosReturnSelection& Selection;
  vtkDataArray* Number = nullptr;
  vtkDataArray* Total = nullptr;
  vtkDataArray* Class = nullptr;
};

//------------------------------------------------------------------------------
void vtkHeliosReturnSelection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Returns: " << this->Returns << "\n"
     << indent << "ReturnRange: " << this->ReturnRange[0] << " " << this->ReturnRange[1] << "\n"
     << indent << "Classes:";
  for (const int id : this->Classes)
  {
    os << " " << id;
  }
  os << (this->Classes.empty() ? " (all)\n" : "\n");
}

//------------------------------------------------------------------------------
void vtkHeliosReturnSelection::AddClass(int id)
{
  if (std::find(this->Classes.begin(), this->Classes.end(), id) == this->Classes.end())
  {
    this->Classes.push_back(id);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHeliosReturnSelection::RemoveAllClasses()
{
  if (!this->Classes.empty())
  {
    this->Classes.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkHeliosReturnSelection::GetClass(int index) const
{
  return index >= 0 && index < this->GetNumberOfClasses()
    ? this->Classes[static_cast<std::size_t>(index)]
    : -1;
}

//------------------------------------------------------------------------------
int vtkHeliosReturnSelection::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->ReturnRange[0] > this->ReturnRange[1])
  {
    vtkErrorMacro(<< "ReturnRange is " << this->ReturnRange[0] << " to " << this->ReturnRange[1]
                  << "; set the smaller number first");
    return 0;
  }
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  const vtkIdType count = input->GetNumberOfPoints();
  Test test(*this);
  const helios::Status status = count > 0 ? test.Set(input) : helios::Status();
  if (!status.IsOk())
  {
    vtkErrorMacro(<< "Input: " << status.Message());
    return 0;
  }
  try
  {
    std::vector<vtkIdType> ids;
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (test.Passes(i))
      {
        ids.push_back(i);
      }
    }
    helios::SelectPoints(input, ids, vtkPolyData::GetData(outputVector));
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorMacro(<< "Not enough memory for the points of the input; process them in pieces");
    return 0;
  }
  return 1;
}
