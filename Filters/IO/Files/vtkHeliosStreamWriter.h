// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosStreamWriter
 * @brief   write a run block by block
 *
 * Call Open(), Write() once per block, then Close() on success or Abandon() on failure. Blocks are
 * written to <FileName>.part, which Close() renames to FileName; except during Write(), the .part
 * contains complete blocks only. Parent folders of FileName are created. Memory does not grow with
 * the number of records. A block is formatted in parallel by vtkSMPTools; the output is
 * byte-identical for any number of threads.
 *
 * Text writers drop records with non-finite numbers; a warning gives the count.
 *
 * All return false after an error: a folder that cannot be created, a file that cannot be written
 * (disk full: the incomplete block is removed, the message gives the number of records saved, and
 * no more blocks are accepted), a block of the wrong type or without a required array (the whole
 * block is refused, and the next block is accepted).
 *
 * To add a text format, subclass and implement Write() with WriteRows().
 *
 * @sa
 * vtkHeliosPointTextWriter vtkHeliosPointXMLWriter vtkHeliosTrajectoryTextWriter
 * vtkHeliosWaveformTextWriter
 */

#ifndef vtkHeliosStreamWriter_h
#define vtkHeliosStreamWriter_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkObject.h"

#include <functional> // For the rows of a block
#include <memory>     // For the file
#include <string>     // For names and messages
#include <vector>     // For blocks

class vtkDataObject;
class vtkFieldData;
class vtkPolyData;

namespace helios
{
class Column;
class PartFile;
class TextBuffer;
struct FileBlock;
}

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosStreamWriter : public vtkObject
{
public:
  vtkTypeMacro(vtkHeliosStreamWriter, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the name of the finished file, applied by Open(). Required.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Returns the ending of the names of files that are not complete: ".part".
   */
  static const char* GetPartEnding();

  /**
   * Creates an empty file. Fails if another file is open.
   */
  virtual bool Open();

  /**
   * Resumes the file that an earlier run left, as .part or under its final name, truncated to a
   * size [bytes]; the numbers of records and bytes are those at that size. Fails if the file is
   * shorter.
   */
  virtual bool Reopen(vtkIdType fileSize, vtkIdType numberOfRecords, vtkIdType numberOfBytes);

  ///@{
  /**
   * Set/Get whether blocks are only formatted and counted, without creating a
   * file or folder. Applied by Open(). Default: off.
   */
  vtkSetMacro(CountOnly, bool);
  vtkGetMacro(CountOnly, bool);
  vtkBooleanMacro(CountOnly, bool);
  ///@}

  /**
   * Appends a block.
   */
  virtual bool Write(vtkDataObject* block) = 0;

  /**
   * Ends a block that can be resumed after: writes what the format keeps in memory. Default: nothing.
   */
  virtual bool EndBlock() { return true; }

  /**
   * Flushes all blocks to disk (fsync), so that a power failure cannot lose them. Fails also if the
   * file was removed in the meantime.
   */
  bool Flush();

  /**
   * Flushes like Flush(), but returns the error message, empty after success. May be called from
   * any thread. Another thread may write meanwhile, except to the pieces of VTK XML.
   */
  virtual std::string Sync();

  /**
   * Closes the file and gives it its final name. If a block could not be written, this is an error,
   * and the file keeps its .part name.
   */
  virtual bool Close();

  /**
   * Closes the file, if one is open, and keeps its .part name; it is complete up to the last block.
   */
  virtual bool Abandon();

  /**
   * Returns whether Open() was called, and neither Close() nor Abandon() since.
   */
  bool IsOpen() const;

  ///@{
  /**
   * Get the amount of complete blocks written since Open(): records, bytes in all files, and the
   * size of the open file [bytes].
   */
  vtkGetMacro(NumberOfRecords, vtkIdType);
  vtkGetMacro(NumberOfBytes, vtkIdType);
  vtkIdType GetFileSize() const;
  ///@}

#ifndef __VTK_WRAP__
  ///@{
  /**
   * Appends the rows of a block of another file of the same text format, or of a text, and their
   * number.
   */
  bool CopyRows(const std::string& path, const helios::FileBlock& block, vtkIdType count);
  bool CopyRows(const std::string& rows, vtkIdType count);
  ///@}

  /**
   * Sets a text to which, with CountOnly, the text of every block is appended: rows, or a piece of
   * VTK XML without its index. It must exist until the file is closed. Null: to no text. Default:
   * null.
   */
  void SetBlockText(std::string* text)
  {
    this->BlockText = text;
  }

  /**
   * Returns and clears the blocks written since the last call, Open() or Reopen(): the bytes in
   * every file, and their checksums.
   */
  virtual std::vector<helios::FileBlock> CollectBlocks();

  ///@{
  /**
   * Returns the checksum of the file head, which every block overwrites; empty: no head. After
   * Reopen(), Restore recovers the head with a given checksum; false if that is not possible.
   */
  virtual std::string GetHeadChecksum() const;
  virtual bool RestoreHead(const std::string& checksum);
  ///@}
#endif

protected:
  vtkHeliosStreamWriter();
  ~vtkHeliosStreamWriter() override;

  /// Returns the source of the blocks, for messages: a plural.
  virtual const char* GetBlockSource() const = 0;

  /// Returns the location of the written records, for messages.
  virtual std::string GetSafePlace() const;

  /// Returns the file name applied by Open().
  const std::string& GetOpenName() const;

  /// Returns whether a block is accepted; reports an error otherwise.
  bool CheckOpen();

  /// Returns the block as double points, or null after an error.
  vtkPolyData* GetPoints(vtkDataObject* block);

  /// Reports an error about an invalid block.
  void RefuseBlock(vtkDataObject* block, const char* type);

  ///@{
  /**
   * Gets an array of a block: numeric, with the given tuples and components; or
   * integer, one component. Returns false after an error that names the array.
   */
  bool GetNumbers(
    vtkFieldData* data, const char* name, vtkIdType tuples, int components, helios::Column& column);
  bool GetIntegers(vtkFieldData* data, const char* name, vtkIdType tuples, helios::Column& column);
  ///@}

  /// Appends a block of text rows, formatted in parallel, in order. bytesPerRow is an estimate.
  bool WriteRows(vtkIdType count, vtkIdType bytesPerRow,
    const std::function<void(vtkIdType row, helios::TextBuffer& text)>& format);

  /// Reports an error about the file request. Returns false.
  bool FailFile(const std::string& problem);

  /// Marks the bytes written so far as the head, which is overwritten and part of no block.
  void EndHead();

  /// Appends text without records.
  bool WriteText(const std::string& text);

  /// Appends bytes of a block that started at a size; removes the block on failure.
  bool WriteBytes(const char* bytes, std::size_t count, vtkIdType start);

  /// Overwrites bytes of the file.
  bool OverwriteBytes(vtkIdType place, const std::string& bytes);

  /// Closes the file as .part, and gives its final name to another one that was made of it.
  bool ReplaceBy(const std::string& made);

  /// Truncates the file to a size; the next block is accepted.
  bool TruncateTo(vtkIdType size);

  /// Truncates the file to a size, accepts no more blocks and reports an error. Returns false.
  bool FailBlock(std::string problem, vtkIdType size);

  char* FileName = nullptr;
  vtkIdType NumberOfRecords = 0;
  vtkIdType NumberOfBytes = 0;
  bool CountOnly = false;
  std::string* BlockText = nullptr;

private:
  vtkHeliosStreamWriter(const vtkHeliosStreamWriter&) = delete;
  void operator=(const vtkHeliosStreamWriter&) = delete;

  bool PrepareOpen();
  std::string DescribeKept() const;

  std::unique_ptr<helios::PartFile> File;
  bool HasFailed = false; // since Open()
};

#endif
