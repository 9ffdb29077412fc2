// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Validates VTK XML files before VTK reads them: its readers trust every number in a file, and a
// wrong one terminates the process.

#ifndef heliosVtkXmlFile_h
#define heliosVtkXmlFile_h

#include "heliosStatus.h"
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
    Other,  // not VTK XML of the type, or not XML
    Single, // contains data
    Index   // lists pieces
  };

  /// Reads the elements of a file of "PolyData" or "Table", and checks all data attributes: counts,
  /// types, offsets and sizes. False: see GetProblem().
  bool Open(const std::string& path, const std::string& type);

  Kind GetKind() const { return this->FileKind; }

  /// Returns the number of points or rows of a single file.
  vtkIdType GetNumberOfRecords() const { return this->NumberOfRecords; }

  /// Files listed by an index.
  const std::vector<std::string>& GetPieces() const { return this->Pieces; }

  /// Returns an error message with a remedy, without the file name.
  const std::string& GetProblem() const { return this->Problem; }

private:
  Kind FileKind = Kind::Other;
  vtkIdType NumberOfRecords = 0;
  std::vector<std::string> Pieces;
  std::string Problem;
};

/// Returns the maximum total size of decoded arrays [bytes], for a given file size.
VTKHELIOSFILTERSIO_EXPORT double GetVtkXmlMemoryLimit(double fileSize);

/// Calls a function of a VTK reader; returns an error with the message of its exception.
template <typename FunctionT>
Status CatchExceptions(FunctionT&& function)
{
  try
  {
    function();
  }
  catch (const std::bad_alloc&)
  {
    return Status::Error("there is not enough memory");
  }
  catch (const std::exception& problem)
  {
    return Status::Error(problem.what());
  }
  return {};
}

} // namespace helios

#endif
