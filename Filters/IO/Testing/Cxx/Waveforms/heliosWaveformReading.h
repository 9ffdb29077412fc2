// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A reader of a waveform file in a temporary folder, as a whole or in pieces.

#ifndef heliosWaveformReading_h
#define heliosWaveformReading_h

#include "heliosTempFolder.h"
#include "heliosWaveformTesting.h"
#include "vtkHeliosWaveformTextReader.h"

#include <vtkExecutive.h>

#include <fstream>
#include <string>

namespace helios
{

struct WaveformReading
{
  TempFolder Folder;
  vtkNew<vtkHeliosWaveformTextReader> Reader;
  vtkSmartPointer<ErrorObserver> Log = WatchErrors(Reader);
  vtkSmartPointer<ErrorObserver> Quiet = WatchErrors(Reader->GetExecutive());

  WaveformReading() = default;
  explicit WaveformReading(const std::string& text) { this->Set(text); }

  /// Replaces the text of the file.
  void Set(const std::string& text)
  {
    std::ofstream(this->Folder / "a.txt", std::ios::binary) << text;
    this->Reader->SetFileName((this->Folder / "a.txt").c_str());
    this->Reader->Modified();
    this->Log->Clear();
  }

  /// True if there was no error.
  bool Read(int piece = 0, int count = 1)
  {
    this->Reader->UpdatePiece(piece, count, 0);
    return this->Log->Errors.empty();
  }

  bool FailsWith(const std::string& text, const std::string& part)
  {
    this->Set(text);
    return !this->Read() && this->Log->HasError(part) && this->CountWaveforms() == 0;
  }

  vtkTable* Table() { return this->Reader->GetOutput(); }
  vtkIdType CountWaveforms() { return this->Table()->GetNumberOfRows(); }
  double Get(const char* name, vtkIdType row, int component = 0)
  {
    return this->Table()->GetRowData()->GetArray(name)->GetComponent(row, component);
  }
  vtkIdType GetCount(vtkIdType row)
  {
    return static_cast<vtkIdType>(this->Get(vtkHeliosArrayNames::Count, row));
  }
  double GetSample(vtkIdType i)
  {
    return this->Table()
      ->GetFieldData()
      ->GetArray(vtkHeliosArrayNames::Samples)
      ->GetComponent(i, 0);
  }
};

} // namespace helios

#endif
