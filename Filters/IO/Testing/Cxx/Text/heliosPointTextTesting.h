// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A reader of point text in a temporary folder.

#ifndef heliosPointTextTesting_h
#define heliosPointTextTesting_h

#include "heliosErrorObserver.h"
#include "heliosTempFolder.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosPointTextReader.h"

#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace helios
{

struct PointTextReading
{
  TempFolder Folder;
  vtkNew<vtkHeliosPointTextReader> Reader;
  vtkSmartPointer<ErrorObserver> Log = vtkSmartPointer<ErrorObserver>::Take(ErrorObserver::New());
  vtkSmartPointer<ErrorObserver> Quiet = vtkSmartPointer<ErrorObserver>::Take(ErrorObserver::New());

  explicit PointTextReading(const std::string& text = "")
  {
    this->Log->Watch(this->Reader);
    this->Quiet->Watch(this->Reader->GetExecutive());
    this->Set(text);
  }

  /// Replaces the file by one with this text.
  void Set(const std::string& text, const std::string& name = "a.xyz")
  {
    std::filesystem::remove(this->Folder / name);
    std::ofstream(this->Folder / name, std::ios::binary) << text;
    this->Reader->SetFileName((this->Folder / name).c_str());
    this->Reader->SetBegin(0);
    this->Reader->Modified();
    this->Log->Clear();
  }

  /// True if there was no error.
  bool Read()
  {
    this->Reader->Update();
    return this->Log->Errors.empty();
  }

  bool FailsWith(const std::string& text, const std::string& part)
  {
    this->Set(text);
    return !this->Read() && this->Log->HasError(part) && this->CountPoints() == 0;
  }

  int CountColumns() { return this->Reader->ReadLayout() ? this->Reader->GetNumberOfColumns() : 0; }
  std::string Kind() { return this->Reader->GetKind(); }

  vtkPolyData* Cloud() { return this->Reader->GetOutput(); }
  vtkIdType CountPoints() { return this->Cloud()->GetNumberOfPoints(); }
  vtkDataArray* Get(const char* name) { return this->Cloud()->GetPointData()->GetArray(name); }
  double Get(const char* name, vtkIdType row) { return this->Get(name)->GetComponent(row, 0); }

  std::vector<std::string> GetPartNames()
  {
    auto* array = vtkStringArray::SafeDownCast(
      this->Cloud()->GetFieldData()->GetAbstractArray(vtkHeliosArrayNames::PartName));
    std::vector<std::string> names;
    for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
    {
      names.push_back(array->GetValue(i));
    }
    return names;
  }
};

} // namespace helios

#endif
