// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A reader of a trajectory file in a temporary folder.

#ifndef heliosTrajectoryReading_h
#define heliosTrajectoryReading_h

#include "heliosErrorObserver.h"
#include "heliosPose.h"
#include "heliosTempFolder.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosTrajectoryReader.h"

#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace helios
{

struct TrajectoryReading
{
  TempFolder Folder;
  vtkNew<vtkHeliosTrajectoryReader> Reader;
  vtkSmartPointer<ErrorObserver> Log = vtkSmartPointer<ErrorObserver>::Take(ErrorObserver::New());
  vtkSmartPointer<ErrorObserver> Quiet = vtkSmartPointer<ErrorObserver>::Take(ErrorObserver::New());

  TrajectoryReading()
  {
    this->Log->Watch(this->Reader);
    this->Quiet->Watch(this->Reader->GetExecutive());
  }

  /// True if the text was read without an error.
  bool Read(const std::string& text)
  {
    std::ofstream(this->Folder / "a.trj", std::ios::binary) << text;
    this->Reader->SetFileName((this->Folder / "a.trj").c_str());
    return this->Update();
  }

  bool Update()
  {
    this->Log->Clear();
    this->Reader->Modified();
    this->Reader->Update();
    return this->Log->Errors.empty();
  }

  bool FailsWith(const std::string& text, const std::string& part)
  {
    return !this->Read(text) && this->Log->HasError(part) && this->CountRows() == 0;
  }

  vtkPolyData* Path() { return this->Reader->GetOutput(); }
  vtkIdType CountRows() { return this->Path()->GetNumberOfPoints(); }
  Vec3 GetPosition(vtkIdType row) { return Vec3(this->Path()->GetPoint(row)); }
  double GetTime(vtkIdType row)
  {
    return this->Path()->GetPointData()->GetArray(vtkHeliosArrayNames::GpsTime)->GetTuple1(row);
  }
  Quaternion GetOrientation(vtkIdType row)
  {
    return Quaternion(
      this->Path()->GetPointData()->GetArray(vtkHeliosArrayNames::Orientation)->GetTuple4(row));
  }
  /// Transforms a body vector to the world.
  Vec3 ToWorld(vtkIdType row, const Vec3& v) { return Rotate(this->GetOrientation(row), v); }
};

/// The largest element difference of two attitude matrices, about the angle between them [rad].
inline double Distance(const Quaternion& a, const Quaternion& b)
{
  const Rotation m(a), n(b);
  double largest = 0.0;
  for (int k = 0; k < 9; ++k)
  {
    largest = std::max(largest, std::abs(m.M[k / 3][k % 3] - n.M[k / 3][k % 3]));
  }
  return largest;
}

} // namespace helios

#endif
