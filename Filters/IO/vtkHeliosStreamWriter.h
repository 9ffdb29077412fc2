// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosStreamWriter
 * @brief   writes a run block by block
 *
 * Open(), Write() once a block, then Close() where all is well or Abandon()
 * where it is not. Blocks go to <FileName>.part, which Close() renames to
 * FileName; the .part holds whole blocks at any moment. Memory does not grow
 * with the number of records. Folders above FileName are made.
 *
 * All return false after an error: a folder that cannot be made, a file that
 * cannot be written (a full disk: the block that did not fit is taken back, and
 * the message says how many records are safe), a block of the wrong type or
 * without an array that is needed.
 *
 * To add a text format: subclass, implement Write() with WriteRows().
 *
 * @sa
 * vtkHeliosPointTextWriter vtkHeliosPointXMLWriter
 */

#ifndef vtkHeliosStreamWriter_h
#define vtkHeliosStreamWriter_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkObject.h"

#include <functional> // For the rows of a block
#include <memory>     // For the file

class vtkDataArray;
class vtkDataObject;
class vtkFieldData;

namespace helios
{
class PartFile;
class TextBuffer;
}

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosStreamWriter : public vtkObject
{
public:
  vtkTypeMacro(vtkHeliosStreamWriter, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the name of the finished file. No default: an error without.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Starts an empty file.
   */
  virtual bool Open();

  /**
   * Appends a block.
   */
  virtual bool Write(vtkDataObject* block) = 0;

  /**
   * Ends the file and gives it its final name.
   */
  virtual bool Close();

  /**
   * Ends the file and leaves it under its .part name, whole up to the last
   * block.
   */
  virtual bool Abandon();

  ///@{
  /**
   * Get what was written since Open().
   */
  vtkGetMacro(NumberOfRecords, vtkIdType);
  vtkGetMacro(NumberOfBytes, vtkIdType);
  ///@}

protected:
  vtkHeliosStreamWriter();
  ~vtkHeliosStreamWriter() override;

  /// Whether Open() came before; an error else.
  bool CheckOpen();

  /// The array of a block, or null after an error that names it.
  vtkDataArray* GetArray(vtkFieldData* data, const char* name, int components);

  /// Appends bytes; where they do not fit, they are taken back.
  bool AppendBytes(const char* bytes, std::size_t count);

  /// Appends count rows of text, formatted by any threads, in order.
  bool WriteRows(
    vtkIdType count, const std::function<void(vtkIdType row, helios::TextBuffer& text)>& format);

  char* FileName = nullptr;
  vtkIdType NumberOfRecords = 0;
  vtkIdType NumberOfBytes = 0;
  bool IsOpen = false;

private:
  vtkHeliosStreamWriter(const vtkHeliosStreamWriter&) = delete;
  void operator=(const vtkHeliosStreamWriter&) = delete;

  std::unique_ptr<helios::PartFile> File;
};

#endif
