// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLegRunner.h"

#include "heliosMessages.h"
#include "vtkHeliosPlatform.h"
#include "vtkHeliosPointTextWriter.h"
#include "vtkHeliosPointXMLWriter.h"
#include "vtkHeliosTrajectoryTextWriter.h"
#include "vtkHeliosWaveformTextWriter.h"
#include "vtkHeliosWaveformXMLWriter.h"

#include <vtkPolyData.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

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

vtkSmartPointer<vtkHeliosStreamWriter> MakeWaveformWriter(bool isXml)
{
  if (isXml)
  {
    return vtkSmartPointer<vtkHeliosWaveformXMLWriter>::New();
  }
  return vtkSmartPointer<vtkHeliosWaveformTextWriter>::New();
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
void LegRunner::Open(vtkHeliosStreamWriter* writer, const LegPlan& plan, const char* ending)
{
  this->Log.Listen(writer);
  writer->SetFileName(MakeFileName(this->Settings.Folder, plan.Leg, ending).c_str());
  writer->Open();
}

//------------------------------------------------------------------------------
LegRunner::Writers LegRunner::OpenWriters(const LegPlan& plan)
{
  Writers writers(1);
  const bool isXml = this->Settings.Format == "vtp";
  if (isXml)
  {
    writers[0] = vtkSmartPointer<vtkHeliosPointXMLWriter>::New();
    this->Open(writers[0], plan, "_points.pvtp");
  }
  else
  {
    writers[0] = vtkSmartPointer<vtkHeliosPointTextWriter>::New();
    this->Open(writers[0], plan, "_points.xyz");
  }
  if (this->Settings.Scan.Waveforms)
  {
    writers.push_back(MakeWaveformWriter(isXml));
    this->Open(writers[1], plan, isXml ? "_fullwave.pvtt" : "_fullwave.txt");
  }
  return writers;
}

//------------------------------------------------------------------------------
bool LegRunner::WriteTrajectory(const LegPlan& plan)
{
  const TrajectorySampler sampler(plan, this->Survey.Legs[plan.Leg].TrajectoryTimeInterval);
  vtkNew<vtkHeliosTrajectoryTextWriter> writer;
  this->Open(writer, plan, "_trajectory.txt");
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
  return writer->Close();
}

//------------------------------------------------------------------------------
bool LegRunner::Run(const LegPlan& plan, const BlockCallback& onBlock)
{
  this->Scanner.SetUp(plan);
  const Writers writers = this->OpenWriters(plan);
  bool good = !this->Log.HasError() && this->WriteTrajectory(plan) &&
    this->RunBlocks(plan, writers, onBlock) && !this->Log.HasError();
  for (const auto& writer : writers)
  {
    good = (good ? writer->Close() : writer->Abandon()) && good;
  }
  return good;
}

//------------------------------------------------------------------------------
bool LegRunner::RunBlocks(const LegPlan& plan, const Writers& writers, const BlockCallback& onBlock)
{
  const vtkIdType size = this->Settings.PulsesPerBlock;
  const int blocks =
    static_cast<int>(std::max<vtkIdType>(1, (plan.NumberOfPulses + size - 1) / size));
  const vtkIdType before = this->Counts.Pulses;
  for (int block = 0; block < blocks; ++block)
  {
    if (!this->Scanner.Update(block, blocks))
    {
      return false;
    }
    const vtkIdType done = plan.NumberOfPulses / blocks * (block + 1) +
      plan.NumberOfPulses % blocks * (block + 1) / blocks;
    this->Counts.Pulses = before + done;
    this->Scanner.Count(this->Counts);
    for (std::size_t port = 0; port < writers.size(); ++port)
    {
      if (!writers[port]->Write(this->Scanner.GetOutput(static_cast<int>(port))))
      {
        return false;
      }
    }
    this->Scanner.ReleaseOutput();
    if (!onBlock(this->Counts))
    {
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
