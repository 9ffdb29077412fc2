// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLegRunner.h"

#include "heliosMessages.h"
#include "heliosRunJournal.h"
#include "vtkHeliosPlatform.h"
#include "vtkHeliosPointTextWriter.h"
#include "vtkHeliosPointXMLWriter.h"
#include "vtkHeliosTrajectoryTextWriter.h"
#include "vtkHeliosWaveformTextWriter.h"
#include "vtkHeliosWaveformXMLWriter.h"

#include <vtkPolyData.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <future>
#include <iterator>

namespace helios
{

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

std::vector<FileProgress> GetProgress(
  const std::vector<vtkSmartPointer<vtkHeliosStreamWriter>>& writers)
{
  std::vector<FileProgress> files;
  std::transform(writers.begin(), writers.end(), std::back_inserter(files),
    [](const auto& writer) { return GetProgress(writer.Get()); });
  return files;
}

/// Notes what is written when the disk has it; says what went wrong, or returns an empty text.
std::string Note(const std::vector<vtkSmartPointer<vtkHeliosStreamWriter>>& writers,
  RunJournal& journal, std::size_t leg, const LegProgress& progress)
{
  for (const auto& writer : writers)
  {
    const std::string problem = writer->Sync();
    if (!problem.empty())
    {
      return problem;
    }
  }
  return journal.Append(leg, progress);
}

double Now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace

//------------------------------------------------------------------------------
LegRunner::LegRunner(
  const SurveyData& survey, vtkPolyData* scene, const RunSettings& settings, Messages& log)
  : Survey(survey)
  , Settings(settings)
  , Log(log)
  , Scene(scene)
  , Scanner(survey, scene, settings.Scan, log)
{
}

//------------------------------------------------------------------------------
LegRunner::~LegRunner() = default;

//------------------------------------------------------------------------------
bool LegRunner::Plan()
{
  const LegChance chance = { this->Settings.Scan.Receiver.Noise, this->Settings.Scan.Seed };
  this->Plans = PlanLegs(this->Survey, this->Scene, chance, this->Log);
  for (LegPlan& plan : this->Plans)
  {
    this->Scanner.SetUp(plan);
    plan.FirstPulse = this->NumberOfPulses;
    plan.NumberOfPulses = this->Scanner.CountPulses();
    this->NumberOfPulses += plan.NumberOfPulses;
  }
  return !this->Log.HasError();
}

//------------------------------------------------------------------------------
LegScanner& LegRunner::Prepare(const LegPlan& plan)
{
  this->Scanner.SetUp(plan);
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
  if (this->Settings.Scan.Waveforms)
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
bool LegRunner::OpenWriters(const Writers& writers, const RunJournal& journal)
{
  bool good = true;
  for (const auto& writer : writers)
  {
    this->Listen(writer);
    const FileProgress* file = journal.FindFile(GetProgress(writer).Name);
    good = good && (file ? writer->Reopen(file->Size, file->Records, file->Bytes) : writer->Open());
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
    return this->CheckFiles(before, journal);
  }
  this->Scanner.SetUp(plan);
  const Writers writers = this->MakeWriters(plan);
  FileProgress trajectory;
  bool good = this->OpenWriters(writers, journal) && this->WriteTrajectory(plan, trajectory) &&
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
  done.Files = GetProgress(writers); // an index has its end now
  done.Files.push_back(trajectory);
  return this->Check(journal.Append(plan.Leg, done));
}

//------------------------------------------------------------------------------
bool LegRunner::RunBlocks(
  const LegPlan& plan, const Writers& writers, RunJournal& journal, const BlockCallback& onBlock)
{
  const vtkIdType size = this->Settings.PulsesPerBlock;
  const int blocks =
    static_cast<int>(std::max<vtkIdType>(1, (plan.NumberOfPulses + size - 1) / size));
  LegProgress progress = journal.GetLeg(plan.Leg);
  this->Counts = progress.Blocks > 0 ? progress.Counts : this->Counts;
  const double start = Now() - progress.Seconds;
  // The disk takes a block while the next one is computed; nobody writes meanwhile.
  std::future<std::string> noted;
  const auto isNoted = [this, &noted] { return !noted.valid() || this->Check(noted.get()); };
  for (int block = progress.Blocks; block < blocks; ++block)
  {
    const bool isComputed = this->Scanner.Update(block, blocks);
    if (!isNoted() || !isComputed || !this->WriteBlock(writers))
    {
      return false;
    }
    const vtkIdType done = plan.NumberOfPulses / blocks * (block + 1) +
      plan.NumberOfPulses % blocks * (block + 1) / blocks;
    this->Counts.Pulses = plan.FirstPulse + done;
    this->Scanner.Count(this->Counts);
    this->Scanner.ReleaseOutput();
    progress.Blocks = block + 1;
    progress.Counts = this->Counts;
    progress.Seconds = Now() - start;
    progress.Files = GetProgress(writers);
    noted = std::async(std::launch::async,
      [&writers, &journal, &plan, progress] { return Note(writers, journal, plan.Leg, progress); });
    if (!onBlock(this->Counts))
    {
      isNoted();
      return false;
    }
  }
  return isNoted();
}

//------------------------------------------------------------------------------
bool LegRunner::WriteBlock(const Writers& writers)
{
  for (std::size_t port = 0; port < writers.size(); ++port)
  {
    if (!writers[port]->Write(this->Scanner.GetOutput(static_cast<int>(port))))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool LegRunner::Check(const std::string& problem)
{
  if (!problem.empty())
  {
    this->Log.Error(problem +
      "; see that the output folder stays and has room, and go on with Resume (--resume), or run "
      "again");
  }
  return problem.empty();
}

//------------------------------------------------------------------------------
bool LegRunner::CheckFiles(const LegProgress& progress, const RunJournal& journal)
{
  for (const FileProgress& file : progress.Files)
  {
    const std::string path = (std::filesystem::path(this->Settings.Folder) / file.Name).string();
    const FileProgress* last = journal.FindFile(file.Name);
    std::error_code error;
    const auto size = std::filesystem::file_size(path, error);
    if (error || size != static_cast<std::uintmax_t>(last->Size))
    {
      this->Log.Error(path + ": was finished with " + std::to_string(last->Size) + " bytes and " +
        (error ? "cannot be read: " + error.message() : "has " + std::to_string(size)) +
        "; set Overwrite (--overwrite) to run anew");
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
std::string LegRunner::DescribeSampling()
{
  return this->Scanner.DescribeSampling();
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
  return this->Scanner.GetRayCasterName();
}

//------------------------------------------------------------------------------
std::string LegRunner::ExplainNoEchoes() const
{
  const std::size_t leg = this->Plans.empty() ? 0 : this->Plans.front().Leg;
  const ScannerData& scanner = this->Survey.GetScanner(leg);
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
