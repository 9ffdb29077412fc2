// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosNavigationReport.h"

#include "heliosErrorReport.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>
#include <vtksys/SystemTools.hxx>

#include <algorithm>

vtkStandardNewMacro(vtkHeliosNavigationReport);

//------------------------------------------------------------------------------
bool vtkHeliosNavigationReport::Read(const std::string& fileName)
{
  const bool isBinary = vtksys::SystemTools::LowerCase(
                          vtksys::SystemTools::GetFilenameLastExtension(fileName)) == ".out";
  helios::ErrorReport report;
  const helios::Status status = isBinary ? report.ReadBinary(fileName) : report.ReadText(fileName);
  this->NumberOfRows = 0;
  std::fill_n(this->RMS, 6, 0.0);
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return false;
  }
  this->NumberOfRows = static_cast<vtkIdType>(report.Rows);
  for (std::size_t k = 0; k < 6; ++k)
  {
    this->RMS[k] = report.GetRMS(k);
  }
  return true;
}

//------------------------------------------------------------------------------
double vtkHeliosNavigationReport::GetRMS(int component) const
{
  return component >= 0 && component < 6 ? this->RMS[component] : vtkMath::Nan();
}

//------------------------------------------------------------------------------
void vtkHeliosNavigationReport::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfRows: " << this->NumberOfRows << "\n" << indent << "RMS:";
  for (const double rms : this->RMS)
  {
    os << " " << rms;
  }
  os << " (m, deg)\n";
}
