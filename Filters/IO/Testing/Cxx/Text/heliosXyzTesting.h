// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A reader of a point file in a temporary folder, as a whole or in pieces.

#ifndef heliosXyzTesting_h
#define heliosXyzTesting_h

#include "heliosErrorObserver.h"
#include "heliosTempFolder.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosXyzReader.h"

#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <fstream>
#include <string>
#include <vector>

namespace helios
{

struct XyzReading
{
  TempFolder Folder;
  vtkNew<vtkHeliosXyzReader> Reader;
  vtkSmartPointer<ErrorObserver> Log = vtkSmartPointer<ErrorObserver>::Take(ErrorObserver::New());
  vtkSmartPointer<ErrorObserver> Quiet = vtkSmartPointer<ErrorObserver>::Take(ErrorObserver::New());

  XyzReading()
  {
    this->Log->Watch(this->Reader);
    this->Quiet->Watch(this->Reader->GetExecutive());
  }

  explicit XyzReading(const std::string& text)
    : XyzReading()
  {
    this->Set(text);
  }

  std::string Write(const std::string& name, const std::string& text) const
  {
    std::ofstream(this->Folder / name, std::ios::binary) << text;
    return this->Folder / name;
  }

  /// Replaces the text of the file.
  void Set(const std::string& text)
  {
    this->Reader->SetFileName(this->Write("a.xyz", text).c_str());
    this->Reader->Modified();
    this->Log->Clear();
  }

  /// True if there was no error.
  bool Read(int piece = 0, int count = 1)
  {
    this->Reader->UpdatePiece(piece, count, 0);
    return this->Log->Errors.empty();
  }

  bool FailsWith(const std::string& text, const std::string& part, int piece = 0, int count = 1)
  {
    this->Set(text);
    return !this->Read(piece, count) && this->Log->HasError(part) && this->CountPoints() == 0;
  }

  vtkPolyData* Cloud() { return this->Reader->GetOutput(); }
  vtkIdType CountPoints() { return this->Cloud()->GetNumberOfPoints(); }

  std::array<double, 3> GetPoint(vtkIdType i)
  {
    std::array<double, 3> point;
    this->Cloud()->GetPoint(i, point.data());
    return point;
  }

  /// A tuple of a point array.
  std::array<double, 3> GetTriple(const char* name, vtkIdType i)
  {
    std::array<double, 3> triple{};
    vtkDataArray* array = this->Cloud()->GetPointData()->GetArray(name);
    if (array && array->GetNumberOfComponents() == 3 && i < array->GetNumberOfTuples())
    {
      array->GetTuple(i, triple.data());
    }
    return triple;
  }
};

} // namespace helios

#endif
