// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// VTK's own parser of its XML files, with limits, and a look at the heads of the data.

#ifndef heliosVtkXmlParser_h
#define heliosVtkXmlParser_h

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

  /// The root of the stream's elements; null: see GetProblem().
  vtkXMLDataElement* ParseFile(double size);
  const std::string& GetProblem() const { return this->Problem; }

  /// False where the compressor that the root names is not known.
  bool SetCompressorOf(vtkXMLDataElement* root);

  /// What is wrong with the data of an array of so many values and bytes, or an empty text.
  std::string CheckData(vtkXMLDataElement* array, double values, double bytes, double limit);

  /// Whether an array that was checked has so many texts, each with its end: VTK writes as many as it finds.
  bool HasTexts(vtkXMLDataElement* array, double count);

  /// One number of an array that was checked.
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

  std::string CheckHead(vtkInputStream* stream, double bytes, double room, double limit);
  bool ReadWords(vtkInputStream* stream, std::size_t count, vtkTypeUInt64* words);

  std::size_t Read(
    vtkXMLDataElement* array, void* words, vtkTypeUInt64 first, std::size_t count, int type);

  std::string Problem;
  double Size = 0.0;
  double Total = 0.0; // of the array that was checked last [bytes]
  int Depth = 0;
};

} // namespace helios

#endif
