// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosScanPositionPlanner.h"

#include "heliosCoverExact.h"
#include "heliosPlan.h"
#include "heliosPlanOutput.h"
#include "heliosStatus.h"
#include "heliosVisibility.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <chrono>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

namespace names = vtkHeliosArrayNames;

namespace
{

constexpr const char* MethodNames[] = { "ViewshedSize", "MeanIncidenceAngle", "Greedy", "Best",
  "Optimal" };

constexpr std::chrono::milliseconds TimeBetweenReports(50);

using Vectors = std::vector<helios::Incidence::Vector>;

/// Reads coordinates or normals; returns an error with the tuple that is not finite.
helios::Status Read(vtkDataArray* array, const std::string& what, Vectors& vectors)
{
  vectors.resize(array ? array->GetNumberOfTuples() : 0);
  for (std::size_t i = 0; i < vectors.size(); ++i)
  {
    helios::Incidence::Vector& v = vectors[i];
    array->GetTuple(static_cast<vtkIdType>(i), v.data());
    if (!std::isfinite(v[0] + v[1] + v[2]))
    {
      return helios::Status::Error(
        what + " " + std::to_string(i) + " is not finite; correct it, or leave it out");
    }
  }
  return {};
}

} // namespace

/// One update: the data computed from the inputs.
class vtkHeliosScanPositionPlanner::Run
{
public:
  Run(vtkHeliosScanPositionPlanner* self, vtkPolyData* candidates, vtkPolyData* testPoints)
    : Self(self)
    , Candidates(candidates)
    , TestPoints(testPoints)
  {
  }

  helios::Status Execute()
  {
    helios::Status status = this->ReadMatrix();
    status = status.IsOk() ? this->ReadWeights() : status;
    status = status.IsOk() ? this->ReadGeometry() : status;
    status = status.IsOk() ? this->ReadCoverage() : status;
    status = status.IsOk() ? this->ReadObjects() : status;
    status = status.IsOk() ? this->ReadMeanAngles() : status;
    return status.IsOk() ? this->Plan() : status;
  }

  void Output(vtkPolyData* candidates, vtkPolyData* testPoints, vtkPolyData* selected)
  {
    const helios::PlanOutput output(this->Problem, this->Angles, this->Result.Selected);
    this->StoreResult(output);
    output.WriteCandidates(this->Candidates, this->MeanAngles, candidates);
    this->AddNumbers(candidates);
    output.WriteTestPoints(this->TestPoints, testPoints);
    output.WriteSelected(candidates, selected);
  }

private:
  helios::Status ReadMatrix()
  {
    if (this->Candidates->GetNumberOfPoints() == 0)
    {
      return helios::Status::Error(
        "there are no candidates on port 0; connect vtkHeliosViewsheds, and see which of its "
        "limits removed them all");
    }
    if (this->TestPoints->GetNumberOfPoints() == 0)
    {
      return helios::Status::Error(
        "there are no test points on port 1; connect those the viewsheds were made with");
    }
    if (this->Self->Method == OPTIMAL && !helios::HasExactSolver())
    {
      return helios::Status::Error(
        "the method optimal needs COIN-OR CBC, which this build does not include; build with "
        "VTKHELIOS_ENABLE_CBC, or use best");
    }
    helios::Visibility matrix;
    helios::Status status = matrix.Set(this->Candidates, this->TestPoints->GetNumberOfPoints());
    if (status.IsOk())
    {
      this->Rows = { matrix.GetRow(0), static_cast<int>(matrix.GetNumberOfCandidates()),
        static_cast<int>(matrix.GetNumberOfTestPoints()), static_cast<int>(matrix.GetRowLength()) };
    }
    return status;
  }

  helios::Status ReadWeights()
  {
    vtkDataArray* areas = this->TestPoints->GetPointData()->GetArray(names::Area);
    if (!this->Self->UseAreas)
    {
      return {};
    }
    const vtkIdType count = this->TestPoints->GetNumberOfPoints();
    if (!areas || areas->GetNumberOfComponents() != 1 || areas->GetNumberOfTuples() != count)
    {
      return helios::Status::Error(
        std::string("UseAreas is on, but the test points have no point array ") + names::Area +
        " of one component; use those of vtkHeliosVisibilityTestPoints, or switch UseAreas off");
    }
    for (vtkIdType v = 0; v < count; ++v)
    {
      const double area = areas->GetComponent(v, 0);
      if (!(area >= 0.0 && std::isfinite(area)))
      {
        std::ostringstream text;
        text << names::Area << " of test point " << v << " is " << area
             << "; areas are finite and not negative";
        return helios::Status::Error(text.str());
      }
      this->Weights.push_back(area);
    }
    return {};
  }

  helios::Status ReadGeometry()
  {
    vtkDataArray* normals = this->TestPoints->GetPointData()->GetArray(names::Normal);
    const vtkIdType count = this->TestPoints->GetNumberOfPoints();
    if (normals && (normals->GetNumberOfComponents() != 3 || normals->GetNumberOfTuples() != count))
    {
      return helios::Status::Error(std::string(names::Normal) + " of the test points has " +
        std::to_string(normals->GetNumberOfTuples()) + " tuples of " +
        std::to_string(normals->GetNumberOfComponents()) + " components; expected " +
        std::to_string(count) + " of 3");
    }
    Vectors positions;
    Vectors points;
    Vectors directions;
    helios::Status status = Read(this->Candidates->GetPoints()->GetData(), "candidate", positions);
    status =
      status.IsOk() ? Read(this->TestPoints->GetPoints()->GetData(), "test point", points) : status;
    status = status.IsOk() ? Read(normals, "the normal of test point", directions) : status;
    this->Angles =
      helios::Incidence(std::move(positions), std::move(points), std::move(directions));
    return status;
  }

  helios::Status ReadCoverage()
  {
    this->Problem = helios::CoverProblem(this->Rows, std::move(this->Weights));
    const double coverable = this->Problem.GetWeight(this->Problem.Coverable.data());
    if (!(coverable > 0.0))
    {
      return helios::Status::Error(std::string("no candidate sees ") +
        (this->Self->UseAreas ? "a test point with an area" : "any test point") +
        "; widen the limits of the viewsheds, or check that candidates lie outside solids");
    }
    this->All = this->Self->UseAreas ? this->GetAllWeight() : this->Rows.Columns;
    if (this->Self->MinimumCoverage == 0.0 && this->Self->MinimumObjectCoverage == 0.0)
    {
      return helios::Status::Error("the minimum coverage is 0 %, so nothing is required; give one "
                                   "above 0, or one of the objects");
    }
    const double base = this->Self->CoverageOf == COVERABLE ? coverable : this->All;
    const double required = base * this->Self->MinimumCoverage / 100.0;
    if (required > coverable * (1.0 + 1e-12))
    {
      std::ostringstream text;
      text << "the minimum coverage of " << this->Self->MinimumCoverage
           << " % of all test points cannot be reached: all candidates together see "
           << 100.0 * coverable / this->All
           << " %; lower it, add candidates, or require a share of the coverable ones only";
      return helios::Status::Error(text.str());
    }
    this->Problem.Require(required);
    return {};
  }

  /// Reads the share that is required of each object.
  helios::Status ReadObjects()
  {
    const double share = this->Self->MinimumObjectCoverage / 100.0;
    if (share == 0.0)
    {
      return {};
    }
    vtkDataArray* parts = this->TestPoints->GetPointData()->GetArray(names::PartIds);
    const vtkIdType count = this->TestPoints->GetNumberOfPoints();
    if (!parts || parts->GetNumberOfComponents() != 1 || parts->GetNumberOfTuples() != count)
    {
      return helios::Status::Error(std::string("coverage of objects needs the point array ") +
        names::PartIds +
        " of the test points, which a scene without parts does not give; plan a "
        "scene with parts, or leave it out");
    }
    std::vector<int> objects(static_cast<std::size_t>(count));
    std::vector<double> weights;
    for (vtkIdType v = 0; v < count; ++v)
    {
      const int object = static_cast<int>(parts->GetComponent(v, 0));
      objects[v] = object;
      if (object >= static_cast<int>(weights.size()))
      {
        weights.resize(static_cast<std::size_t>(object) + 1);
      }
      if (object >= 0 && helios::HasBit(this->Problem.Coverable.data(), static_cast<int>(v)))
      {
        weights[object] += share * this->Problem.GetWeight(static_cast<int>(v));
      }
    }
    this->Problem.RequireObjects(objects, weights);
    return {};
  }

  double GetAllWeight() const
  {
    double sum = 0.0;
    for (const double weight : this->Problem.Weights)
    {
      sum += weight;
    }
    return sum;
  }

  helios::Status ReadMeanAngles()
  {
    const int count = this->Rows.Rows;
    vtkDataArray* given = this->Candidates->GetPointData()->GetArray(names::MeanIncidenceAngle);
    this->MeanAngles.resize(count);
    if (given && given->GetNumberOfComponents() == 1)
    {
      for (int c = 0; c < count; ++c)
      {
        this->MeanAngles[c] = given->GetComponent(c, 0);
      }
      return {};
    }
    if (!this->Angles.HasNormals() && this->Self->Method == MEAN_INCIDENCE_ANGLE)
    {
      return helios::Status::Error(std::string("Method MeanIncidenceAngle needs the point array ") +
        names::MeanIncidenceAngle + " of the candidates, or " + names::Normal +
        " of the test points; add one, or use ViewshedSize");
    }
    vtkSMPTools::For(0, count, 16,
      [this](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType c = begin; c < end; ++c)
        {
          this->MeanAngles[c] = this->Angles.HasNormals()
            ? this->Angles.GetMean(this->Problem, static_cast<int>(c))
            : std::nan("");
        }
      });
    return {};
  }

  helios::Status Plan()
  {
    helios::PlanSettings settings;
    settings.Method = static_cast<helios::PlanMethod>(this->Self->Method);
    settings.IsAscending = this->Self->RemovalOrder == ASCENDING;
    settings.MeanAngles = this->MeanAngles;
    settings.NumberOfStarts = this->Self->NumberOfStarts;
    settings.TimeLimit = this->Self->TimeLimit;
    settings.MinimumOverlap = this->Self->MinimumOverlap;
    settings.Report = [this](double progress) { this->Report(progress); };
    settings.Stop = [this] { return this->MustStop(); };
    this->Report(0.05);
    this->Result = helios::MakePlan(this->Problem, this->Angles, settings);
    if (this->Self->GetAbortExecute())
    {
      return helios::Status::Error("aborted before the plan was made; update again");
    }
    if (!this->Result.Fault.empty())
    {
      std::ostringstream text;
      text << "no set of candidates connected by the minimum overlap of "
           << 100.0 * this->Self->MinimumOverlap
           << " % sees enough; lower the overlap or the coverage, or add candidates in between";
      return helios::Status::Error(text.str());
    }
    return {};
  }

  void Report(double progress)
  {
    this->LastReport = std::chrono::steady_clock::now();
    this->Self->UpdateProgress(progress);
  }

  /// Reports from time to time: observers of progress may abort.
  bool MustStop()
  {
    if (std::chrono::steady_clock::now() - this->LastReport > TimeBetweenReports)
    {
      this->Report(this->Self->GetProgress());
    }
    return this->Self->GetAbortExecute() != 0;
  }

  void StoreResult(const helios::PlanOutput& output)
  {
    vtkHeliosScanPositionPlanner* self = this->Self;
    const double covered = output.GetCoveredWeight();
    self->NumberOfSelected = static_cast<vtkIdType>(this->Result.Selected.size());
    self->NumberCovered = output.GetCoveredCount();
    self->NumberCoverable =
      helios::CountBits(this->Problem.Coverable.data(), this->Problem.Rows.Length);
    self->Coverage = 100.0 * covered / this->All;
    self->CoverableCoverage =
      100.0 * covered / this->Problem.GetWeight(this->Problem.Coverable.data());
    self->LowerBound = this->Result.LinearBound;
    self->BestBound = this->Result.Bound;
    self->Gap = 100.0 * static_cast<double>(self->NumberOfSelected - self->BestBound) /
      static_cast<double>(self->NumberOfSelected);
    self->IsProvedOptimal = self->BestBound >= self->NumberOfSelected;
    self->WorstIncidenceAngle = output.GetQuality().Worst;
    self->MeanBestIncidenceAngle = output.GetQuality().Mean;
    self->IsWorstProvedOptimal = this->Result.IsWorstProved;
    self->IsMeanProvedOptimal = this->Result.IsMeanProved;
  }

  void AddNumbers(vtkPolyData* candidates) const
  {
    const vtkHeliosScanPositionPlanner* self = this->Self;
    const std::pair<const char*, double> numbers[] = {
      { names::PlanNumberOfSelected, static_cast<double>(self->NumberOfSelected) },
      { names::PlanNumberCovered, static_cast<double>(self->NumberCovered) },
      { names::PlanNumberCoverable, static_cast<double>(self->NumberCoverable) },
      { names::PlanCoverage, self->Coverage },
      { names::PlanCoverableCoverage, self->CoverableCoverage },
      { names::PlanLowerBound, self->LowerBound },
      { names::PlanBestBound, static_cast<double>(self->BestBound) },
      { names::PlanGap, self->Gap },
      { names::PlanIsProvedOptimal, self->IsProvedOptimal ? 1.0 : 0.0 },
      { names::PlanWorstIncidenceAngle, self->WorstIncidenceAngle },
      { names::PlanMeanBestIncidenceAngle, self->MeanBestIncidenceAngle },
    };
    for (const auto& [name, value] : numbers)
    {
      vtkNew<vtkDoubleArray> array;
      array->SetName(name);
      array->InsertNextValue(value);
      candidates->GetFieldData()->AddArray(array);
    }
  }

  vtkHeliosScanPositionPlanner* Self;
  vtkPolyData* Candidates;
  vtkPolyData* TestPoints;
  helios::BitRows Rows;
  std::vector<double> Weights;
  helios::CoverProblem Problem;
  helios::Incidence Angles;
  std::vector<double> MeanAngles;
  double All = 0.0;
  helios::PlanResult Result;
  std::chrono::steady_clock::time_point LastReport;
};

vtkStandardNewMacro(vtkHeliosScanPositionPlanner);

//------------------------------------------------------------------------------
vtkHeliosScanPositionPlanner::vtkHeliosScanPositionPlanner()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
bool vtkHeliosScanPositionPlanner::HasOptimal()
{
  return helios::HasExactSolver();
}

//------------------------------------------------------------------------------
int vtkHeliosScanPositionPlanner::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosScanPositionPlanner::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  Run run(this, vtkPolyData::GetData(inputs[0]), vtkPolyData::GetData(inputs[1]));
  const helios::Status status = run.Execute();
  if (!status.IsOk())
  {
    vtkErrorMacro(<< "Scan positions cannot be planned: " << status.Message() << ".");
    return 0;
  }
  run.Output(vtkPolyData::GetData(outputs, 0), vtkPolyData::GetData(outputs, 1),
    vtkPolyData::GetData(outputs, 2));
  this->UpdateProgress(1.0);
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosScanPositionPlanner::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << MethodNames[this->Method] << "\n"
     << indent << "RemovalOrder: " << (this->RemovalOrder == ASCENDING ? "Ascending" : "Descending")
     << "\n"
     << indent << "MinimumCoverage: " << this->MinimumCoverage << " %\n"
     << indent << "MinimumObjectCoverage: " << this->MinimumObjectCoverage << " %\n"
     << indent << "CoverageOf: " << (this->CoverageOf == COVERABLE ? "Coverable" : "All") << "\n"
     << indent << "UseAreas: " << this->UseAreas << "\n"
     << indent << "MinimumOverlap: " << this->MinimumOverlap << "\n"
     << indent << "TimeLimit: " << this->TimeLimit << " s\n"
     << indent << "NumberOfStarts: " << this->NumberOfStarts << "\n"
     << indent << "NumberOfSelected: " << this->NumberOfSelected << "\n"
     << indent << "NumberCovered: " << this->NumberCovered << "\n"
     << indent << "NumberCoverable: " << this->NumberCoverable << "\n"
     << indent << "Coverage: " << this->Coverage << " %\n"
     << indent << "CoverableCoverage: " << this->CoverableCoverage << " %\n"
     << indent << "LowerBound: " << this->LowerBound << "\n"
     << indent << "BestBound: " << this->BestBound << "\n"
     << indent << "Gap: " << this->Gap << " %\n"
     << indent << "IsProvedOptimal: " << this->IsProvedOptimal << "\n"
     << indent << "WorstIncidenceAngle: " << this->WorstIncidenceAngle << " degrees\n"
     << indent << "MeanBestIncidenceAngle: " << this->MeanBestIncidenceAngle << " degrees\n"
     << indent << "IsWorstProvedOptimal: " << this->IsWorstProvedOptimal << "\n"
     << indent << "IsMeanProvedOptimal: " << this->IsMeanProvedOptimal << "\n";
}
