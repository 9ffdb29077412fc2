// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The numbers of a polygon file (PLY), in their order, from text or binary data.

#ifndef heliosPlySource_h
#define heliosPlySource_h

#include "heliosPlyHeader.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace helios
{

/// Numbers by rows; each call returns false after an error, which GetError() describes.
class PlySource
{
public:
  virtual ~PlySource() = default;

  /// Starts the next row of an element.
  virtual bool StartRow() = 0;

  /// Reads the next number of the row.
  virtual bool Read(PlyType type, double& value) = 0;

  /// Reads the next numbers of the row.
  virtual bool ReadAll(const std::vector<PlyType>& types, double* values)
  {
    return std::all_of(types.begin(), types.end(),
      [this, &values](PlyType type) { return this->Read(type, *values++); });
  }

  /// Ends the row.
  virtual bool EndRow() = 0;

  /// Names the next row in messages: "path:line: ", or "path: vertex 12: ".
  virtual std::string GetPlace(const std::string& element, std::int64_t row) const = 0;

  /// Returns the number of bytes after the last row; text: of lines.
  virtual std::int64_t CountRest() = 0;

  const std::string& GetError() const { return this->Error; }

protected:
  bool Fail(const std::string& message)
  {
    this->Error = message;
    return false;
  }

private:
  std::string Error;
};

/// Opens the data of a file after its header; null after an error.
std::unique_ptr<PlySource> OpenPlySource(
  const std::string& path, const PlyHeader& header, std::string& error);

} // namespace helios

#endif
