// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosCropFieldSource.h"

#include "heliosCropFieldNames.h"
#include "heliosCropPlant.h"
#include "heliosMeshBuilder.h"
#include "heliosRandom.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

vtkStandardNewMacro(vtkHeliosCropFieldSource);

namespace
{

namespace truth = helios::cropFieldNames;

struct SpeciesDefaults
{
  const char* Name;
  double RowSpacing;
  double PlantSpacing;
  double LeafAngle; // [deg]
  double LeafDroop;
  helios::CropShape Shape; // angles are set from the above
};

constexpr SpeciesDefaults AllSpecies[] = {
  { "Maize", 0.75, 0.16, 28.0, 95.0,
    { 2.2, 0.012, 1, 6, 0.04, 0.0, 12, 0.8, 0.09, 0, 0, 0, 8, 0.4, 0.0, 0.08, 0.9, true } },
  { "Cereal", 0.125, 0.05, 25.0, 85.0,
    { 0.9, 0.0018, 4, 3, 0.18, 0.09, 12, 0.22, 0.014, 0, 0, 0, 5, 0.2, 0.0, 0.15, 0.85, true } },
  { "Broadleaf", 0.5, 0.2, 50.0, 50.0,
    { 0.6, 0.005, 1, 5, 0.08, 0.0, 24, 0.14, 0.1, 0, 0, 0, 6, 0.5, 0.6, 0.12, 0.97, false } },
};

constexpr double MaximumNumberOfTriangles = 5e8;

enum Draw : std::uint32_t
{
  EmergenceDraw = 100,
  JitterDraw = 101,
  HeightDraw = 102
};

/// The properties, with the species' own values for 0.
struct Settings
{
  double RowSpacing;
  double PlantSpacing;
  double PlantsPerRow;
  double GroundSize[2];
  helios::CropShape Shape;

  explicit Settings(vtkHeliosCropFieldSource* field)
  {
    const auto pick = [](auto set, auto own) { return set > 0 ? set : own; };
    const SpeciesDefaults& own = AllSpecies[field->GetSpecies()];
    this->RowSpacing = pick(field->GetRowSpacing(), own.RowSpacing);
    this->PlantSpacing = pick(field->GetPlantSpacing(), own.PlantSpacing);
    // A row length of a whole number of spacings ends with a plant, despite rounding.
    this->PlantsPerRow = std::floor(field->GetRowLength() / this->PlantSpacing + 1e-9) + 1.0;
    const double margin = 2.0 * (field->GetGroundMargin() + 3.0 * field->GetPositionJitter());
    this->GroundSize[0] = (field->GetNumberOfRows() - 1) * this->RowSpacing + margin;
    this->GroundSize[1] = (this->PlantsPerRow - 1) * this->PlantSpacing + margin;

    helios::CropShape& shape = this->Shape;
    shape = own.Shape;
    shape.Height = pick(field->GetPlantHeight(), shape.Height);
    shape.EarLength *= shape.Height / own.Shape.Height;
    shape.StemRadius = pick(field->GetStemRadius(), shape.StemRadius);
    shape.Stems = pick(field->GetStemsPerPlant(), shape.Stems);
    shape.Leaves = field->GetLeavesPerPlant() < 0 ? shape.Leaves : field->GetLeavesPerPlant();
    shape.LeafLength = pick(field->GetLeafLength(), shape.LeafLength);
    shape.LeafWidth = pick(field->GetLeafWidth(), shape.LeafWidth);
    shape.LeafAngle = vtkMath::RadiansFromDegrees(pick(field->GetLeafAngle(), own.LeafAngle));
    shape.LeafDroop = vtkMath::RadiansFromDegrees(
      field->GetLeafDroop() < 0 ? own.LeafDroop : field->GetLeafDroop());
    shape.LeafVariation = field->GetLeafVariation();
    shape.LeafSegments = std::max(2, pick(field->GetLeafSegments(), shape.LeafSegments));
  }

  double GetNumberOfTriangles(vtkHeliosCropFieldSource* field) const
  {
    const double cells = field->GetGroundRoughness() > 0
      ? std::ceil(this->GroundSize[0] / field->GetGroundSpacing()) *
        std::ceil(this->GroundSize[1] / field->GetGroundSpacing())
      : 1.0;
    return 2.0 * cells +
      field->GetNumberOfRows() * this->PlantsPerRow *
      static_cast<double>(helios::CountTriangles(this->Shape));
  }
};

double CutNormal(double value)
{
  return std::clamp(value, -3.0, 3.0);
}

/// Builds one field, row by row.
class FieldMaker
{
public:
  FieldMaker(vtkHeliosCropFieldSource* field, const Settings& settings)
    : Field(field)
    , Set(settings)
    , Ground(settings.GroundSize[0], settings.GroundSize[1], field->GetGroundSpacing(),
        field->GetGroundRoughness(), field->GetSeed())
  {
    this->PartIds->SetName(vtkHeliosArrayNames::PartIds);
    this->Positions->SetName(truth::PlantPosition);
    this->Positions->SetNumberOfComponents(3);
    this->Heights->SetName(truth::PlantHeight);
    this->LeafAreas->SetName(truth::PlantLeafArea);
  }

  void Make(vtkPolyData* scene)
  {
    this->Reserve();
    this->Ground.AddTo(this->Mesh);
    this->ClosePart(0);
    const int rows = this->Field->GetNumberOfRows();
    for (int row = 0; row < rows; ++row)
    {
      for (vtkIdType place = 0; place < static_cast<vtkIdType>(this->Set.PlantsPerRow); ++place)
      {
        if (this->IsUp(row, place))
        {
          this->AddPlant(row, place);
        }
      }
    }
    double origin[3];
    this->Field->GetOrigin(origin);
    this->Mesh.Finish(scene, origin);
    scene->GetCellData()->AddArray(this->PartIds);
    this->AddTruth(scene->GetFieldData(), origin);
  }

private:
  /// Returns the random number key of a plant.
  static std::uint64_t GetSite(int row, vtkIdType place)
  {
    return (static_cast<std::uint64_t>(row) << 32) | static_cast<std::uint32_t>(place);
  }

  std::uint64_t GetSeed() const { return static_cast<std::uint64_t>(this->Field->GetSeed()); }

  bool IsUp(int row, vtkIdType place) const
  {
    return helios::Uniform4(this->GetSeed(), helios::RandomStream::Scene, GetSite(row, place),
             EmergenceDraw)[0] < this->Field->GetEmergence();
  }

  /// Reserves memory for all emerged plants, to avoid reallocation.
  void Reserve()
  {
    vtkIdType plants = 0;
    for (int row = 0; row < this->Field->GetNumberOfRows(); ++row)
    {
      for (vtkIdType place = 0; place < static_cast<vtkIdType>(this->Set.PlantsPerRow); ++place)
      {
        plants += this->IsUp(row, place);
      }
    }
    const vtkIdType ground = this->Ground.GetNumberOfTriangles();
    const vtkIdType triangles = ground + plants * helios::CountTriangles(this->Set.Shape);
    this->Mesh.Reserve(
      this->Ground.GetNumberOfPoints() + plants * helios::CountPoints(this->Set.Shape), triangles);
    this->PartIds->Resize(triangles);
    this->Positions->Resize(plants);
    this->Heights->Resize(plants);
    this->LeafAreas->Resize(plants);
  }

  /// Assigns all triangles since the last call to this part.
  void ClosePart(int part)
  {
    while (this->PartIds->GetNumberOfValues() < this->Mesh.GetNumberOfTriangles())
    {
      this->PartIds->InsertNextValue(part);
    }
  }

  void AddPlant(int row, vtkIdType place)
  {
    const std::uint64_t site = GetSite(row, place);
    const auto jitter =
      helios::NormalPair(this->GetSeed(), helios::RandomStream::Scene, site, JitterDraw);
    const auto normal =
      helios::NormalPair(this->GetSeed(), helios::RandomStream::Scene, site, HeightDraw);
    helios::CropPlant plant;
    plant.Seed = this->GetSeed();
    plant.Site = site;
    plant.Position[0] = (row - 0.5 * (this->Field->GetNumberOfRows() - 1)) * this->Set.RowSpacing +
      this->Field->GetPositionJitter() * CutNormal(jitter[0]);
    plant.Position[1] =
      (static_cast<double>(place) - 0.5 * (this->Set.PlantsPerRow - 1.0)) * this->Set.PlantSpacing +
      this->Field->GetPositionJitter() * CutNormal(jitter[1]);
    plant.Position[2] = this->Ground.GetHeight(plant.Position[0], plant.Position[1]);
    plant.Height =
      this->Set.Shape.Height + this->Field->GetPlantHeightDeviation() * CutNormal(normal[0]);

    const double area = helios::AddCropPlant(this->Mesh, this->Set.Shape, plant, this->Ground);
    this->Positions->InsertNextTypedTuple(plant.Position.GetData());
    this->Heights->InsertNextValue(plant.Height);
    this->LeafAreas->InsertNextValue(area);
    this->ClosePart(static_cast<int>(this->Heights->GetNumberOfValues()));
  }

  void AddTruth(vtkFieldData* fields, const double origin[3])
  {
    for (vtkIdType i = 0; i < this->Positions->GetNumberOfValues(); ++i)
    {
      this->Positions->SetValue(i, this->Positions->GetValue(i) + origin[i % 3]);
    }
    double leaves = 0.0;
    for (vtkIdType i = 0; i < this->LeafAreas->GetNumberOfValues(); ++i)
    {
      leaves += this->LeafAreas->GetValue(i);
    }
    const double ground = this->Field->GetNumberOfRows() * this->Set.RowSpacing *
      this->Set.PlantsPerRow * this->Set.PlantSpacing;
    AddValue(fields, truth::LeafArea, leaves);
    AddValue(fields, truth::GroundArea, ground);
    AddValue(fields, truth::LeafAreaIndex, leaves / ground);
    fields->AddArray(this->Positions);
    fields->AddArray(this->Heights);
    fields->AddArray(this->LeafAreas);
  }

  static void AddValue(vtkFieldData* fields, const char* name, double value)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->InsertNextValue(value);
    fields->AddArray(array);
  }

  vtkHeliosCropFieldSource* Field;
  const Settings& Set;
  helios::CropGround Ground;
  helios::MeshBuilder Mesh;
  vtkNew<vtkIntArray> PartIds;
  vtkNew<vtkDoubleArray> Positions;
  vtkNew<vtkDoubleArray> Heights;
  vtkNew<vtkDoubleArray> LeafAreas;
};

} // namespace

//------------------------------------------------------------------------------
vtkHeliosCropFieldSource::vtkHeliosCropFieldSource()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
const char* vtkHeliosCropFieldSource::GetSpeciesAsString()
{
  return AllSpecies[this->Species].Name;
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosCropFieldSource::GetPlantsPerRow()
{
  return static_cast<vtkIdType>(Settings(this).PlantsPerRow);
}

//------------------------------------------------------------------------------
int vtkHeliosCropFieldSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!this->CheckProperties())
  {
    return 0;
  }
  const Settings settings(this);
  FieldMaker(this, settings).Make(vtkPolyData::GetData(outputVector));
  return 1;
}

//------------------------------------------------------------------------------
bool vtkHeliosCropFieldSource::CheckProperties()
{
  const std::pair<const char*, double> numbers[] = { { "RowSpacing", this->RowSpacing },
    { "PlantSpacing", this->PlantSpacing }, { "RowLength", this->RowLength },
    { "Emergence", this->Emergence }, { "PositionJitter", this->PositionJitter },
    { "PlantHeight", this->PlantHeight }, { "PlantHeightDeviation", this->PlantHeightDeviation },
    { "StemRadius", this->StemRadius }, { "LeafLength", this->LeafLength },
    { "LeafWidth", this->LeafWidth }, { "LeafAngle", this->LeafAngle },
    { "LeafDroop", this->LeafDroop }, { "LeafVariation", this->LeafVariation },
    { "GroundMargin", this->GroundMargin }, { "GroundRoughness", this->GroundRoughness },
    { "GroundSpacing", this->GroundSpacing }, { "Origin", this->Origin[0] },
    { "Origin", this->Origin[1] }, { "Origin", this->Origin[2] } };
  for (const auto& [name, value] : numbers)
  {
    if (!std::isfinite(value))
    {
      vtkErrorMacro(<< name << " is " << value << "; set a finite number");
      return false;
    }
  }
  const Settings settings(this);
  if (this->PlantHeightDeviation >= 0.25 * settings.Shape.Height)
  {
    vtkErrorMacro(<< "PlantHeightDeviation " << this->PlantHeightDeviation
                  << " m is a quarter of PlantHeight " << settings.Shape.Height
                  << " m or more; lower it");
    return false;
  }
  const double triangles = settings.GetNumberOfTriangles(this);
  if (triangles > MaximumNumberOfTriangles)
  {
    vtkErrorMacro(<< this->NumberOfRows << " rows of " << settings.PlantsPerRow << " plants with "
                  << settings.Shape.Leaves << " leaves, and soil every " << this->GroundSpacing
                  << " m, make about " << triangles << " triangles, more than "
                  << MaximumNumberOfTriangles
                  << "; lower NumberOfRows, RowLength, LeavesPerPlant or LeafSegments, or raise "
                     "GroundSpacing");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosCropFieldSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Species: " << this->GetSpeciesAsString() << "\n";
  os << indent << "NumberOfRows: " << this->NumberOfRows << "\n";
  os << indent << "RowSpacing: " << this->RowSpacing << "\n";
  os << indent << "PlantSpacing: " << this->PlantSpacing << "\n";
  os << indent << "RowLength: " << this->RowLength << "\n";
  os << indent << "Emergence: " << this->Emergence << "\n";
  os << indent << "PositionJitter: " << this->PositionJitter << "\n";
  os << indent << "PlantHeight: " << this->PlantHeight << "\n";
  os << indent << "PlantHeightDeviation: " << this->PlantHeightDeviation << "\n";
  os << indent << "StemRadius: " << this->StemRadius << "\n";
  os << indent << "StemsPerPlant: " << this->StemsPerPlant << "\n";
  os << indent << "LeavesPerPlant: " << this->LeavesPerPlant << "\n";
  os << indent << "LeafLength: " << this->LeafLength << "\n";
  os << indent << "LeafWidth: " << this->LeafWidth << "\n";
  os << indent << "LeafAngle: " << this->LeafAngle << "\n";
  os << indent << "LeafDroop: " << this->LeafDroop << "\n";
  os << indent << "LeafVariation: " << this->LeafVariation << "\n";
  os << indent << "LeafSegments: " << this->LeafSegments << "\n";
  os << indent << "GroundMargin: " << this->GroundMargin << "\n";
  os << indent << "GroundRoughness: " << this->GroundRoughness << "\n";
  os << indent << "GroundSpacing: " << this->GroundSpacing << "\n";
  os << indent << "Origin: " << this->Origin[0] << " " << this->Origin[1] << " " << this->Origin[2]
     << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
