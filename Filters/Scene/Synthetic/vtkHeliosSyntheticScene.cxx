// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosSyntheticScene.h"

#include "heliosMeshBuilder.h"
#include "heliosSyntheticHouse.h"
#include "heliosSyntheticShapes.h"
#include "heliosSyntheticTerrain.h"
#include "heliosSyntheticTree.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <cmath>

vtkStandardNewMacro(vtkHeliosSyntheticScene);

namespace
{

struct KindDefaults
{
  const char* Name;
  double Size;
  double Height;
  int Resolution;
  int NumberOfLeaves;
  int TrianglesPerSquare; // per square of Resolution
};

constexpr KindDefaults Kinds[] = {
  { "Plane", 100.0, 0.0, 1, 0, 2 }, { "Step", 100.0, 10.0, 1, 0, 6 },
  { "Sphere", 10.0, 0.0, 32, 0, 20 }, { "Pyramid", 10.0, 10.0, 1, 0, 6 },
  { "Terrain", 1000.0, 20.0, 1000, 0, 2 }, { "Canopy", 100.0, 15.0, 200, 2500, 2 },
  { "Blocks", 100.0, 10.0, 7, 0, 14 }, { "House", 12.0, 8.0, 1, 0, 0 },
  { "Tree", 0.0, 0.0, 1, 0, 0 }, // by species
};

struct SpeciesDefaults
{
  const char* Name;
  double Height;
  double CrownToHeight;
  int NumberOfLeaves;
};

constexpr SpeciesDefaults AllSpecies[] = {
  { "Broadleaf", 12.0, 0.6, 5000 },
  { "Conifer", 12.0, 0.38, 5000 },
  { "Shrub", 1.5, 1.0, 1500 },
};

constexpr double MaximumNumberOfTriangles = 5e8;
constexpr double WoodTriangles = 2000;  // triangles of a tree, at most
constexpr double ReliefOfCanopy = 0.06; // relief relative to Size

/// The properties, with the kind's own values for 0.
struct Settings
{
  double Size;
  double Height;
  int Resolution;
  helios::TreeShape Tree;
  double NumberOfTriangles; // approximate, or a lower bound

  explicit Settings(vtkHeliosSyntheticScene* scene)
  {
    const auto pick = [](auto set, auto own) { return set > 0 ? set : own; };
    const KindDefaults& kind = Kinds[scene->GetKind()];
    const SpeciesDefaults& species = AllSpecies[scene->GetSpecies()];
    const bool isTree = scene->GetKind() == vtkHeliosSyntheticScene::TREE;
    const bool isCanopy = scene->GetKind() == vtkHeliosSyntheticScene::CANOPY;
    this->Size = pick(scene->GetSize(), kind.Size);
    this->Height = pick(scene->GetHeight(), isTree ? species.Height : kind.Height);
    this->Resolution = pick(scene->GetResolution(), kind.Resolution);

    this->Tree.Kind = static_cast<helios::Species>(isTree ? scene->GetSpecies() : 0);
    this->Tree.Height = this->Height;
    this->Tree.CrownDiameter = isTree ? pick(scene->GetSize(), species.CrownToHeight * this->Height)
                                      : AllSpecies[0].CrownToHeight * this->Height;
    this->Tree.NumberOfLeaves =
      pick(scene->GetNumberOfLeaves(), isTree ? species.NumberOfLeaves : kind.NumberOfLeaves);

    const double trees = isTree ? 1 : isCanopy ? scene->GetNumberOfTrees() : 0;
    this->NumberOfTriangles =
      static_cast<double>(kind.TrianglesPerSquare) * this->Resolution * this->Resolution +
      trees * (WoodTriangles + 2.0 * this->Tree.NumberOfLeaves);
  }
};

helios::Terrain MakeTerrain(vtkHeliosSyntheticScene* scene, const Settings& settings)
{
  const bool isCanopy = scene->GetKind() == vtkHeliosSyntheticScene::CANOPY;
  const double relief = isCanopy ? ReliefOfCanopy * settings.Size : settings.Height;
  return { settings.Size, relief, scene->GetSeed() };
}

void AddKind(helios::MeshBuilder& mesh, vtkHeliosSyntheticScene* scene, const Settings& s)
{
  switch (scene->GetKind())
  {
    case vtkHeliosSyntheticScene::PLANE:
      return helios::AddPlane(mesh, s.Size, s.Resolution);
    case vtkHeliosSyntheticScene::STEP:
      return helios::AddStep(mesh, s.Size, s.Height, s.Resolution);
    case vtkHeliosSyntheticScene::SPHERE:
      return helios::AddSphere(mesh, s.Size, s.Resolution);
    case vtkHeliosSyntheticScene::PYRAMID:
      return helios::AddPyramid(mesh, s.Size, s.Height, s.Resolution);
    case vtkHeliosSyntheticScene::TERRAIN:
      return helios::AddTerrain(mesh, MakeTerrain(scene, s), s.Size, s.Resolution);
    case vtkHeliosSyntheticScene::CANOPY:
      helios::AddTerrain(mesh, MakeTerrain(scene, s), s.Size, s.Resolution);
      return helios::AddForest(
        mesh, MakeTerrain(scene, s), s.Size, s.Tree, scene->GetNumberOfTrees(), scene->GetSeed());
    case vtkHeliosSyntheticScene::BLOCKS:
      return helios::AddBlocks(mesh, s.Size, s.Height, s.Resolution, scene->GetSeed());
    case vtkHeliosSyntheticScene::HOUSE:
      return helios::AddHouse(mesh, s.Size, s.Height);
    default:
      return helios::AddTree(mesh, s.Tree, scene->GetSeed(), 0);
  }
}

} // namespace

//------------------------------------------------------------------------------
vtkHeliosSyntheticScene::vtkHeliosSyntheticScene()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
const char* vtkHeliosSyntheticScene::GetKindAsString()
{
  return Kinds[this->Kind].Name;
}

//------------------------------------------------------------------------------
double vtkHeliosSyntheticScene::GetTerrainHeight(double x, double y)
{
  const double* o = this->Origin;
  return o[2] + MakeTerrain(this, Settings(this)).GetHeight(x - o[0], y - o[1]);
}

//------------------------------------------------------------------------------
int vtkHeliosSyntheticScene::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  for (const double value :
    { this->Size, this->Height, this->Origin[0], this->Origin[1], this->Origin[2] })
  {
    if (!std::isfinite(value))
    {
      vtkErrorMacro(<< "Size, Height or Origin is " << value << "; set finite numbers");
      return 0;
    }
  }
  const Settings settings(this);
  if (settings.NumberOfTriangles > MaximumNumberOfTriangles)
  {
    vtkErrorMacro(<< "Resolution " << settings.Resolution << ", NumberOfTrees "
                  << this->NumberOfTrees << " and NumberOfLeaves " << settings.Tree.NumberOfLeaves
                  << " make about " << settings.NumberOfTriangles << " triangles, more than "
                  << MaximumNumberOfTriangles << "; lower them");
    return 0;
  }
  helios::MeshBuilder mesh;
  const auto triangles = static_cast<vtkIdType>(settings.NumberOfTriangles);
  mesh.Reserve(triangles, triangles);
  AddKind(mesh, this, settings);
  mesh.Finish(vtkPolyData::GetData(outputVector), this->Origin);
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosSyntheticScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Kind: " << this->GetKindAsString() << "\n";
  os << indent << "Size: " << this->Size << "\n";
  os << indent << "Height: " << this->Height << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "Origin: " << this->Origin[0] << " " << this->Origin[1] << " " << this->Origin[2]
     << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "Species: " << AllSpecies[this->Species].Name << "\n";
  os << indent << "NumberOfTrees: " << this->NumberOfTrees << "\n";
  os << indent << "NumberOfLeaves: " << this->NumberOfLeaves << "\n";
}
