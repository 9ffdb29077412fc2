// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPCLPlanes.h"

#include "heliosChunks.h"
#include "heliosPclInput.h"
#include "heliosPointSelection.h"
#include "vtkHeliosPCLArrayNames.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <pcl/console/print.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

vtkStandardNewMacro(vtkHeliosPCLPlanes);

namespace names = vtkHeliosPCLArrayNames;

namespace
{

// Points that test a sample: a plane with few of these is not found by samples of three.
constexpr std::size_t MaximumSamples = 20000;

/// Silences PCL, which reports each sample of three collinear points to stderr and draws another.
class QuietPcl
{
public:
  QuietPcl() { pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); }
  ~QuietPcl() { pcl::console::setVerbosityLevel(this->Level); }
  QuietPcl(const QuietPcl&) = delete;
  void operator=(const QuietPcl&) = delete;

private:
  pcl::console::VERBOSITY_LEVEL Level = pcl::console::getVerbosityLevel();
};

/// A separate search for one plane.
struct Segmentation
{
  QuietPcl Quiet;
  pcl::SACSegmentation<pcl::PointXYZ> Method; // draws the same random numbers each time
  pcl::PointIndices Found;
  pcl::ModelCoefficients Plane;
};

struct Plane
{
  double Centre[3] = { 0.0, 0.0, 0.0 };
  double Normal[3];
  double Deviation = 0.0; // root mean square
};

/// Returns the least squares plane of points, in double: the smallest axis of their covariance.
Plane FitPlane(vtkPolyData* data, const std::vector<vtkIdType>& ids)
{
  Plane plane;
  double p[3];
  double first[3];
  data->GetPoint(ids[0], first); // keeps sums small
  const auto count = static_cast<double>(ids.size());
  for (const vtkIdType id : ids)
  {
    data->GetPoint(id, p);
    for (int i = 0; i < 3; ++i)
    {
      plane.Centre[i] += (p[i] - first[i]) / count;
    }
  }
  vtkMath::Add(plane.Centre, first, plane.Centre);
  double sums[3][3] = {};
  for (const vtkIdType id : ids)
  {
    data->GetPoint(id, p);
    vtkMath::Subtract(p, plane.Centre, p);
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        sums[i][j] += p[i] * p[j] / count;
      }
    }
  }
  double values[3];
  double vectors[3][3];
  double* rows[3] = { sums[0], sums[1], sums[2] };
  double* axes[3] = { vectors[0], vectors[1], vectors[2] };
  vtkMath::Jacobi(rows, values, axes); // the smallest is the last
  const double sign = vectors[2][2] < 0.0 ? -1.0 : 1.0;
  for (int i = 0; i < 3; ++i)
  {
    plane.Normal[i] = sign * vectors[i][2];
  }
  plane.Deviation = std::sqrt(std::max(0.0, values[2]));
  return plane;
}

vtkSmartPointer<vtkDoubleArray> MakeRows(const char* name, int components)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  return array;
}

} // namespace

/// Finds planes one after the other.
class vtkHeliosPCLPlanes::Search
{
public:
  Search(const vtkHeliosPCLPlanes& settings, helios::PclInput& input, const helios::GoOn& goOn)
    : Settings(settings)
    , Input(input)
    , Report(goOn)
    , Left(new pcl::Indices(static_cast<std::size_t>(input.GetSize())))
  {
    for (std::size_t i = 0; i < this->Left->size(); ++i)
    {
      (*this->Left)[i] = static_cast<pcl::index_t>(i);
    }
    this->Ids->SetName(names::PlaneIds);
    this->Ids->SetNumberOfValues(input.GetSize());
    this->Ids->FillValue(-1);
  }

  /// Finds the next plane; false if there are no more, or if it was stopped.
  bool Next()
  {
    const int minimum = this->Settings.MinimumNumberOfPoints;
    pcl::PointIndices found;
    if (static_cast<int>(this->Left->size()) >= minimum)
    {
      this->FindOne(found);
    }
    if (this->IsStopped || static_cast<int>(found.indices.size()) < minimum)
    {
      return false;
    }
    for (const pcl::index_t i : found.indices)
    {
      this->Ids->SetValue(i, this->Number);
    }
    ++this->Number;
    this->Add(FitPlane(this->Input.GetData(), this->Input.GetIds(found.indices)));
    this->Left->erase(std::remove_if(this->Left->begin(), this->Left->end(),
                        [this](pcl::index_t i) { return this->Ids->GetValue(i) >= 0; }),
      this->Left->end());
    return true;
  }

  int GetNumber() const { return this->Number; }
  bool WasStopped() const { return this->IsStopped; }

  void MoveTo(vtkPolyData* output)
  {
    output->GetPointData()->AddArray(this->Ids);
    for (vtkDoubleArray* rows : { &*this->Coefficients, &*this->Centres, &*this->Deviations })
    {
      output->GetFieldData()->AddArray(rows);
    }
  }

private:
  /// Finds the remaining points on the plane that contains most of the test points.
  void FindOne(pcl::PointIndices& found)
  {
    const auto step = (this->Left->size() + MaximumSamples - 1) / MaximumSamples;
    pcl::IndicesPtr samples(new pcl::Indices);
    for (std::size_t i = 0; i < this->Left->size(); i += step)
    {
      samples->push_back((*this->Left)[i]);
    }
    const auto one = std::make_shared<Segmentation>();
    pcl::SACSegmentation<pcl::PointXYZ>& segmentation = one->Method;
    segmentation.setModelType(pcl::SACMODEL_PLANE);
    segmentation.setMethodType(pcl::SAC_RANSAC);
    segmentation.setOptimizeCoefficients(true);
    segmentation.setDistanceThreshold(this->Settings.DistanceThreshold);
    segmentation.setMaxIterations(this->Settings.MaximumNumberOfIterations);
    segmentation.setProbability(this->Settings.Probability);
    segmentation.setInputCloud(this->Input.GetCloud());
    segmentation.setIndices(samples);
    const double share = static_cast<double>(this->Number) / this->Settings.MaximumNumberOfPlanes;
    this->IsStopped = !helios::RunApart(
      this->Report, share, [one] { one->Method.segment(one->Found, one->Plane); });
    if (!this->IsStopped && !one->Found.indices.empty() && one->Plane.values.size() == 4)
    {
      this->IsolateComponent(one->Plane.values, found.indices);
    }
  }

  void IsolateComponent(const std::vector<float>& plane, pcl::Indices& near) const
  {
    near.clear();
    const auto threshold = static_cast<float>(this->Settings.DistanceThreshold);
    for (const pcl::index_t i : *this->Left)
    {
      const pcl::PointXYZ& p = (*this->Input.GetCloud())[static_cast<std::size_t>(i)];
      if (std::abs(plane[0] * p.x + plane[1] * p.y + plane[2] * p.z + plane[3]) <= threshold)
      {
        near.push_back(i);
      }
    }
  }

  void Add(const Plane& plane)
  {
    const double* n = plane.Normal;
    this->Coefficients->InsertNextTuple4(n[0], n[1], n[2], -vtkMath::Dot(n, plane.Centre));
    this->Centres->InsertNextTuple(plane.Centre);
    this->Deviations->InsertNextValue(plane.Deviation);
  }

  const vtkHeliosPCLPlanes& Settings;
  helios::PclInput& Input;
  const helios::GoOn& Report;
  bool IsStopped = false;
  pcl::IndicesPtr Left; // points on no plane yet
  vtkNew<vtkIntArray> Ids;
  int Number = 0;
  vtkSmartPointer<vtkDoubleArray> Coefficients = MakeRows(names::PlaneCoefficients, 4);
  vtkSmartPointer<vtkDoubleArray> Centres = MakeRows(names::PlaneCentre, 3);
  vtkSmartPointer<vtkDoubleArray> Deviations = MakeRows(names::PlaneDeviation, 1);
};

//------------------------------------------------------------------------------
void vtkHeliosPCLPlanes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DistanceThreshold: " << this->DistanceThreshold << " m\n"
     << indent << "MaximumNumberOfPlanes: " << this->MaximumNumberOfPlanes << "\n"
     << indent << "MinimumNumberOfPoints: " << this->MinimumNumberOfPoints << "\n"
     << indent << "MaximumNumberOfIterations: " << this->MaximumNumberOfIterations << "\n"
     << indent << "Probability: " << this->Probability << "\n"
     << indent << "NumberOfPlanes: " << this->NumberOfPlanes << "\n";
}

//------------------------------------------------------------------------------
bool vtkHeliosPCLPlanes::CheckProperties()
{
  this->NumberOfPlanes = 0;
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosPCLPlanes::Process(helios::PclInput& input, vtkPolyData* output)
{
  const helios::GoOn goOn = [this](double share) { return this->GoOn(0.1 + 0.85 * share); };
  Search search(*this, input, goOn);
  while (search.GetNumber() < this->MaximumNumberOfPlanes && search.Next())
  {
  }
  if (search.WasStopped())
  {
    return false;
  }
  this->NumberOfPlanes = search.GetNumber();
  helios::SelectPoints(input.GetData(), input.GetIds(), output);
  search.MoveTo(output);
  return true;
}
