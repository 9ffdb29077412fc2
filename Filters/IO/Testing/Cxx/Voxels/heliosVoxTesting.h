// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A .vox file, and a reader for it.

#ifndef heliosVoxTesting_h
#define heliosVoxTesting_h

#include "heliosErrorObserver.h"
#include "heliosTempFolder.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosVoxelReader.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <fstream>
#include <string>

namespace helios
{
namespace vox
{

inline const std::string Head =
  "VOXEL SPACE\n#min_corner: -1.5 2 100.25\n#max_corner: 0.5 3.5 101.25\n"
  "#split: 4 3 2\n#res: 0.5 #max_pad: 3.5\n";
inline const std::string Columns =
  "i j k PadBVTotal angleMean bsEntering bsIntercepted bsPotential "
  "ground_distance lMeanTotal lgTotal nbEchos nbSampling transmittance "
  "attenuation attenuationBiasCorrection\n";
inline const std::string Rows = "0 0 0 0.5 40 9 1 9 0.25 0.5 3 1 9 0.75 0.1 0.1\n"
                                "3 2 1 1e-1 40 9 1 9 0.25 0.5 3 1 9 1 0.1 0.1\r\n"
                                "1 0 0 NaN 40 9 1 9 0.25 0.5 3 1 9 NaN 0.1 0.1\n\n"
                                "2 1 1 2.25 NaN 9 1 9 0.25 0.5 3 1 9 0 0.1 0.1";

struct Reading
{
  TempFolder Folder;
  vtkNew<vtkHeliosVoxelReader> Reader;
  vtkSmartPointer<ErrorObserver> Log = vtkSmartPointer<ErrorObserver>::Take(ErrorObserver::New());

  explicit Reading(const std::string& text)
  {
    this->Log->Watch(this->Reader);
    this->Log->Watch(this->Reader->GetExecutive());
    this->Write("a.vox", text);
    this->Reader->SetFileName((this->Folder / "a.vox").c_str());
  }

  void Write(const std::string& name, const std::string& text)
  {
    std::ofstream(this->Folder / name, std::ios::binary) << text;
  }

  bool Read()
  {
    this->Reader->Update();
    return this->Log->Errors.empty();
  }

  vtkImageData* Grid() { return this->Reader->GetOutput(); }

  double Get(const char* name, vtkIdType cell)
  {
    return this->Grid()->GetCellData()->GetArray(name)->GetComponent(cell, 0);
  }
};

} // namespace vox
} // namespace helios

#endif
