// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosScanPositionCandidates.h"

#include "heliosAreas.h"
#include "heliosGridLine.h"
#include "heliosMemory.h"
#include "heliosPlanGround.h"
#include "heliosPlanScene.h"
#include "heliosSceneCrs.h"
#include "heliosSceneGeometry.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosRayCaster.h"

#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace names = vtkHeliosArrayNames;
using helios::Vec3;

namespace
{

// Rounding of slopes: a plane of 30 degrees must pass a limit of 30 degrees.
constexpr double AngleRounding = 1e-9;

// Distance to a surface below from which on a surface is a roof [m]: a person stands between them.
constexpr double Headroom = 1.8;

// How far a surface may be above the height of a place that is given [m].
constexpr double HeightTolerance = 1.0;

/// A position of the grid, and its status.
struct Place
{
  enum Fates
  {
    Kept,
    NoSurface,
    NotGround,
    TooSteep,
    Excluded,
    Roof,
    Enclosed
  };
  Fates Fate = NoSurface;
  vtkIdType Cell = -1;
  double Height = 0.0;
  double Slope = 0.0;
  Vec3 Normal{ 0.0, 0.0, 1.0 };
};

/// Directions spread evenly over the sky: a Fibonacci spiral.
std::vector<Vec3> GetSky()
{
  constexpr int Count = 128;
  const double golden = M_PI * (3.0 - std::sqrt(5.0));
  std::vector<Vec3> directions;
  for (int i = 0; i < Count; ++i)
  {
    const double z = (i + 0.5) / Count;
    const double r = std::sqrt(1.0 - z * z);
    directions.push_back({ r * std::cos(golden * i), r * std::sin(golden * i), z });
  }
  return directions;
}

} // namespace

vtkStandardNewMacro(vtkHeliosScanPositionCandidates);

/// Processes the positions of the grid.
class vtkHeliosScanPositionCandidates::Search
{
public:
  Search(vtkHeliosScanPositionCandidates* self, vtkPolyData* exclusions, vtkPolyData* places)
    : Self(self)
    , Exclusions(exclusions)
    , Given(places)
  {
  }

  helios::Status Prepare(vtkPolyData* scene)
  {
    const int surface = this->Self->Surface;
    helios::Status status = surface != HIGHEST ? this->Ground.Set(scene) : helios::Status();
    if (!status.IsOk())
    {
      return helios::Status::Error(
        "No rays can be cast onto the scene on port 0: " + status.Message());
    }
    if (this->Ground.IsEmpty() && (surface == GROUND || surface == OPEN_GROUND))
    {
      return helios::Status::Error(
        "Candidates are to be on the ground, but no material of the scene is ground "
        "(Material.IsGround, helios_isGround); mark the ground, or use the highest surface");
    }
    return this->IsBelowOthers() ? this->Scene.Set(this->Ground) : this->Scene.Set(scene);
  }

  /// Builds the grid, unless places are given.
  helios::Status MakeGrid()
  {
    if (this->Given)
    {
      this->Rows = this->Given->GetNumberOfPoints();
      return this->Rows > 0 ? helios::Status()
                            : helios::Status::Error("There is no place on port 2; give some");
    }
    const double* region = this->Self->Region;
    double bounds[4];
    for (int side = 0; side < 4; ++side)
    {
      bounds[side] = this->Scene.GetBound(region[side], side);
    }
    if (!(bounds[0] <= bounds[1] && bounds[2] <= bounds[3]))
    {
      std::ostringstream text;
      text << "The region of candidates is x " << bounds[0] << " to " << bounds[1] << ", y "
           << bounds[2] << " to " << bounds[3]
           << "; the first of each must not be above the second";
      return helios::Status::Error(text.str());
    }
    this->X = helios::GridLine(bounds[0], bounds[1], this->Scene.GetStep(this->Self->XStep));
    this->Y = helios::GridLine(bounds[2], bounds[3], this->Scene.GetStep(this->Self->YStep));
    const double count =
      static_cast<double>(this->X.GetCount()) * static_cast<double>(this->Y.GetCount());
    const helios::Status status =
      helios::CheckMemoryLimit("places", count, sizeof(Place), this->Self->MemoryLimit);
    this->Rows = this->Y.GetCount();
    return status.IsOk()
      ? status
      : helios::Status::Error(status.Message() + "; make the grid of candidates coarser");
  }

  /// Checks all positions; false on an abort request.
  bool Run()
  {
    const vtkIdType rows = this->Rows;
    this->Places.resize(static_cast<std::size_t>(rows * this->GetLength()));
    constexpr vtkIdType RowsAtOnce = 64;
    for (vtkIdType row = 0; row < rows; row += RowsAtOnce)
    {
      vtkSMPTools::For(row, std::min(rows, row + RowsAtOnce), 1,
        [this](vtkIdType begin, vtkIdType end)
        {
          for (vtkIdType j = begin; j < end; ++j)
          {
            this->CheckRow(j);
          }
        });
      this->Self->UpdateProgress(static_cast<double>(row) / static_cast<double>(rows));
      if (this->Self->GetAbortExecute())
      {
        return false;
      }
    }
    return true;
  }

  /// Restores positions on roofs if there are no others; returns their number.
  vtkIdType RestoreRoofs()
  {
    const vtkIdType roofs = this->GetCount(Place::Roof);
    if (roofs == 0 || this->GetCount(Place::Kept) > 0)
    {
      return 0;
    }
    for (Place& place : this->Places)
    {
      place.Fate = place.Fate == Place::Roof ? Place::Kept : place.Fate;
    }
    return roofs;
  }

  /// Removes enclosed positions, unless all are, or they are given.
  helios::Status LeaveOutEnclosed(vtkPolyData* scene)
  {
    if (!this->IsBelowOthers() || this->Given)
    {
      return {}; // nothing overhead, or as asked
    }
    helios::PlanScene whole;
    const helios::Status status = whole.Set(scene);
    if (!status.IsOk())
    {
      return status;
    }
    std::vector<unsigned char> isEnclosed(this->Places.size());
    const std::vector<Vec3> sky = GetSky();
    vtkSMPTools::For(0, static_cast<vtkIdType>(this->Places.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          isEnclosed[i] = this->Places[i].Fate == Place::Kept &&
            !this->SeesSky(whole.GetCaster(), this->GetPosition(i), sky);
        }
      });
    const bool hasOpen =
      std::count(isEnclosed.begin(), isEnclosed.end(), 1) < this->GetCount(Place::Kept);
    for (std::size_t i = 0; i < isEnclosed.size() && hasOpen; ++i)
    {
      this->Places[i].Fate = isEnclosed[i] ? Place::Enclosed : this->Places[i].Fate;
    }
    return {};
  }

  vtkIdType GetCount(int fate) const
  {
    return std::count_if(this->Places.begin(), this->Places.end(),
      [fate](const Place& place) { return place.Fate == fate; });
  }

  void Fill(vtkPolyData* output) const
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkDoubleArray> slopes;
    slopes->SetName(names::Slope);
    vtkNew<vtkIdTypeArray> cells;
    cells->SetName(names::CellIds);
    vtkNew<vtkDoubleArray> normals;
    normals->SetName(names::Normal);
    normals->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < static_cast<vtkIdType>(this->Places.size()); ++i)
    {
      const Place& place = this->Places[static_cast<std::size_t>(i)];
      if (place.Fate == Place::Kept)
      {
        points->InsertNextPoint(this->GetPosition(i).GetData());
        slopes->InsertNextValue(place.Slope);
        cells->InsertNextValue(this->Scene.GetCell(place.Cell));
        normals->InsertNextTuple(place.Normal.GetData());
      }
    }
    output->SetPoints(points);
    for (vtkDataArray* array : { static_cast<vtkDataArray*>(slopes.Get()),
           static_cast<vtkDataArray*>(cells.Get()), static_cast<vtkDataArray*>(normals.Get()) })
    {
      output->GetPointData()->AddArray(array);
    }
  }

private:
  /// Returns whether surfaces may be above positions.
  bool IsBelowOthers() const
  {
    return !this->Ground.IsEmpty() && this->Self->Surface != OPEN_GROUND;
  }

  /// Returns the position of the instrument.
  Vec3 GetPosition(vtkIdType place) const
  {
    const Vec3 at = this->GetPlace(place);
    return { at[0], at[1],
      this->Places[static_cast<std::size_t>(place)].Height + this->Self->ScannerHeight };
  }

  /// Returns the places of a row.
  vtkIdType GetLength() const { return this->Given ? 1 : this->X.GetCount(); }

  /// Returns x and y of a place, and its height if it has one, else NaN.
  Vec3 GetPlace(vtkIdType place) const
  {
    if (this->Given)
    {
      double at[3];
      this->Given->GetPoint(place, at);
      return { at[0], at[1], at[2] };
    }
    return { this->X.GetPlace(place % this->X.GetCount()),
      this->Y.GetPlace(place / this->X.GetCount()), NotGiven };
  }

  static bool SeesSky(
    const vtkHeliosRayCaster& caster, const Vec3& position, const std::vector<Vec3>& sky)
  {
    return std::any_of(sky.rbegin(), sky.rend(), // the zenith first
      [&](const Vec3& up)
      {
        const vtkHeliosRay ray{ { position[0], position[1], position[2] },
          { up[0], up[1], up[2] } };
        unsigned char isHidden;
        caster.Occluded(&ray, &isHidden, 1);
        return !isHidden;
      });
  }

  void CheckRow(vtkIdType row)
  {
    const vtkIdType count = this->GetLength();
    const double* bounds = this->Scene.GetBounds();
    const double top = bounds[5] + std::max(1.0, bounds[5] - bounds[4]);
    std::vector<vtkHeliosRay> rays;
    for (vtkIdType i = 0; i < count; ++i)
    {
      const Vec3 at = this->GetPlace(row * count + i);
      const double begin = at[2] == at[2] ? std::min(top, at[2] + HeightTolerance) : top;
      rays.push_back({ { at[0], at[1], begin }, { 0.0, 0.0, -1.0 } });
    }
    std::vector<vtkHeliosHit> hits(rays.size());
    this->Scene.GetCaster().Intersect(rays.data(), hits.data(), count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      Place& place = this->Places[static_cast<std::size_t>(row * count + i)];
      place.Cell = hits[i].CellId;
      place.Height = rays[i].Origin[2] - hits[i].Range;
      this->Classify(rays[i].Origin, place);
      if (place.Fate == Place::Kept && this->IsWithoutRoofs() && rays[i].Origin[2] == top)
      {
        place.Fate = this->IsRoof(rays[i].Origin, place.Height) ? Place::Roof : Place::Kept;
      }
    }
  }

  /// Returns whether places on roofs are left out: the scene does not say what is ground.
  bool IsWithoutRoofs() const { return this->Self->Surface == AUTOMATIC && this->Ground.IsEmpty(); }

  /// Returns whether a surface at a height is above another one.
  bool IsRoof(const double* place, double height) const
  {
    const vtkHeliosRay ray{ { place[0], place[1], height - Headroom }, { 0.0, 0.0, -1.0 } };
    unsigned char isAbove;
    this->Scene.GetCaster().Occluded(&ray, &isAbove, 1);
    return isAbove != 0;
  }

  bool IsOnGround(vtkIdType cell) const
  {
    return this->Ground.Has(this->Scene.GetCaster().GetGeometry().Find(cell));
  }

  void Classify(const double* origin, Place& place) const
  {
    if (place.Cell < 0)
    {
      place.Fate = Place::NoSurface;
      return;
    }
    place.Normal = this->Scene.GetFaceNormal(place.Cell);
    place.Normal = place.Normal[2] < 0.0 ? -1.0 * place.Normal : place.Normal;
    const Vec3& n = place.Normal;
    place.Slope = vtkMath::DegreesFromRadians(std::atan2(std::hypot(n[0], n[1]), n[2]));
    if (this->Self->Surface == OPEN_GROUND && !this->IsOnGround(place.Cell))
    {
      place.Fate = Place::NotGround;
    }
    else if (place.Slope > this->Self->MaximumSlope + AngleRounding)
    {
      place.Fate = Place::TooSteep;
    }
    else
    {
      place.Fate = this->Exclusions.Contain(origin[0], origin[1]) ? Place::Excluded : Place::Kept;
    }
  }

  vtkHeliosScanPositionCandidates* Self;
  helios::Areas Exclusions;
  helios::PlanScene Scene;
  helios::PlanGround Ground; ///< empty: all surfaces are
  vtkPolyData* Given;        ///< null: the grid
  vtkIdType Rows = 0;
  helios::GridLine X{ 0.0, 0.0, 1.0 };
  helios::GridLine Y{ 0.0, 0.0, 1.0 };
  std::vector<Place> Places; ///< in rows of x
};

//------------------------------------------------------------------------------
vtkHeliosScanPositionCandidates::vtkHeliosScanPositionCandidates()
{
  this->SetNumberOfInputPorts(3);
}

//------------------------------------------------------------------------------
void vtkHeliosScanPositionCandidates::SetStep(double step)
{
  this->SetXStep(step);
  this->SetYStep(step);
}

//------------------------------------------------------------------------------
int vtkHeliosScanPositionCandidates::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port > 0);
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosScanPositionCandidates::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* scene = vtkPolyData::GetData(inputs[0]);
  Search search(this, vtkPolyData::GetData(inputs[1]), vtkPolyData::GetData(inputs[2]));
  helios::Status status = search.Prepare(scene);
  status = status.IsOk() ? search.MakeGrid() : status;
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message() << ".");
    return 0;
  }
  if (!search.Run())
  {
    vtkErrorMacro(<< "Aborted; update again for all candidates.");
    return 0;
  }
  if (const vtkIdType roofs = search.RestoreRoofs())
  {
    vtkWarningMacro(<< "All of " << roofs << " places are " << Headroom
                    << " m or more above another surface, as on a roof, and are used; give "
                       "helios_isGround true to the materials of the ground in the .mtl file.");
  }
  status = this->SkipEnclosed ? search.LeaveOutEnclosed(scene) : helios::Status();
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message() << ".");
    return 0;
  }
  this->NumberOfEnclosed = search.GetCount(Place::Enclosed);
  this->NumberOnRoofs = search.GetCount(Place::Roof);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  search.Fill(output);
  helios::SetCRS(output, helios::GetCRS(scene));
  return this->Report(search) ? 1 : 0;
}

//------------------------------------------------------------------------------
bool vtkHeliosScanPositionCandidates::Report(const Search& search)
{
  if (search.GetCount(Place::Kept) > 0)
  {
    return true;
  }
  const vtkIdType misses = search.GetCount(Place::NoSurface);
  const vtkIdType others = search.GetCount(Place::NotGround);
  const vtkIdType steep = search.GetCount(Place::TooSteep);
  const vtkIdType excluded = search.GetCount(Place::Excluded);
  std::ostringstream text;
  text << "No candidate is left of " << misses + others + steep + excluded << " places: " << misses
       << " have no surface below, at " << others << " the highest surface is not ground, " << steep
       << " are steeper than the maximum slope (" << this->MaximumSlope << " deg), " << excluded
       << " lie in excluded areas; ";
  const bool isGiven = this->GetNumberOfInputConnections(2) > 0;
  const std::string finer = isGiven ? "give other places" : "make the grid finer";
  const std::string what = isGiven ? "places" : "region";
  const vtkIdType maximum = std::max(std::max(misses, others), std::max(steep, excluded));
  text << (maximum == steep ? "allow a larger slope, or " + finer
      : maximum == misses   ? "move the " + what + " onto the scene, or " + finer
      : maximum == excluded ? std::string("exclude less")
                            : std::string("use ground below other surfaces, too"));
  vtkErrorMacro(<< text.str() << ".");
  return false;
}

//------------------------------------------------------------------------------
void vtkHeliosScanPositionCandidates::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const surfaces[] = { "Highest", "Ground", "OpenGround", "Automatic" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "XStep: " << this->XStep << " m\n"
     << indent << "YStep: " << this->YStep << " m\n"
     << indent << "Region: x " << this->Region[0] << " to " << this->Region[1] << ", y "
     << this->Region[2] << " to " << this->Region[3] << " m\n"
     << indent << "MaximumSlope: " << this->MaximumSlope << " deg\n"
     << indent << "Surface: " << surfaces[this->Surface] << "\n"
     << indent << "SkipEnclosed: " << this->SkipEnclosed << "\n"
     << indent << "NumberOfEnclosed: " << this->NumberOfEnclosed << "\n"
     << indent << "NumberOnRoofs: " << this->NumberOnRoofs << "\n"
     << indent << "ScannerHeight: " << this->ScannerHeight << " m\n"
     << indent << "MemoryLimit: " << this->MemoryLimit << " MiB\n";
}
