// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A reader of PCD files, and PCD files as text.

#ifndef heliosPcdTesting_h
#define heliosPcdTesting_h

#include "heliosTempFolder.h"
#include "heliosWriterTesting.h"
#include "vtkHeliosPCDReader.h"

#include <vtkExecutive.h>

#include <cstring>
#include <fstream>
#include <string>

namespace helios
{

struct PcdReading
{
  vtkNew<vtkHeliosPCDReader> Reader;
  vtkSmartPointer<ErrorObserver> Log = WatchErrors(this->Reader);
  vtkSmartPointer<ErrorObserver> Quiet = WatchErrors(this->Reader->GetExecutive());

  explicit PcdReading(const std::string& path) { this->Reader->SetFileName(path.c_str()); }

  /// True if there was no error.
  bool Read()
  {
    this->Reader->Modified();
    this->Log->Clear();
    this->Reader->Update();
    return this->Log->Errors.empty();
  }

  vtkPolyData* Cloud() { return this->Reader->GetOutput(); }
  vtkIdType CountPoints() { return this->Cloud()->GetNumberOfPoints(); }
  vtkDataArray* Get(const char* name) { return this->Cloud()->GetPointData()->GetArray(name); }
};

inline std::string WriteFile(const std::string& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

inline std::string Replace(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

template <typename T>
void AppendBytes(std::string& bytes, T value)
{
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

/// Header written by PCL.
inline const std::string AsciiPcd = "# .PCD v.7 - Point Cloud Data file format\n"
                                    "VERSION .7\n"
                                    "FIELDS x y z intensity label\n"
                                    "SIZE 4 4 4 4 2\n"
                                    "TYPE F F F F U\n"
                                    "COUNT 1 1 1 1 2\n"
                                    "WIDTH 2\n"
                                    "HEIGHT 2\n"
                                    "VIEWPOINT 0 0 0 1 0 0 0\n"
                                    "POINTS 4\n"
                                    "DATA ascii\n"
                                    "1 2 3 0.5 7 8\n"
                                    "1.5 -2e1 476000.123456789 nan 65535 0\n"
                                    "nan 0 0 0 1 1\r\n"
                                    "4 5 6 1 2 3";

} // namespace helios

#endif
