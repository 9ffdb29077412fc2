// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// VTK XML files are checked before VTK reads them: its readers believe every number of a file, and
// a wrong one ends the process.

#ifndef heliosVtkXmlFile_h
#define heliosVtkXmlFile_h

#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <vtkType.h>

#include <exception>
#include <string>
#include <vector>

namespace helios
{

class VTKHELIOSFILTERSIO_EXPORT VtkXmlFile
{
public:
  enum class Kind
  {
    Other,  // no VTK XML file of the type, or no XML at all
    Single, // with data
    Index   // a file that names pieces
  };

  /// Reads the elements of a file of "PolyData" or "Table", and checks all that they say about data:
  /// counts, types, places and sizes. False: see GetProblem().
  bool Open(const std::string& path, const std::string& type);

  Kind GetKind() const { return this->FileKind; }

  /// The points or rows of a single file.
  vtkIdType GetNumberOfRecords() const { return this->NumberOfRecords; }

  /// The files that an index names.
  const std::vector<std::string>& GetPieces() const { return this->Pieces; }

  /// What is wrong, without the file's name; with the cure.
  const std::string& GetProblem() const { return this->Problem; }

private:
  Kind FileKind = Kind::Other;
  vtkIdType NumberOfRecords = 0;
  std::vector<std::string> Pieces;
  std::string Problem;
};

/// What the bytes of decoded arrays may add up to, for a file of a size.
VTKHELIOSFILTERSIO_EXPORT double GetVtkXmlMemoryLimit(double fileSize);

/// Calls a function of VTK's readers; the words of an exception, or an empty text.
template <typename FunctionT>
std::string CatchExceptions(FunctionT&& function)
{
  try
  {
    function();
  }
  catch (const std::bad_alloc&)
  {
    return "there is not enough memory";
  }
  catch (const std::exception& problem)
  {
    return problem.what();
  }
  return {};
}

} // namespace helios

#endif
