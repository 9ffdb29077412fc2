// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLegRunner.h"

#include "heliosLegOptics.h"
#include "heliosMessages.h"
#include "heliosRunJournal.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosBeamDeflector.h"
#include "vtkHeliosBeamSampler.h"
#include "vtkHeliosEchoDetector.h"
#include "vtkHeliosPlatform.h"
#include "vtkHeliosPointTextWriter.h"
#include "vtkHeliosPointXMLWriter.h"
#include "vtkHeliosRayCaster.h"
#include "vtkHeliosScanner.h"
#include "vtkHeliosTrajectoryTextWriter.h"
#include "vtkHeliosWaveformTextWriter.h"
#include "vtkHeliosWaveformXMLWriter.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iterator>

namespace helios
{
namespace names = vtkHeliosArrayNames;

namespace
{

constexpr vtkIdType SamplesPerBlock = 65536;

/// "legNNN" and what follows.
std::string MakeFileName(const std::string& folder, std::size_t leg, const char* ending)
{
  char name[32];
  std::snprintf(name, sizeof(name), "leg%03zu", leg);
  return (std::filesystem::path(folder) / (std::string(name) + ending)).string();
}

vtkIdType CountFirstReturns(vtkPolyData* echoes)
{
  vtkDataArray* numbers = echoes->GetPointData()->GetArray(names::ReturnNumber);
  vtkIdType count = 0;
  for (vtkIdType i = 0; numbers && i < numbers->GetNumberOfTuples(); ++i)
  {
    count += numbers->GetComponent(i, 0) == 1.0 ? 1 : 0;
  }
  return count;
}

vtkSmartPointer<vtkHeliosStreamWriter> MakePointWriter(bool isXml)
{
  if (isXml)
  {
    return vtkSmartPointer<vtkHeliosPointXMLWriter>::New();
  }
  return vtkSmartPointer<vtkHeliosPointTextWriter>::New();
}

vtkSmartPointer<vtkHeliosStreamWriter> MakeWaveformWriter(bool isXml)
{
  if (isXml)
  {
    return vtkSmartPointer<vtkHeliosWaveformXMLWriter>::New();
  }
  return vtkSmartPointer<vtkHeliosWaveformTextWriter>::New();
}

/// How far the file of a writer is.
FileProgress GetProgress(vtkHeliosStreamWriter* writer)
{
  return { std::filesystem::path(writer->GetFileName()).filename().string(), writer->GetFileSize(),
    writer->GetNumberOfRecords(), writer->GetNumberOfBytes() };
}

double Now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void SetPose(const Pose& pose, double position[3], double orientation[4])
{
  std::copy_n(pose.Position.GetData(), 3, position);
  std::copy_n(pose.Orientation.GetData(), 4, orientation);
}

} // namespace

//------------------------------------------------------------------------------
LegRunner::LegRunner(
  const SurveyData& survey, vtkPolyData* scene, const RunSettings& settings, Messages& log)
  : Survey(survey)
  , Settings(settings)
  , Log(log)
  , Scene(scene)
{
  this->Log.Listen(this->Scanner.Get());
  this->SetUpInstrument();
}

//------------------------------------------------------------------------------
LegRunner::~LegRunner() = default;

//------------------------------------------------------------------------------
void LegRunner::SetUpInstrument()
{
  const ScannerData& data = this->Survey.Scanner;
  this->Scanner->SetInputDataObject(0, this->Scene);
  if (this->Settings.RayCaster)
  {
    this->Scanner->SetRayCaster(this->Settings.RayCaster);
  }
  SetUpReceiver(data, this->Settings.Receiver, this->Scanner);
  double position[3];
  double orientation[4];
  SetPose(this->Survey.Platform.Mount, position, orientation);
  this->Scanner->SetMountPosition(position);
  this->Scanner->SetMountOrientation(orientation);
  SetPose(data.Beam, position, orientation);
  this->Scanner->SetBeamOrigin(position);
  this->Scanner->SetBeamOrientation(orientation);
  Vec3 axis = data.HeadRotateAxis;
  this->Scanner->SetHeadRotateAxis(axis.GetData());
  this->Scanner->SetSeed(this->Settings.Seed);
  this->Scanner->SetGenerateWaveforms(this->Settings.Waveforms);
}

//------------------------------------------------------------------------------
void LegRunner::SetUpLeg(const LegPlan& plan)
{
  const LegData& leg = this->Survey.Legs[plan.Leg];
  this->Scanner->SetBeamDeflector(MakeDeflector(this->Survey.Scanner, leg));
  this->Scanner->GetBeamSampler()->SetBeamDivergence(leg.BeamDivergence);
  this->Scanner->SetHeadRotateStart(leg.HeadRotateStart);
  this->Scanner->SetHeadRotateStop(leg.HeadRotateStop);
  this->Scanner->SetHeadRotateSpeed(leg.HeadRotateSpeed);
  this->Scanner->SetInputConnection(1, plan.Platform->GetOutputPort());
  this->Scanner->SetStartTime(plan.StartTime);
  this->Scanner->SetDuration(plan.Duration);
  this->Scanner->SetFirstPulseId(plan.FirstPulse);
  this->Scanner->SetLegId(static_cast<int>(plan.Leg));
}

//------------------------------------------------------------------------------
bool LegRunner::Plan()
{
  this->Plans = PlanLegs(this->Survey, this->Scene, this->Log);
  for (LegPlan& plan : this->Plans)
  {
    this->SetUpLeg(plan);
    plan.FirstPulse = this->NumberOfPulses;
    plan.NumberOfPulses = std::max<vtkIdType>(0, this->Scanner->GetNumberOfPulses());
    this->NumberOfPulses += plan.NumberOfPulses;
  }
  return !this->Log.HasError();
}

//------------------------------------------------------------------------------
vtkHeliosScanner* LegRunner::Prepare(const LegPlan& plan)
{
  this->SetUpLeg(plan);
  return this->Scanner;
}

//------------------------------------------------------------------------------
LegRunner::Writers LegRunner::MakeWriters(const LegPlan& plan) const
{
  const bool isXml = this->Settings.Format == "vtp";
  Writers writers{ MakePointWriter(isXml) };
  const auto name = [this, &plan](const char* ending)
  { return MakeFileName(this->Settings.Folder, plan.Leg, ending); };
  writers[0]->SetFileName(name(isXml ? "_points.pvtp" : "_points.xyz").c_str());
  if (this->Settings.Waveforms)
  {
    writers.push_back(MakeWaveformWriter(isXml));
    writers[1]->SetFileName(name(isXml ? "_fullwave.pvtt" : "_fullwave.txt").c_str());
  }
  return writers;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkHeliosStreamWriter> LegRunner::MakeTrajectoryWriter(const LegPlan& plan) const
{
  auto writer = vtkSmartPointer<vtkHeliosTrajectoryTextWriter>::New();
  writer->SetFileName(MakeFileName(this->Settings.Folder, plan.Leg, "_trajectory.txt").c_str());
  return writer;
}

//------------------------------------------------------------------------------
bool LegRunner::OpenWriters(const Writers& writers, const LegProgress& before)
{
  bool good = true;
  for (const auto& writer : writers)
  {
    this->Listen(writer);
    const FileProgress* file = before.FindFile(GetProgress(writer).Name);
    good = good &&
      (file ? writer->Reopen(file->Size, file->Records, file->Bytes) : writer->Open());
  }
  return good;
}

//------------------------------------------------------------------------------
bool LegRunner::WriteTrajectory(const LegPlan& plan, FileProgress& written)
{
  const TrajectorySampler sampler(plan, this->Survey.Legs[plan.Leg].TrajectoryTimeInterval);
  const auto writer = this->MakeTrajectoryWriter(plan);
  this->Listen(writer);
  writer->Open();
  for (vtkIdType first = 0; first < sampler.GetNumberOfSamples() && !this->Log.HasError();
       first += SamplesPerBlock)
  {
    writer->Write(sampler.GetSamples(first, SamplesPerBlock));
  }
  if (this->Log.HasError())
  {
    writer->Abandon();
    return false;
  }
  const bool good = writer->Close();
  written = GetProgress(writer);
  return good;
}

//------------------------------------------------------------------------------
bool LegRunner::Run(const LegPlan& plan, RunJournal& journal, const BlockCallback& onBlock)
{
  const LegProgress before = journal.GetLeg(plan.Leg);
  if (before.IsDone)
  {
    this->Counts = before.Counts;
    return this->CheckFiles(before);
  }
  this->SetUpLeg(plan);
  const Writers writers = this->MakeWriters(plan);
  FileProgress trajectory;
  bool good = this->OpenWriters(writers, before) && this->WriteTrajectory(plan, trajectory) &&
    this->RunBlocks(plan, writers, journal, onBlock) && !this->Log.HasError();
  for (const auto& writer : writers)
  {
    good = (good ? writer->Close() : writer->Abandon()) && good;
  }
  if (!good)
  {
    return false;
  }
  LegProgress done = journal.GetLeg(plan.Leg);
  done.IsDone = true;
  std::transform(writers.begin(), writers.end(), done.Files.begin(),
    [](const auto& writer) { return GetProgress(writer); }); // an index has its end now
  done.Files.push_back(trajectory);
  return this->Note(plan, done, journal);
}

//------------------------------------------------------------------------------
bool LegRunner::RunBlocks(
  const LegPlan& plan, const Writers& writers, RunJournal& journal, const BlockCallback& onBlock)
{
  const vtkIdType size = this->Settings.PulsesPerBlock;
  const int blocks =
    static_cast<int>(std::max<vtkIdType>(1, (plan.NumberOfPulses + size - 1) / size));
  LegProgress progress = journal.GetLeg(plan.Leg);
  if (progress.Blocks > 0)
  {
    this->Counts = progress.Counts;
  }
  const double start = Now() - progress.Seconds;
  for (int block = progress.Blocks; block < blocks; ++block)
  {
    this->Scanner->UpdatePiece(block, blocks, 0);
    if (this->Log.HasError())
    {
      return false;
    }
    const vtkIdType done = plan.NumberOfPulses / blocks * (block + 1) +
      plan.NumberOfPulses % blocks * (block + 1) / blocks;
    this->CountBlock(plan.FirstPulse + done);
    if (!this->WriteBlock(writers))
    {
      return false;
    }
    progress.Blocks = block + 1;
    progress.Counts = this->Counts;
    progress.Seconds = Now() - start;
    progress.Files.clear();
    std::transform(writers.begin(), writers.end(), std::back_inserter(progress.Files),
      [](const auto& writer) { return GetProgress(writer); });
    if (!this->Note(plan, progress, journal) || !onBlock(this->Counts))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool LegRunner::WriteBlock(const Writers& writers)
{
  for (std::size_t port = 0; port < writers.size(); ++port)
  {
    vtkDataObject* data = this->Scanner->GetOutputDataObject(static_cast<int>(port));
    if (!writers[port]->Write(data))
    {
      return false;
    }
    data->ReleaseData();
  }
  // The journal may say only what is safe.
  return std::all_of(
    writers.begin(), writers.end(), [](const auto& writer) { return writer->Flush(); });
}

//------------------------------------------------------------------------------
bool LegRunner::Note(const LegPlan& plan, const LegProgress& progress, RunJournal& journal)
{
  const std::string problem = journal.Append(plan.Leg, progress);
  if (!problem.empty())
  {
    this->Log.Error(problem + "; make room, or see that the output folder stays, and go on with "
                              "Resume (--resume), or run again");
  }
  return problem.empty();
}

//------------------------------------------------------------------------------
bool LegRunner::CheckFiles(const LegProgress& progress)
{
  for (const FileProgress& file : progress.Files)
  {
    const auto path = std::filesystem::path(this->Settings.Folder) / file.Name;
    std::error_code error;
    const auto size = std::filesystem::file_size(path, error);
    if (error || size != static_cast<std::uintmax_t>(file.Size))
    {
      this->Log.Error(path.string() + ": was finished with " + std::to_string(file.Size) +
        " bytes and " +
        (error ? "cannot be read: " + error.message() : "has " + std::to_string(size)) +
        "; set Overwrite (--overwrite) to run anew");
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void LegRunner::CountBlock(vtkIdType pulses)
{
  vtkPolyData* echoes = this->Scanner->GetOutput();
  this->Counts.Pulses = pulses;
  this->Counts.Echoes += echoes->GetNumberOfPoints();
  this->Counts.FirstReturns += CountFirstReturns(echoes);
  this->Counts.PulsesFired += this->Scanner->GetNumberOfPulsesFired();
  this->Counts.PulsesHit += this->Scanner->GetNumberOfPulsesHit();
  this->Counts.PulsesOnPlane += this->Scanner->GetNumberOfPulsesOnPlane();
  this->Counts.PulsesWithoutBins += this->Scanner->GetNumberOfPulsesWithoutBins();
  this->Counts.PulsesBinned += this->Scanner->GetNumberOfPulsesBinned();
  this->Counts.SubRays += this->Scanner->GetNumberOfSubRays();
  this->Counts.HitsOutOfRange += this->Scanner->GetNumberOfHitsOutOfRange();
  this->Counts.LargestAmplitude =
    std::max(this->Counts.LargestAmplitude, this->Scanner->GetLargestAmplitude());
}

//------------------------------------------------------------------------------
std::string LegRunner::DescribeSampling()
{
  return this->Scanner->DescribeSampling();
}

//------------------------------------------------------------------------------
bool LegRunner::HasError() const
{
  return this->Log.HasError();
}

//------------------------------------------------------------------------------
void LegRunner::Listen(vtkHeliosStreamWriter* writer)
{
  this->Log.Listen(writer);
}

//------------------------------------------------------------------------------
std::string LegRunner::GetRayCasterName() const
{
  return this->Scanner->GetRayCaster()->GetName();
}

//------------------------------------------------------------------------------
std::string LegRunner::ExplainNoEchoes() const
{
  const ScannerData& scanner = this->Survey.Scanner;
  Sentence text;
  text << "No points: ";
  if (this->NumberOfPulses == 0)
  {
    text << "no leg fires a pulse, since none is active or lasts any time; set active=\"true\" for "
            "one";
  }
  else if (this->Counts.PulsesFired == 0 && scanner.Type == Optics::RisleyPrisms)
  {
    text << "no pulse left the scanner, since its prisms reflect all of them; check angle1_deg to "
            "angle3_deg and refrIndex1 to refrIndex3 of scanner "
         << scanner.Id;
  }
  else if (this->Counts.PulsesFired == 0)
  {
    text << "no pulse left the scanner, since its mirror never is between verticalAngleMin_deg and "
            "verticalAngleMax_deg; check these and the scan angles";
  }
  else if (this->Counts.PulsesHit == 0 && this->Counts.HitsOutOfRange == 0)
  {
    const LegPlan& plan = this->Plans.front();
    const Vec3 p(plan.Platform->GetOutput()->GetPoint(0));
    double b[6];
    this->Scene->GetBounds(b);
    text << "none of " << this->Counts.PulsesFired << " pulses hit the scene. It spans x " << b[0]
         << " to " << b[1] << ", y " << b[2] << " to " << b[3] << ", z " << b[4] << " to " << b[5]
         << "; leg " << plan.Leg << " starts at " << p[0] << ", " << p[1] << ", " << p[2]
         << ". Check where the legs are, the scan angles and the scanner's mount";
  }
  else if (this->Counts.PulsesHit == 0)
  {
    text << "every surface hit is nearer than rangeMin_m=\"" << scanner.RangeMin << "\"";
    if (scanner.RangeMax < VTK_DOUBLE_MAX)
    {
      text << " or farther than rangeMax_m=\"" << scanner.RangeMax << "\"";
    }
    text << " of scanner " << scanner.Id << "; check where the legs are, and the unit of the scene";
  }
  else
  {
    text << "the strongest of " << this->Counts.PulsesHit << " returns has "
         << this->Counts.LargestAmplitude << " W, below the detection threshold of "
         << scanner.DetectionThreshold << " W (receivedEnergyMin_W) of scanner " << scanner.Id
         << "; check the reflectances, the range and averagePower_w";
  }
  return text.str();
}

//------------------------------------------------------------------------------
const char* LegRunner::GetFilePattern()
{
  return "leg[0-9]{3,}_(points|trajectory|fullwave|pulse).*";
}

} // namespace helios
