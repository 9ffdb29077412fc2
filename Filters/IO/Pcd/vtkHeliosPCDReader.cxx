// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPCDReader.h"

#include "heliosFiniteCheck.h"
#include "heliosInputFile.h"
#include "heliosLineFile.h"
#include "heliosPcdArrays.h"
#include "heliosStatus.h"
#include "heliosTextFile.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <lzf.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <new>
#include <string_view>
#include <vector>

vtkStandardNewMacro(vtkHeliosPCDReader);

namespace
{

constexpr std::uint64_t PointsPerRound = 1 << 14;
constexpr std::uint64_t LargestPage = 1 << 16; // [bytes]
constexpr std::uint64_t MaximumLzfRatio = 100; // 3 bytes encode at most 264

} // namespace

/// Reads one file.
class vtkHeliosPCDReader::Work
{
public:
  Work(vtkHeliosPCDReader* reader, const std::string& path)
    : Reader(reader)
    , Path(path)
  {
  }

  helios::Status Run()
  {
    helios::Status status = helios::CheckInputFile(this->Path);
    if (!status.IsOk())
    {
      return helios::Status::Error(this->Path + ": " + status.Message());
    }
    std::error_code error;
    this->File.open(this->Path, std::ios::binary);
    const auto size = std::filesystem::file_size(this->Path, error);
    if (!this->File || error)
    {
      return helios::Status::Error(this->Path +
        ": cannot be read: " + std::strerror(errno ? errno : ENOENT) + "; check the file name");
    }
    status = this->Header.Read(this->Path, this->File);
    if (!status.IsOk())
    {
      return status;
    }
    this->DataSize = size > this->Header.DataBegin ? size - this->Header.DataBegin : 0;
    status = this->CheckSize();
    if (!status.IsOk())
    {
      return status;
    }
    this->Arrays = std::make_unique<helios::PcdArrays>(this->Header);
    switch (this->Header.Storage)
    {
      case helios::PcdStorage::Ascii:
        return this->ReadLines();
      case helios::PcdStorage::Binary:
        return this->ReadRows();
      default:
        return this->ReadCompressed();
    }
  }

  helios::PcdArrays& GetArrays() { return *this->Arrays; }

  const helios::PcdHeader& GetHeader() const { return this->Header; }

  /// Warning about bytes after the last point; empty: none.
  std::string Warning;

private:
  /// Checks that the file can contain this many points, before allocation.
  helios::Status CheckSize() const
  {
    const std::uint64_t count = this->Header.GetNumberOfPoints();
    const auto columns = static_cast<std::uint64_t>(this->Header.GetNumberOfColumns());
    const std::uint64_t row = this->Header.Storage == helios::PcdStorage::Ascii
      ? 2 * columns // a digit and a blank each; the last line may lack its end
      : this->Header.GetRowSize();
    const std::uint64_t maximum = this->Header.Storage == helios::PcdStorage::Compressed
      ? this->DataSize * MaximumLzfRatio
      : this->DataSize + 1;
    return count == 0 || row <= maximum / count
      ? helios::Status()
      : helios::Status::Error(this->DescribeShort(count * row));
  }

  std::string DescribeShort(std::uint64_t needed) const
  {
    return this->Path + ": has " + std::to_string(this->DataSize) + " bytes of data, but its " +
      std::to_string(this->Header.GetNumberOfPoints()) + " points need " + std::to_string(needed) +
      (this->Header.Storage == helios::PcdStorage::Binary ? "" : " or more") +
      "; it is cut off, or POINTS is wrong";
  }

  bool GoOn(std::uint64_t done)
  {
    const auto count = static_cast<double>(this->Header.GetNumberOfPoints());
    this->Reader->UpdateProgress(count > 0.0 ? static_cast<double>(done) / count : 1.0);
    return !this->Reader->AbortExecute;
  }

  std::string DescribeAbort(std::uint64_t point) const
  {
    return this->Path + ": reading was aborted at point " + std::to_string(point) +
      "; update again to read it";
  }

  helios::Status ReadLines()
  {
    helios::LineFile file;
    const helios::Status opened = file.Open(this->Path);
    if (!opened.IsOk())
    {
      return opened;
    }
    const std::uint64_t count = this->Header.GetNumberOfPoints();
    std::uint64_t done = 0;
    std::int64_t number = this->Header.DataLine;
    file.SetRange(static_cast<std::int64_t>(this->Header.DataBegin), file.GetSize());
    for (std::string_view line; file.NextLine(line); ++number)
    {
      if (line.find_first_not_of(" \t\r") == std::string_view::npos)
      {
        continue;
      }
      helios::Status status = done < count
        ? this->Arrays->AddLine(line)
        : helios::Status::Error(
            "a point more than the " + std::to_string(count) + " of POINTS; correct POINTS");
      if (!status.IsOk())
      {
        return helios::Status::Error(helios::Place(this->Path, number) + status.Message());
      }
      ++done;
      if (done % PointsPerRound == 0 && !this->GoOn(done))
      {
        return helios::Status::Error(this->DescribeAbort(done));
      }
    }
    if (!file.GetError().empty())
    {
      return helios::Status::Error(file.GetError());
    }
    return done == count ? helios::Status()
                         : helios::Status::Error(helios::Place(this->Path, number) +
                             "the file ends after " + std::to_string(done) + " of " +
                             std::to_string(count) + " points; it is cut off, or POINTS is wrong");
  }

  helios::Status ReadRows()
  {
    const std::size_t row = this->Header.GetRowSize();
    const std::uint64_t count = this->Header.GetNumberOfPoints();
    if (count * row > this->DataSize)
    {
      return helios::Status::Error(this->DescribeShort(count * row));
    }
    this->WarnOfRest(count * row);
    std::vector<char> bytes(row * std::min(PointsPerRound, count));
    for (std::uint64_t done = 0; done < count;)
    {
      const std::uint64_t round = std::min(PointsPerRound, count - done);
      if (!this->File.read(bytes.data(), static_cast<std::streamsize>(round * row)))
      {
        return helios::Status::Error(this->Path + ": cannot be read any further; check the disk");
      }
      for (std::uint64_t i = 0; i < round; ++i)
      {
        this->Arrays->AddRow(bytes.data() + i * row);
      }
      done += round;
      if (!this->GoOn(done))
      {
        return helios::Status::Error(this->DescribeAbort(done));
      }
    }
    return {};
  }

  helios::Status ReadCompressed()
  {
    std::uint32_t sizes[2] = { 0, 0 }; // compressed and uncompressed
    const bool hasSizes = this->DataSize >= sizeof(sizes) &&
      this->File.read(reinterpret_cast<char*>(sizes), sizeof(sizes));
    if (!hasSizes || sizes[0] > this->DataSize - sizeof(sizes))
    {
      return helios::Status::Error(this->Path + ": the compressed data need " +
        std::to_string(sizes[0]) + " bytes and two sizes, but the file has " +
        std::to_string(this->DataSize) + " of them; it is cut off");
    }
    const std::uint64_t count = this->Header.GetNumberOfPoints();
    const std::uint64_t size = count * this->Header.GetRowSize();
    if (sizes[1] != size)
    {
      return helios::Status::Error(this->Path + ": the data unpack to " + std::to_string(sizes[1]) +
        " bytes, but " + std::to_string(count) + " points need " + std::to_string(size) +
        "; FIELDS, SIZE, COUNT or POINTS is wrong");
    }
    this->WarnOfRest(sizeof(sizes) + sizes[0]);
    std::vector<char> packed(sizes[0]);
    std::vector<char> data(size);
    if (!this->File.read(packed.data(), sizes[0]))
    {
      return helios::Status::Error(this->Path + ": cannot be read any further; check the disk");
    }
    if (size > 0 && lzf_decompress(packed.data(), sizes[0], data.data(), sizes[1]) != sizes[1])
    {
      return helios::Status::Error(
        this->Path + ": the compressed data are damaged; get or write the file again");
    }
    return this->ReadFields(data, count);
  }

  /// Decodes field by field: the numbers of all points one after the other.
  helios::Status ReadFields(const std::vector<char>& data, std::uint64_t count)
  {
    std::vector<char> row(this->Header.GetRowSize());
    for (std::uint64_t i = 0; i < count; ++i)
    {
      std::size_t to = 0;
      for (const helios::PcdField& field : this->Header.Fields)
      {
        const std::size_t bytes = field.GetBytes();
        std::memcpy(row.data() + to, data.data() + to * count + i * bytes, bytes);
        to += bytes;
      }
      this->Arrays->AddRow(row.data());
      if ((i + 1) % PointsPerRound == 0 && !this->GoOn(i + 1))
      {
        return helios::Status::Error(this->DescribeAbort(i + 1));
      }
    }
    return {};
  }

  /// Zeros up to the end of a page follow the points in files that PCL writes by mapping memory.
  bool IsPadding(std::uint64_t size)
  {
    if (size >= LargestPage)
    {
      return false;
    }
    std::vector<char> rest(size);
    const std::streampos place = this->File.tellg();
    this->File.seekg(-static_cast<std::streamoff>(size), std::ios::end);
    this->File.read(rest.data(), static_cast<std::streamsize>(size));
    this->File.seekg(place);
    return std::all_of(rest.begin(), rest.end(), [](char c) { return c == 0; });
  }

  void WarnOfRest(std::uint64_t used)
  {
    if (used < this->DataSize && !this->IsPadding(this->DataSize - used))
    {
      this->Warning = this->Path + ": " + std::to_string(this->DataSize - used) +
        " bytes after the last point are ignored; is POINTS right?";
    }
  }

  vtkHeliosPCDReader* Reader;
  std::string Path;
  std::ifstream File;
  helios::PcdHeader Header;
  std::uint64_t DataSize = 0;
  std::unique_ptr<helios::PcdArrays> Arrays;
};

//------------------------------------------------------------------------------
vtkHeliosPCDReader::vtkHeliosPCDReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkHeliosPCDReader::~vtkHeliosPCDReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
void vtkHeliosPCDReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}

//------------------------------------------------------------------------------
bool vtkHeliosPCDReader::Read(vtkPolyData* output)
{
  Work work(this, this->FileName);
  const helios::Status status = work.Run();
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return false;
  }
  if (!work.Warning.empty())
  {
    vtkWarningMacro(<< work.Warning);
  }
  helios::PcdArrays& arrays = work.GetArrays();
  if (arrays.GetNumberOfDropped() > 0)
  {
    vtkWarningMacro(<< this->FileName << ": " << arrays.GetNumberOfDropped() << " of "
                    << arrays.GetNumberOfRows() << " points are not finite: dropped");
  }
  if (arrays.GetNumberOfTransparent() > 0)
  {
    vtkWarningMacro(<< this->FileName << ": the alpha of " << arrays.GetNumberOfTransparent()
                    << " colours is dropped");
  }
  if (!work.GetHeader().IsPlainViewpoint())
  {
    vtkWarningMacro(<< this->FileName << ": its VIEWPOINT is not applied, as in PCL; x y z are "
                    << "those of the file");
  }
  const vtkIdType kept = arrays.GetNumberOfRows() - arrays.GetNumberOfDropped();
  arrays.MoveTo(output);
  for (const auto& [name, count] : helios::CountNotFinite(output->GetPointData()))
  {
    vtkWarningMacro(<< this->FileName << ": " << name << " is not finite at " << count << " of "
                    << kept << " points, and is kept so");
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkHeliosPCDReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro(<< "FileName is not set; give the PCD file with SetFileName");
    return 0;
  }
  try
  {
    return this->Read(vtkPolyData::GetData(outputVector)) ? 1 : 0;
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorMacro(<< this->FileName << ": not enough memory for its points; split the file");
  }
  return 0;
}
