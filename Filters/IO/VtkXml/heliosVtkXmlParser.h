// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The VTK parser of XML files, with limits, and access to the data headers.

#ifndef heliosVtkXmlParser_h
#define heliosVtkXmlParser_h

#include "heliosStatus.h"

#include <vtkXMLDataParser.h>

#include <string>

class vtkInputStream;

namespace helios
{

class VtkXmlParser : public vtkXMLDataParser
{
public:
  static VtkXmlParser* New();
  vtkTypeMacro(VtkXmlParser, vtkXMLDataParser);

  /// Returns the root element of the stream; null: see GetProblem().
  vtkXMLDataElement* ParseFile(double size);
  const std::string& GetProblem() const { return this->Problem; }

  /// Sets the compressor named by the root; false if it is unknown.
  bool SetCompressorOf(vtkXMLDataElement* root);

  /// Checks the data of an array with n values and bytes.
  Status CheckData(vtkXMLDataElement* array, double values, double bytes, double limit);

  /// Returns whether a checked array has this many terminated strings: VTK writes as many as it
  /// finds.
  bool HasTexts(vtkXMLDataElement* array, double count);

  /// Reads one number of a checked array.
  bool ReadNumber(vtkXMLDataElement* array, vtkTypeInt64 index, int type, double& number);

protected:
  VtkXmlParser() = default;
  ~VtkXmlParser() override = default;

  void StartElement(const char* name, const char** attributes) override;
  void EndElement(const char* name) override;
  int ParseBuffer(const char* buffer, unsigned int count) override;
  void ReportXmlParseError() override;

private:
  VtkXmlParser(const VtkXmlParser&) = delete;
  void operator=(const VtkXmlParser&) = delete;

  Status CheckHead(vtkInputStream* stream, double bytes, double room, double limit);
  bool ReadWords(vtkInputStream* stream, std::size_t count, vtkTypeUInt64* words);

  std::size_t Read(
    vtkXMLDataElement* array, void* words, vtkTypeUInt64 first, std::size_t count, int type);

  std::string Problem;
  double Size = 0.0;
  double Total = 0.0; // total size of the last checked array [bytes]
  int Depth = 0;
};

} // namespace helios

#endif
