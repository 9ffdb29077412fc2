// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRunPartReader.h"

#include "heliosMessages.h"
#include "heliosRunFingerprint.h"
#include "vtkHeliosPointXMLReader.h"
#include "vtkHeliosRayCaster.h"
#include "vtkHeliosWaveformXMLReader.h"
#include "vtkHeliosXMLPieceWriter.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <algorithm>
#include <numeric>

namespace helios
{

namespace
{

/// Reads a piece; null after an error.
template <typename ReaderT>
vtkSmartPointer<vtkDataObject> ReadXml(const std::string& path, Messages& log)
{
  vtkNew<ReaderT> reader;
  log.Listen(reader);
  reader->SetFileName(path.c_str());
  const int errors = log.GetNumberOfErrors();
  reader->Update();
  return log.GetNumberOfErrors() == errors ? reader->GetOutputDataObject(0) : nullptr;
}

} // namespace

//------------------------------------------------------------------------------
RunPartReader::RunPartReader(const SurveyData& survey, const RunSettings& settings, Messages& log)
  : Files(survey, MakeRunPartSettings(settings))
  , Log(log)
{
}

//------------------------------------------------------------------------------
RunPartReader::~RunPartReader() = default;

//------------------------------------------------------------------------------
Status RunPartReader::Open(const std::vector<std::string>& folders)
{
  this->Parts.clear();
  for (const std::string& folder : folders)
  {
    this->Parts.emplace_back(folder);
    if (Status status = this->Parts.back().Read(); !status.IsOk())
    {
      return status;
    }
  }
  const Status status = this->Sort();
  return status.IsOk() ? this->FindMissing() : status;
}

//------------------------------------------------------------------------------
/// Sorts the parts by number; an error if two have the same, or are of another division.
Status RunPartReader::Sort()
{
  const auto number = [](const RunPartFolder& part) { return part.GetPart().Number; };
  std::stable_sort(this->Parts.begin(), this->Parts.end(),
    [&number](const RunPartFolder& a, const RunPartFolder& b) { return number(a) < number(b); });
  for (std::size_t i = 1; i < this->Parts.size(); ++i)
  {
    const RunPartFolder& part = this->Parts[i];
    const RunPartFolder& before = this->Parts[i - 1];
    if (part.GetPart().Count != this->Parts.front().GetPart().Count)
    {
      return Status::Error(part.Describe() + " cannot be joined with " +
        this->Parts.front().Describe() + "; give the parts of one division of a run");
    }
    if (number(part) == number(before))
    {
      return Status::Error(
        part.Describe() + " is given twice, also by " + before.Describe() + "; give one of them");
    }
  }
  return {};
}

//------------------------------------------------------------------------------
Status RunPartReader::FindMissing() const
{
  std::vector<std::string> missing;
  RunPart part = this->Parts.empty() ? RunPart() : this->Parts.front().GetPart();
  auto next = this->Parts.begin();
  for (part.Number = 1; part.Number <= part.Count; ++part.Number)
  {
    const bool isThere = next != this->Parts.end() && next->GetPart().Number == part.Number;
    next += isThere ? 1 : 0;
    if (!isThere)
    {
      missing.push_back(part.GetText());
    }
  }
  return missing.empty()
    ? Status()
    : Status::Error((missing.size() > 1 ? "parts " : "part ") + JoinChoices(missing) +
        (missing.size() > 1 ? " are" : " is") +
        " missing; give all folders of the run, or run what is missing with --part");
}

//------------------------------------------------------------------------------
Status RunPartReader::CheckFingerprints(const Json::Value& fingerprint) const
{
  for (const RunPartFolder& part : this->Parts)
  {
    const std::string difference = CompareFingerprints(part.GetFingerprint(), fingerprint);
    if (!difference.empty())
    {
      return Status::Error(part.Describe() + " cannot be joined, since " + difference +
        "; join and run all parts with the same inputs, options and version");
    }
  }
  return {};
}

//------------------------------------------------------------------------------
Status RunPartReader::FindBlocks(const std::vector<LegPlan>& plans)
{
  this->Blocks.clear();
  for (const RunPartFolder& part : this->Parts)
  {
    if (Status status = part.Check(plans); !status.IsOk())
    {
      return status;
    }
    for (const RunPartBlock& block : part.GetBlocks())
    {
      this->Blocks.push_back({ &part, &block });
    }
  }
  std::size_t first = 0;
  for (const LegPlan& plan : plans)
  {
    this->FirstBlock[plan.Leg] = first;
    first += static_cast<std::size_t>(plan.NumberOfBlocks);
  }
  return {};
}

//------------------------------------------------------------------------------
double RunPartReader::GetSeconds() const
{
  return std::accumulate(this->Parts.begin(), this->Parts.end(), 0.0,
    [](double sum, const RunPartFolder& part) { return sum + part.GetSeconds(); });
}

//------------------------------------------------------------------------------
bool RunPartReader::Check(const Status& status)
{
  if (!status.IsOk())
  {
    this->Log.Error(status.Message());
  }
  return status.IsOk();
}

//------------------------------------------------------------------------------
/// Finds the section of a file in the current block.
FileProgress RunPartReader::FindFile(const LegOutput& file) const
{
  const std::string name = GetName(file.Writer);
  const auto& files = this->Current->Data->Files;
  const auto found = std::find_if(
    files.begin(), files.end(), [&name](const FileProgress& each) { return each.Name == name; });
  return found == files.end() ? FileProgress() : *found;
}

//------------------------------------------------------------------------------
bool RunPartReader::Compute(const LegPlan& plan, vtkIdType block, vtkIdType)
{
  this->Current = &this->Blocks[this->FirstBlock.at(plan.Leg) + static_cast<std::size_t>(block)];
  this->CurrentFiles = this->Files.MakeOutputs(plan);
  this->Pieces.clear();
  return std::all_of(this->CurrentFiles.begin(), this->CurrentFiles.end(),
    [this](const LegOutput& file) { return this->ReadPiece(file); });
}

//------------------------------------------------------------------------------
/// Checks the bytes of a file in the current block, and reads the bytes of VTK XML.
bool RunPartReader::ReadPiece(const LegOutput& file)
{
  for (const FileBlock& block : this->FindFile(file).Blocks)
  {
    if (!this->Check(this->Current->Part->CheckBlock(block)))
    {
      return false;
    }
    if (!IsXml(file) || !block.IsWhole)
    {
      continue; // rows, or an index
    }
    const std::string path = this->Current->Part->FindFile(block.Name);
    const vtkSmartPointer<vtkDataObject> piece = file.Port == WaveformPort
      ? ReadXml<vtkHeliosWaveformXMLReader>(path, this->Log)
      : ReadXml<vtkHeliosPointXMLReader>(path, this->Log);
    if (!piece)
    {
      return false;
    }
    this->Pieces[{ file.Port, file.Channel }] = piece;
  }
  return true;
}

//------------------------------------------------------------------------------
LegPiece RunPartReader::Collect(const LegOutputs& outputs)
{
  LegPiece piece;
  for (const LegOutput& output : outputs)
  {
    piece.push_back(this->CollectOne(output));
  }
  return piece;
}

//------------------------------------------------------------------------------
/// Returns the data of VTK XML, or the rows of text.
OutputPiece RunPartReader::CollectOne(const LegOutput& output)
{
  const LegOutput& file = FindOutput(this->CurrentFiles, output);
  if (IsXml(file))
  {
    return CollectPiece(output,
      [this](int port, std::size_t channel) {
        return this->Pieces[{ port, channel }];
      });
  }
  const FileProgress progress = this->FindFile(file);
  OutputPiece piece;
  if (!progress.Blocks.empty())
  {
    piece.Rows = { progress.Records, this->Current->Part->FindFile(progress.Name),
      progress.Blocks.front(), {} };
  }
  return piece;
}

//------------------------------------------------------------------------------
void RunPartReader::Count(ScanCounts& counts)
{
  counts.Add(this->Current->Data->Counts);
  this->Pieces.clear();
}

} // namespace helios
