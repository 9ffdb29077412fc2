// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosScanBatch.h"

#include "heliosBatchEchoes.h"
#include "heliosBatchWorker.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosBatchArrayNames.h"
#include "vtkHeliosScanner.h"
#include "vtkHeliosSurveySource.h"

#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <mutex>
#include <sstream>
#include <thread>

namespace names = vtkHeliosArrayNames;
namespace batch = vtkHeliosBatchArrayNames;

namespace
{

constexpr vtkIdType ItemsPerThread = 8;
constexpr double UnitTolerance = 1e-6; // lengths of quaternions

/// Describes a scan in messages: number, scene and pose.
std::string Describe(vtkIdType scan, vtkIdType scene, const double p[3], const double q[4])
{
  std::ostringstream text;
  text << "scan " << scan << " (scene " << scene << ", pose " << p[0] << " " << p[1] << " " << p[2]
       << ", " << q[0] << " " << q[1] << " " << q[2] << " " << q[3] << ")";
  return text.str();
}

std::vector<std::string> Split(const std::string& text)
{
  std::istringstream words(text);
  return { std::istream_iterator<std::string>(words), {} };
}

} // namespace

vtkStandardNewMacro(vtkHeliosScanBatch);

/// Scans, and consecutive ones of a scene, which a thread makes.
struct vtkHeliosScanBatch::Scans
{
  struct Item
  {
    vtkIdType First;
    vtkIdType Last;
  };

  std::vector<vtkPolyData*> Scenes;
  vtkPolyData* Poses = nullptr;
  vtkDataArray* Orientations = nullptr;
  vtkDataArray* SceneIds = nullptr;
  std::vector<Item> Items;
  std::unique_ptr<helios::BatchEchoes> Echoes;
  std::atomic<std::size_t> Next{ 0 };
  std::atomic<vtkIdType> Done{ 0 };
  std::atomic<bool> IsStopped{ false };
  std::mutex Mutex;
  vtkIdType Failed = VTK_ID_MAX; ///< first scan with an error
  std::string Error;

  vtkIdType Count() const { return this->Poses->GetNumberOfPoints(); }
  vtkIdType GetScene(vtkIdType scan) const
  {
    return this->SceneIds        ? static_cast<vtkIdType>(this->SceneIds->GetComponent(scan, 0))
      : this->Scenes.size() == 1 ? 0
                                 : scan;
  }
  void GetPose(vtkIdType scan, double p[3], double q[4]) const
  {
    this->Poses->GetPoint(scan, p);
    this->Orientations->GetTuple(scan, q);
  }
  void Fail(vtkIdType scan, const std::string& error)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->IsStopped = true;
    if (scan < this->Failed)
    {
      this->Failed = scan;
      this->Error = error;
    }
  }
  /// Divides the scans: at the end of a scene, and of one scene into several for each thread.
  void Divide(std::size_t threads)
  {
    const vtkIdType most =
      std::max<vtkIdType>(1, this->Count() / (static_cast<vtkIdType>(threads) * ItemsPerThread));
    for (vtkIdType scan = 0; scan < this->Count(); ++scan)
    {
      const bool isNew = this->Items.empty() || this->GetScene(scan) != this->GetScene(scan - 1) ||
        scan - this->Items.back().First >= most;
      if (isNew)
      {
        this->Items.push_back({ scan, scan });
      }
      this->Items.back().Last = scan + 1;
    }
  }
};

//------------------------------------------------------------------------------
vtkHeliosScanBatch::vtkHeliosScanBatch()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkHeliosScanBatch::~vtkHeliosScanBatch() = default;

//------------------------------------------------------------------------------
void vtkHeliosScanBatch::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Source: " << (this->Source ? "set" : "(none)") << "\n"
     << indent << "Arrays: " << this->Arrays << "\n";
}

//------------------------------------------------------------------------------
void vtkHeliosScanBatch::SetSource(vtkHeliosSurveySource* source)
{
  if (this->Source != source)
  {
    this->Source = source;
    this->Workers.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHeliosSurveySource* vtkHeliosScanBatch::GetSource() const
{
  return this->Source;
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosScanBatch::GetPulsesPerScan() const
{
  return this->Workers.empty() ? 0 : this->Workers.front()->GetNumberOfPulses();
}

//------------------------------------------------------------------------------
int vtkHeliosScanBatch::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), port == 0 ? 1 : 0);
  return 1;
}

//------------------------------------------------------------------------------
/// Makes the scanners, unless they are there and the survey has not changed; false after an error.
bool vtkHeliosScanBatch::Prepare(std::size_t workers)
{
  if (this->Source && !this->Workers.empty() && this->WorkersTime != this->Source->GetMTime())
  {
    this->Workers.clear();
  }
  if (!this->Source || (this->Workers.empty() && !this->Source->Load()))
  {
    vtkErrorMacro(<< "the batch has no sensor; set a Source that can be loaded");
    return false;
  }
  this->WorkersTime = this->Source->GetMTime();
  while (this->Workers.size() < workers)
  {
    const auto scanner = this->Source->MakeScanner();
    if (!scanner)
    {
      vtkErrorMacro(<< "leg 0 of the survey fires no pulses, or its scanner has several channels; "
                       "give a leg that fires, of a scanner with one channel");
      return false;
    }
    this->Workers.push_back(std::make_unique<helios::BatchWorker>(scanner));
  }
  return true;
}

//------------------------------------------------------------------------------
/// Reads and checks the inputs; false after an error.
bool vtkHeliosScanBatch::ReadScans(vtkInformationVector** inputs, Scans& scans)
{
  for (int i = 0; i < inputs[0]->GetNumberOfInformationObjects(); ++i)
  {
    scans.Scenes.push_back(vtkPolyData::GetData(inputs[0], i));
  }
  scans.Poses = vtkPolyData::GetData(inputs[1]);
  scans.Orientations = scans.Poses->GetPointData()->GetArray(names::Orientation);
  scans.SceneIds = scans.Poses->GetPointData()->GetArray(batch::SceneIds);
  if (!scans.Orientations || scans.Orientations->GetNumberOfComponents() != 4)
  {
    vtkErrorMacro(<< "the poses have no point array " << names::Orientation
                  << " with 4 components: w, x, y, z");
    return false;
  }
  const auto scenes = static_cast<vtkIdType>(scans.Scenes.size());
  if (!scans.SceneIds && scenes > 1 && scenes != scans.Count())
  {
    vtkErrorMacro(<< "there are " << scans.Count() << " poses for " << scenes
                  << " scenes; give one each, or the array " << batch::SceneIds);
    return false;
  }
  for (vtkIdType scan = 0; scan < scans.Count(); ++scan)
  {
    if (!this->CheckPose(scan, scans))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosScanBatch::CheckPose(vtkIdType scan, const Scans& scans)
{
  double p[3];
  double q[4];
  scans.GetPose(scan, p, q);
  const vtkIdType scene = scans.GetScene(scan);
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  std::string wrong;
  if (!std::isfinite(p[0] + p[1] + p[2]))
  {
    wrong = "its position is not finite";
  }
  else if (!(std::abs(length - 1.0) < UnitTolerance))
  {
    wrong = "its orientation is not a unit quaternion w, x, y, z";
  }
  else if (scene < 0 || scene >= static_cast<vtkIdType>(scans.Scenes.size()))
  {
    wrong = "there are only " + std::to_string(scans.Scenes.size()) + " scenes";
  }
  if (!wrong.empty())
  {
    vtkErrorMacro(<< Describe(scan, scene, p, q) << ": " << wrong);
  }
  return wrong.empty();
}

//------------------------------------------------------------------------------
/// Makes scans until there are none, by the scanner of a thread.
void vtkHeliosScanBatch::RunItems(Scans& scans, helios::BatchWorker& worker, bool reports)
{
  const auto report = [this, &scans](double share)
  {
    const double done = static_cast<double>(scans.Done) + share;
    this->UpdateProgress(done / static_cast<double>(scans.Count()));
    scans.IsStopped = scans.IsStopped || this->GetAbortExecute() != 0;
  };
  worker.SetOnProgress(
    [&](double share)
    {
      reports ? report(share) : void();
      return !scans.IsStopped;
    });
  for (std::size_t item = scans.Next++; item < scans.Items.size(); item = scans.Next++)
  {
    for (vtkIdType scan = scans.Items[item].First; scan < scans.Items[item].Last; ++scan)
    {
      if (scans.IsStopped)
      {
        return;
      }
      double p[3];
      double q[4];
      scans.GetPose(scan, p, q);
      const vtkIdType scene = scans.GetScene(scan);
      const vtkIdType pulse = scan * worker.GetNumberOfPulses();
      helios::Status status =
        worker.Run(scans.Scenes[static_cast<std::size_t>(scene)], p, q, pulse);
      if (worker.WasStopped())
      {
        return;
      }
      status = status.IsOk() ? scans.Echoes->Add(scan, worker.GetEchoes()) : status;
      if (!status.IsOk())
      {
        scans.Fail(scan, Describe(scan, scene, p, q) + ": " + status.Message());
        return;
      }
      ++scans.Done;
      reports ? report(0.0) : void();
    }
  }
}

//------------------------------------------------------------------------------
/// Divides the scans among threads; a few are made one after the other, each by all threads.
void vtkHeliosScanBatch::Run(Scans& scans, std::size_t workers)
{
  scans.Divide(workers);
  if (workers == 1)
  {
    this->RunItems(scans, *this->Workers.front(), true);
    return;
  }
  const auto own = std::this_thread::get_id();
  vtkSMPTools::For(0, static_cast<vtkIdType>(workers), 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType worker = first; worker < last; ++worker)
      {
        this->RunItems(scans, *this->Workers[static_cast<std::size_t>(worker)],
          std::this_thread::get_id() == own);
      }
    });
}

//------------------------------------------------------------------------------
int vtkHeliosScanBatch::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  Scans scans;
  if (!this->ReadScans(inputs, scans))
  {
    return 0;
  }
  const auto threads = static_cast<std::size_t>(vtkSMPTools::GetEstimatedNumberOfThreads());
  const auto count = static_cast<std::size_t>(scans.Count());
  const std::size_t workers = count < 2 * threads ? 1 : threads;
  if (!this->Prepare(workers))
  {
    return 0;
  }
  scans.Echoes = std::make_unique<helios::BatchEchoes>(scans.Count(), Split(this->Arrays));
  this->Run(scans, workers);
  if (!scans.Error.empty())
  {
    vtkErrorMacro(<< scans.Error);
    return 0;
  }
  if (!scans.IsStopped)
  {
    scans.Echoes->Join(vtkPolyData::GetData(outputs));
  }
  return 1;
}
