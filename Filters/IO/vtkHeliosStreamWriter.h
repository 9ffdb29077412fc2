// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosStreamWriter
 * @brief   writes a run block by block
 *
 * Open(), Write() once a block, then Close() where all is well or Abandon()
 * where it is not. Blocks go to <FileName>.part, which Close() renames to
 * FileName; the .part holds whole blocks at any moment but during Write().
 * Folders above FileName are made. Memory does not grow with the number of
 * records; a block is formatted by the threads of vtkSMPTools, to the same
 * bytes for any number of them.
 *
 * Text writers leave out records with a number that is not finite, and warn
 * with their count.
 *
 * All return false after an error: a folder that cannot be made, a file that
 * cannot be written (a full disk: the block that did not fit is taken back,
 * the message says how many records are safe, and no more blocks are taken), a
 * block of the wrong type or without an array that is needed (nothing of it is
 * written, and the next block may follow).
 *
 * To add a text format: subclass, implement Write() with WriteRows().
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
   * Set/Get the name of the finished file, as Open() takes it. No default: an
   * error without.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Starts an empty file. An error while another one is open.
   */
  virtual bool Open();

  /**
   * Goes on with the file that an earlier run left, as .part or under its final
   * name, cut to a size [bytes]; the numbers of records and bytes are what they
   * were then. An error where it is shorter.
   */
  virtual bool Reopen(vtkIdType fileSize, vtkIdType numberOfRecords, vtkIdType numberOfBytes);

  ///@{
  /**
   * Set/Get whether blocks are formatted and counted, and nothing is written: no
   * file, no folder. As Open() takes it. Default: off.
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
   * Returns when the disk has all blocks: then no power cut takes them away. An
   * error, too, where the file was removed meanwhile.
   */
  bool Flush();

  /**
   * As Flush(), but says what went wrong instead of an error; empty: nothing. Any
   * thread may call it while no other one uses the writer.
   */
  virtual std::string Sync();

  /**
   * Ends the file and gives it its final name. After a block that could not be
   * written: an error, and the file keeps its .part name.
   */
  virtual bool Close();

  /**
   * Ends the file, if one is open, and leaves it under its .part name, whole up
   * to the last block.
   */
  virtual bool Abandon();

  /**
   * Whether Open() came, and neither Close() nor Abandon() since.
   */
  bool IsOpen() const;

  ///@{
  /**
   * Get what whole blocks were written since Open(): records, bytes in all files,
   * and the size of the file that is open [bytes].
   */
  vtkGetMacro(NumberOfRecords, vtkIdType);
  vtkGetMacro(NumberOfBytes, vtkIdType);
  vtkIdType GetFileSize() const;
  ///@}

#ifndef __VTK_WRAP__
  /**
   * What was written since this was called last, or since Open() or Reopen(): the
   * bytes in every file, and their checksums.
   */
  virtual std::vector<helios::FileBlock> TakeBlocks();

  ///@{
  /**
   * Get the checksum of what is written over by every block, the head of the file;
   * empty: there is no head. After Reopen(), Restore brings back the head that has
   * a checksum; false where that is not possible.
   */
  virtual std::string GetHeadChecksum() const;
  virtual bool RestoreHead(const std::string& checksum);
  ///@}
#endif

protected:
  vtkHeliosStreamWriter();
  ~vtkHeliosStreamWriter() override;

  /// Where blocks come from, for messages: a plural.
  virtual const char* GetBlockSource() const = 0;

  /// Where the records are that were written, for messages.
  virtual std::string GetSafePlace() const;

  /// The file name that Open() took.
  const std::string& GetOpenName() const;

  /// Whether a block may come; an error else.
  bool CheckOpen();

  /// The block as points of doubles, or null after an error.
  vtkPolyData* GetPoints(vtkDataObject* block);

  /// An error about a block that is not what it must be.
  void RefuseBlock(vtkDataObject* block, const char* type);

  ///@{
  /**
   * Takes an array of a block: numbers, with so many tuples and components; or
   * integers, one a tuple. False after an error that names the array.
   */
  bool GetNumbers(
    vtkFieldData* data, const char* name, vtkIdType tuples, int components, helios::Column& column);
  bool GetIntegers(vtkFieldData* data, const char* name, vtkIdType tuples, helios::Column& column);
  ///@}

  /// Appends a block of text rows, formatted by any threads, in order. bytesPerRow is a guess.
  bool WriteRows(vtkIdType count, vtkIdType bytesPerRow,
    const std::function<void(vtkIdType row, helios::TextBuffer& text)>& format);

  /// An error about what was asked of the file. Returns false.
  bool FailFile(const std::string& problem);

  /// What was written so far begins no block: it is written over.
  void EndHead();

  /// Appends text that has no records.
  bool WriteText(const std::string& text);

  /// Appends bytes of a block that started at a size; where that fails, takes the block back.
  bool WriteBytes(const char* bytes, std::size_t count, vtkIdType start);

  /// Writes over bytes of the file.
  bool OverwriteBytes(vtkIdType place, const std::string& bytes);

  /// Takes back what was written beyond a size; the next block may follow.
  bool TakeBack(vtkIdType size);

  /// Takes back what was written beyond a size and takes no more blocks; an error. Returns false.
  bool FailBlock(std::string problem, vtkIdType size);

  char* FileName = nullptr;
  vtkIdType NumberOfRecords = 0;
  vtkIdType NumberOfBytes = 0;
  bool CountOnly = false;

private:
  vtkHeliosStreamWriter(const vtkHeliosStreamWriter&) = delete;
  void operator=(const vtkHeliosStreamWriter&) = delete;

  bool PrepareOpen();
  std::string DescribeKept() const;

  std::unique_ptr<helios::PartFile> File;
  bool HasFailed = false; // since Open()
};

#endif
