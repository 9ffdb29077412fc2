// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosEchoDetection.h"

#include "heliosDetectorOffset.h"
#include "heliosDetectorPlugin.h"
#include "heliosDetectorRegistry.h"
#include "heliosPose.h"
#include "heliosPulseShape.h"
#include "heliosPulseTable.h"
#include "heliosReturnSelection.h"
#include "heliosStatus.h"
#include "heliosWaveformTable.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosPeakDetector.h"

#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkTable.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkHeliosEchoDetection);

namespace names = vtkHeliosArrayNames;

namespace
{

// Waveforms per task, and such chunks of each thread between two checks for progress and abort,
// about 0.1 s.
constexpr vtkIdType RowsPerChunk = 256;
constexpr vtkIdType ChunksOfThread = 8;

struct Record
{
  vtkHeliosDetectedEcho Echo;
  double Range;
  vtkIdType Row;
  unsigned char ReturnNumber;
  unsigned char NumberOfReturns;
};

helios::Vec3 GetVector(const helios::Column& column, vtkIdType row)
{
  return { column.GetNumber(row, 0), column.GetNumber(row, 1), column.GetNumber(row, 2) };
}

/// Adds an array of a type to the points' data.
template <typename ArrayT>
typename ArrayT::ValueType* AddColumn(vtkPolyData* output, const char* name, vtkIdType count)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfTuples(count);
  output->GetPointData()->AddArray(array);
  return array->GetPointer(0);
}

} // namespace

/// Input and results of a run over a table.
struct vtkHeliosEchoDetection::Run
{
  const vtkHeliosEchoDetector* Detector = nullptr;
  helios::WaveformTable Table;
  const float* Samples = nullptr;
  std::vector<float> Converted; // if the table's are of another type
  double PulseLength = 0.0;
  double Offset = 0.0; // how late the detector finds a plane [ns]
  std::uint64_t Seed = 0;
  int Selection = 0;
  int Maximum = 0;
  std::vector<std::vector<Record>> Chunks;
  std::vector<helios::Status> Faults; // one of each chunk

  void ReadSamples(vtkDataArray* array);
  vtkHeliosWaveform GetWaveform(vtkIdType row) const;
  helios::Status DetectChunk(vtkIdType chunk);
  void AddRecords(vtkIdType row, const std::vector<vtkHeliosDetectedEcho>& echoes,
    std::vector<std::size_t>& kept, std::vector<Record>& records) const;
  void DetectChunks(vtkIdType begin, vtkIdType end);
  void Fill(vtkPolyData* output) const;
  void FillIds(vtkTable* table, vtkPolyData* output) const;
};

//------------------------------------------------------------------------------
void vtkHeliosEchoDetection::Run::ReadSamples(vtkDataArray* array)
{
  if (auto* floats = vtkFloatArray::SafeDownCast(array))
  {
    this->Samples = floats->GetPointer(0);
    return;
  }
  this->Converted.resize(static_cast<std::size_t>(this->Table.NumberOfSamples));
  for (std::size_t i = 0; i < this->Converted.size(); ++i)
  {
    this->Converted[i] =
      static_cast<float>(this->Table.Samples.GetNumber(static_cast<vtkIdType>(i)));
  }
  this->Samples = this->Converted.data();
}

//------------------------------------------------------------------------------
vtkHeliosWaveform vtkHeliosEchoDetection::Run::GetWaveform(vtkIdType row) const
{
  return { this->Samples + this->Table.Offset.GetInteger(row), this->Table.Count.GetInteger(row),
    this->Table.BinSize.GetNumber(row), this->PulseLength, 0.0, 0.0, this->Seed,
    static_cast<std::uint64_t>(this->Table.PulseIds.GetInteger(row)) };
}

//------------------------------------------------------------------------------
/// Detects the echoes of a chunk; returns the error of the detector.
helios::Status vtkHeliosEchoDetection::Run::DetectChunk(vtkIdType chunk)
{
  const vtkIdType first = chunk * RowsPerChunk;
  const vtkIdType last = std::min(this->Table.NumberOfRows, first + RowsPerChunk);
  std::vector<vtkHeliosWaveform> waveforms;
  for (vtkIdType row = first; row < last; ++row)
  {
    waveforms.push_back(this->GetWaveform(row));
  }
  std::vector<vtkHeliosEchoDetector::Echoes> echoes(waveforms.size());
  if (std::string error; !this->Detector->DetectAll(waveforms, echoes, error))
  {
    return helios::Status::Error(error);
  }
  std::vector<std::size_t> kept;
  for (vtkIdType row = first; row < last; ++row)
  {
    this->AddRecords(row, echoes[static_cast<std::size_t>(row - first)], kept,
      this->Chunks[static_cast<std::size_t>(chunk)]);
  }
  return {};
}

//------------------------------------------------------------------------------
/// Adds the echoes of a row that are kept.
void vtkHeliosEchoDetection::Run::AddRecords(vtkIdType row,
  const std::vector<vtkHeliosDetectedEcho>& echoes, std::vector<std::size_t>& kept,
  std::vector<Record>& records) const
{
  helios::SelectReturns(echoes, this->Selection, this->Maximum, kept);
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    const vtkHeliosDetectedEcho& echo = echoes[kept[i]];
    records.push_back(
      { echo, helios::GetRange(this->Table.StartTime.GetNumber(row), echo.Time - this->Offset), row,
        static_cast<unsigned char>(i + 1), static_cast<unsigned char>(kept.size()) });
  }
}

//------------------------------------------------------------------------------
void vtkHeliosEchoDetection::Run::DetectChunks(vtkIdType begin, vtkIdType end)
{
  for (vtkIdType chunk = begin; chunk < end; ++chunk)
  {
    this->Faults[static_cast<std::size_t>(chunk)] = this->DetectChunk(chunk);
  }
}

//------------------------------------------------------------------------------
void vtkHeliosEchoDetection::Run::Fill(vtkPolyData* output) const
{
  vtkIdType count = 0;
  for (const auto& chunk : this->Chunks)
  {
    count += static_cast<vtkIdType>(chunk.size());
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  output->SetPoints(points);
  double* times = AddColumn<vtkDoubleArray>(output, names::GpsTime, count);
  auto* pulses = AddColumn<vtkTypeInt64Array>(output, names::PulseIds, count);
  unsigned char* numbers = AddColumn<vtkUnsignedCharArray>(output, names::ReturnNumber, count);
  unsigned char* totals = AddColumn<vtkUnsignedCharArray>(output, names::NumberOfReturns, count);
  double* ranges = AddColumn<vtkDoubleArray>(output, names::Range, count);
  double* amplitudes = AddColumn<vtkDoubleArray>(output, names::Amplitude, count);
  double* widths = AddColumn<vtkDoubleArray>(output, names::EchoWidth, count);
  auto* waveforms = AddColumn<vtkTypeInt64Array>(output, names::WaveformIds, count);
  double* deviations = this->Detector->GivesDeviation()
    ? AddColumn<vtkDoubleArray>(output, names::Deviation, count)
    : nullptr;
  vtkIdType i = 0;
  for (const auto& chunk : this->Chunks)
  {
    for (const Record& r : chunk)
    {
      const helios::Vec3 point =
        GetVector(this->Table.Origin, r.Row) + r.Range * GetVector(this->Table.Direction, r.Row);
      points->SetPoint(i, point.GetData());
      times[i] = this->Table.GpsTime.GetNumber(r.Row);
      pulses[i] = waveforms[i] = this->Table.PulseIds.GetInteger(r.Row);
      numbers[i] = r.ReturnNumber;
      totals[i] = r.NumberOfReturns;
      ranges[i] = r.Range;
      amplitudes[i] = r.Echo.Amplitude;
      widths[i] = r.Echo.Width;
      if (deviations)
      {
        deviations[i] = r.Echo.Deviation;
      }
      ++i;
    }
  }
}

//------------------------------------------------------------------------------
/// Fills the optional ids of a table.
void vtkHeliosEchoDetection::Run::FillIds(vtkTable* table, vtkPolyData* output) const
{
  for (const char* name : { names::LegIds, names::ChannelIds })
  {
    vtkDataArray* source = table->GetRowData()->GetArray(name);
    if (!source)
    {
      continue;
    }
    const helios::Column column(source);
    int* target = AddColumn<vtkIntArray>(output, name, output->GetNumberOfPoints());
    for (const auto& chunk : this->Chunks)
    {
      for (const Record& r : chunk)
      {
        *target++ = static_cast<int>(column.GetNumber(r.Row));
      }
    }
  }
}

//------------------------------------------------------------------------------
int vtkHeliosEchoDetection::GetNumberOfDetectors()
{
  return static_cast<int>(helios::GetDetectorKinds().size());
}

//------------------------------------------------------------------------------
const char* vtkHeliosEchoDetection::GetDetectorName(int index)
{
  const bool isValid = index >= 0 && index < vtkHeliosEchoDetection::GetNumberOfDetectors();
  return isValid ? std::next(helios::GetDetectorKinds().begin(), index)->Name.c_str() : nullptr;
}

//------------------------------------------------------------------------------
vtkHeliosEchoDetector* vtkHeliosEchoDetection::MakeDetector(const char* name)
{
  const helios::DetectorKind* kind = helios::FindDetectorKind(name ? name : "");
  return kind ? kind->Prototype->NewInstance() : nullptr;
}

//------------------------------------------------------------------------------
bool vtkHeliosEchoDetection::AddDetector(const std::string& name, vtkHeliosEchoDetector* prototype)
{
  return helios::AddDetectorKind(name, prototype);
}

//------------------------------------------------------------------------------
bool vtkHeliosEchoDetection::RemoveDetector(const std::string& name)
{
  return helios::RemoveDetectorKind(name);
}

//------------------------------------------------------------------------------
std::string vtkHeliosEchoDetection::LoadPlugin(const std::string& file)
{
  return helios::LoadDetectorPlugin(file).Message();
}

//------------------------------------------------------------------------------
void vtkHeliosEchoDetection::SetDetectorFile(const std::string& name, const std::string& file)
{
  if (helios::DetectorKind* kind = helios::FindDetectorKind(name))
  {
    kind->File = file;
  }
}

//------------------------------------------------------------------------------
std::string vtkHeliosEchoDetection::GetDetectorFile(const std::string& name)
{
  const helios::DetectorKind* kind = helios::FindDetectorKind(name);
  return kind ? kind->File : std::string();
}

//------------------------------------------------------------------------------
vtkHeliosEchoDetection::vtkHeliosEchoDetection()
  : EchoDetector(vtkSmartPointer<vtkHeliosPeakDetector>::New())
{
}

//------------------------------------------------------------------------------
vtkHeliosEchoDetection::~vtkHeliosEchoDetection() = default;

//------------------------------------------------------------------------------
void vtkHeliosEchoDetection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent
     << "EchoDetector: " << (this->EchoDetector ? this->EchoDetector->GetClassName() : "(none)")
     << "\n"
     << indent << "PulseLength: " << this->PulseLength << " ns\n"
     << indent << "Seed: " << this->Seed << "\n"
     << indent << "ReturnSelection: " << this->ReturnSelection << "\n"
     << indent << "MaximumNumberOfReturns: " << this->MaximumNumberOfReturns << "\n";
}

//------------------------------------------------------------------------------
void vtkHeliosEchoDetection::SetEchoDetector(vtkHeliosEchoDetector* detector)
{
  if (this->EchoDetector != detector)
  {
    this->EchoDetector = detector;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHeliosEchoDetector* vtkHeliosEchoDetection::GetEchoDetector() const
{
  return this->EchoDetector;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHeliosEchoDetection::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->EchoDetector ? std::max(own, this->EchoDetector->GetMTime()) : own;
}

//------------------------------------------------------------------------------
int vtkHeliosEchoDetection::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
bool vtkHeliosEchoDetection::Prepare(vtkTable* table, Run& run)
{
  if (!this->EchoDetector)
  {
    vtkErrorMacro(<< "EchoDetector is not set; give one, e.g. a vtkHeliosPeakDetector");
    return false;
  }
  run.Detector = this->EchoDetector;
  run.Selection = this->ReturnSelection;
  run.Maximum = this->MaximumNumberOfReturns;
  helios::Status status = run.Table.Set(table);
  status = status.IsOk() ? run.Table.CheckNumbers() : status;
  if (!status.IsOk())
  {
    vtkErrorMacro(<< "the input " << status.Message()
                  << "; connect the waveforms of vtkHeliosScanner (output port 1), or of a reader");
    return false;
  }
  run.PulseLength = this->PulseLength;
  vtkDataArray* length = table->GetFieldData()->GetArray(names::PulseLength);
  if (!(run.PulseLength > 0.0) && length && length->GetNumberOfTuples() > 0)
  {
    run.PulseLength = length->GetComponent(0, 0);
  }
  if (run.Table.NumberOfRows > 0 && !(run.PulseLength > 0.0 && std::isfinite(run.PulseLength)))
  {
    vtkErrorMacro(<< "the input has no " << names::PulseLength
                  << " in its field data, or one that is not a positive number of ns; set the "
                     "property PulseLength");
    return false;
  }
  if (run.Table.NumberOfRows > 0)
  {
    run.ReadSamples(table->GetFieldData()->GetArray(names::Samples));
  }
  run.Seed = static_cast<std::uint64_t>(this->Seed);
  return this->Calibrate(table, run);
}

//------------------------------------------------------------------------------
/// Sets the offset for a pulse that is stored with the waveforms.
bool vtkHeliosEchoDetection::Calibrate(vtkTable* table, Run& run)
{
  vtkDataArray* samples = table->GetFieldData()->GetArray(names::PulseSamples);
  if (!samples || run.Table.NumberOfRows == 0)
  {
    return true;
  }
  helios::PulseShape shape;
  const helios::Status status = helios::ReadPulse(samples, shape);
  if (!status.IsOk())
  {
    vtkErrorMacro(<< "the input is not valid: " << status.Message());
    return false;
  }
  const helios::Status fault =
    helios::ComputeDetectorOffset(*run.Detector, shape, run.Table.BinSize.GetNumber(0), run.Offset);
  if (!fault.IsOk())
  {
    vtkErrorMacro(<< fault.Message());
  }
  return fault.IsOk();
}

//------------------------------------------------------------------------------
int vtkHeliosEchoDetection::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkTable* table = vtkTable::GetData(inputs[0]);
  Run run;
  if (!this->Prepare(table, run))
  {
    return 0;
  }
  const vtkIdType chunks = (run.Table.NumberOfRows + RowsPerChunk - 1) / RowsPerChunk;
  run.Chunks.resize(static_cast<std::size_t>(chunks));
  run.Faults.resize(static_cast<std::size_t>(chunks));
  const vtkIdType batch = ChunksOfThread * vtkSMPTools::GetEstimatedNumberOfThreads();
  for (vtkIdType chunk = 0; chunk < chunks; chunk += batch)
  {
    if (this->GetAbortExecute())
    {
      vtkErrorMacro(<< "The work was aborted at " << 100.0 * this->GetProgress()
                    << " %; update again to complete it");
      return 0;
    }
    const vtkIdType end = std::min(chunks, chunk + batch);
    std::shared_ptr<void> threads = run.Detector->PrepareThreads();
    vtkSMPTools::For(
      chunk, end, 1, [&run](vtkIdType from, vtkIdType to) { run.DetectChunks(from, to); });
    threads.reset();
    const auto isBad = [](const helios::Status& status) { return !status.IsOk(); };
    const auto fault = std::find_if(run.Faults.begin(), run.Faults.end(), isBad);
    if (fault != run.Faults.end())
    {
      vtkErrorMacro(<< fault->Message());
      return 0;
    }
    this->UpdateProgress(static_cast<double>(end) / static_cast<double>(chunks));
  }
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  run.Fill(output);
  run.FillIds(table, output);
  return 1;
}
