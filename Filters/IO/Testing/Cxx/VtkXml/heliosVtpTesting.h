// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// VTP and VTT files in all formats that VTK writes.

#ifndef heliosVtpTesting_h
#define heliosVtpTesting_h

#include "heliosTempFolder.h"
#include "heliosWriterTesting.h"

#include <vtkStringArray.h>
#include <vtkXMLWriter.h>

#include <fstream>
#include <string>
#include <vector>

namespace helios
{

inline void WriteBytes(const std::string& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
}

/// Data as written by a VTK writer: ascii, base64 and raw, with each compressor.
template <typename WriterT, typename DataT>
std::vector<std::string> WriteAllForms(DataT* data, const std::string& path)
{
  std::vector<std::string> files;
  const int modes[] = { vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended };
  const int compressors[] = { vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4,
    vtkXMLWriter::LZMA };
  for (const int mode : modes)
  {
    for (const int compressor : compressors)
    {
      for (const bool isRaw : { false, true })
      {
        vtkNew<WriterT> writer;
        writer->SetInputDataObject(data);
        writer->SetFileName(path.c_str());
        writer->SetDataMode(mode);
        writer->SetCompressorType(compressor);
        writer->SetEncodeAppendedData(!isRaw);
        writer->SetHeaderType(isRaw ? vtkXMLWriter::UInt64 : vtkXMLWriter::UInt32);
        writer->SetBlockSize(4096);
        writer->Write();
        files.push_back(ReadText(path));
      }
    }
  }
  return files;
}

/// A text with one part replaced; empty if the part does not occur.
inline std::string Replace(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  return at == std::string::npos ? "" : text.replace(at, from.size(), to);
}

/// Points with vertices, a polygon, numeric and string arrays.
inline vtkSmartPointer<vtkPolyData> MakeCloud(vtkIdType count)
{
  auto cloud = MakeEchoes(count);
  cloud->Allocate();
  for (vtkIdType i = 0; i < count; ++i)
  {
    cloud->InsertNextCell(VTK_VERTEX, 1, &i);
  }
  const vtkIdType corners[] = { 0, 1, 2 };
  cloud->InsertNextCell(VTK_TRIANGLE, 3, corners);
  vtkNew<vtkStringArray> crs;
  crs->SetName(vtkHeliosArrayNames::CRS);
  crs->InsertNextValue("EPSG:25832");
  crs->InsertNextValue("another text");
  cloud->GetFieldData()->AddArray(crs);
  return cloud;
}

} // namespace helios

#endif
