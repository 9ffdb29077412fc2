// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneSurfaces.h"

#include "heliosMaterialTable.h"
#include "heliosSceneCells.h"
#include "heliosSceneGeometry.h"
#include "heliosStatus.h"
#include "heliosWater.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScene.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

/// Returns a cell array converted to the requested type; null if missing.
template <typename ArrayT>
vtkSmartPointer<ArrayT> FindArray(
  vtkDataSet* data, const char* name, int components, const std::string& what, Status& status)
{
  vtkDataArray* given = data->GetCellData()->GetArray(name);
  const bool fits = given && given->GetNumberOfComponents() == components &&
    given->GetNumberOfTuples() == data->GetNumberOfCells();
  if (given && !fits)
  {
    status = Status::Error(std::string("cell array ") + name + " of " + what + " has " +
      std::to_string(given->GetNumberOfTuples()) + " tuples of " +
      std::to_string(given->GetNumberOfComponents()) + " for " +
      std::to_string(data->GetNumberOfCells()) + (what == "the scene" ? " triangles" : " cells") +
      "; expected one tuple of " + std::to_string(components) + " each");
  }
  vtkSmartPointer<ArrayT> array = ArrayT::FastDownCast(given);
  if (fits && !array)
  {
    array = vtkSmartPointer<ArrayT>::New();
    array->DeepCopy(given);
  }
  return array;
}

constexpr double MinimumScatteringAttenuation = 1e-3; // [1/m], so that columns end

/// Finds the fault of optics, and the cure; empty: none.
std::string FindFault(const MaterialOptics& optics)
{
  const auto is = [](double value, double minimum, double maximum)
  { return value >= minimum && value <= maximum; };
  const int kind = static_cast<int>(optics.Kind);
  if (kind < 0 || kind > static_cast<int>(OpticsKind::Retroreflector))
  {
    return "has optics " + std::to_string(kind) +
      "; give 0 opaque, 1 mirror, 2 pane, 3 volume, 4 water, 5 leaf or 6 retroreflector";
  }
  const int medium = static_cast<int>(optics.Dispersion);
  if (medium < 0 || medium > static_cast<int>(DispersionKind::Silica))
  {
    return "has dispersion " + std::to_string(medium) +
      "; give 0 none, 1 water, 2 soda-lime glass, 3 BK7 or 4 fused silica";
  }
  if (!is(optics.MirrorReflectance, 0.0, 1.0))
  {
    return "has mirror reflectance " + std::to_string(optics.MirrorReflectance) +
      "; give it within [0, 1]";
  }
  if (!is(optics.RefractiveIndex, 1.0, 4.0))
  {
    return "has refractive index " + std::to_string(optics.RefractiveIndex) +
      "; give it within [1, 4]";
  }
  if (!is(optics.Thickness, 0.0, 10.0) || !is(optics.Attenuation, 0.0, 1e6))
  {
    return "has thickness " + std::to_string(optics.Thickness) + " m and attenuation " +
      std::to_string(optics.Attenuation) +
      " 1/m; give the first within [0, 10] and the second within [0, 1e6]";
  }
  if (!is(optics.Backscatter, 0.0, 1e6) ||
    (optics.Backscatter > 0.0 && !(optics.Attenuation >= MinimumScatteringAttenuation)))
  {
    return "has backscatter " + std::to_string(optics.Backscatter) + " 1/(m sr) and attenuation " +
      std::to_string(optics.Attenuation) +
      " 1/m; what scatters attenuates: give the first within [0, 1e6], and then the second within "
      "[0.001, 1e6]";
  }
  if (!is(optics.Transmittance, 0.0, 1.0) || !is(optics.Retroreflection, 0.0, 1e9))
  {
    return "has transmittance " + std::to_string(optics.Transmittance) + " and retroreflection " +
      std::to_string(optics.Retroreflection) +
      " 1/sr; give the first within [0, 1] and the second within [0, 1e9]";
  }
  if (!is(optics.MeanSquareSlope, 0.0, 1.0))
  {
    return "has mean square slope " + std::to_string(optics.MeanSquareSlope) +
      "; give it within [0, 1]";
  }
  return "";
}

template <typename ArrayT>
auto* GetValues(const vtkSmartPointer<ArrayT>& array)
{
  return array ? array->GetPointer(0) : nullptr;
}

} // namespace

//------------------------------------------------------------------------------
Status SceneSurfaces::CellArrays::Set(vtkPolyData* mesh, const std::string& what)
{
  Status status;
  this->MaterialArray = FindArray<vtkIntArray>(mesh, names::MaterialIds, 1, what, status);
  this->PartArray = FindArray<vtkIntArray>(mesh, names::PartIds, 1, what, status);
  this->NormalArray = FindArray<vtkFloatArray>(mesh, names::Normals, 3, what, status);
  this->Materials = GetValues(this->MaterialArray);
  this->Parts = GetValues(this->PartArray);
  this->Normals = GetValues(this->NormalArray);
  return status;
}

//------------------------------------------------------------------------------
Status SceneSurfaces::Set(vtkPolyData* scene, const SceneGeometry* geometry)
{
  const std::string what = "the scene";
  Status status = this->Mesh.Set(scene, what);
  this->HasNormals = this->Mesh.Normals;
  this->Prototypes.clear();
  this->Geometry = geometry && !geometry->GetInstances().empty() ? geometry : nullptr;
  this->PartNames =
    vtkStringArray::SafeDownCast(scene->GetFieldData()->GetAbstractArray(names::PartName));
  this->NumberOfTriangles = this->NumberOfCells =
    this->Geometry ? this->Geometry->GetNumberOfTriangles() : scene->GetNumberOfCells();
  this->Grids.clear();
  this->GridMaterials.clear();
  this->Reflections.clear();
  this->Classifications.clear();
  this->Optics.clear();
  const Status material = this->AddMaterials(scene, what);
  status = status.IsOk() ? material : status;
  const int count = static_cast<int>(this->Reflections.size());
  status = status.IsOk() ? this->CheckMaterialIds(this->Mesh.MaterialArray, count, what) : status;
  return status.IsOk() && this->Geometry ? this->AddInstances(scene) : status;
}

//------------------------------------------------------------------------------
/// Reads the arrays of the prototypes, and checks the materials of the instances.
Status SceneSurfaces::AddInstances(vtkPolyData* scene)
{
  auto* whole = vtkHeliosScene::SafeDownCast(scene);
  const int count = static_cast<int>(this->Reflections.size());
  for (int i = 0; i < whole->GetNumberOfPrototypes(); ++i)
  {
    const std::string what = "prototype " + std::to_string(i);
    this->Prototypes.emplace_back();
    CellArrays& arrays = this->Prototypes.back();
    auto* mesh = vtkPolyData::SafeDownCast(whole->GetPrototype(i));
    Status status = mesh ? arrays.Set(mesh, what) : Status(); // a raster has no cell arrays
    status = status.IsOk() ? this->CheckMaterialIds(arrays.MaterialArray, count, what) : status;
    if (!status.IsOk())
    {
      return status;
    }
    this->HasNormals = this->HasNormals || arrays.Normals;
  }
  for (const SceneInstance& instance : this->Geometry->GetInstances())
  {
    if (instance.Material >= count)
    {
      return Status::Error(std::string("point array ") + names::MaterialIds +
        " of the instances has " + std::to_string(instance.Material) + ", but the field data of " +
        "the scene has " + std::to_string(count) + " materials");
    }
  }
  return {};
}

//------------------------------------------------------------------------------
bool SceneSurfaces::AreAlikeInInstances(vtkIdType a, vtkIdType b) const
{
  const SceneGeometry::Cell first = this->Geometry->Find(a);
  const vtkIdType triangle = first.Triangle + b - a;
  const bool isInSame = first.Instance && triangle >= 0 &&
    triangle < this->Geometry->GetPrototype(*first.Instance).GetNumberOfTriangles();
  const SceneGeometry::Cell second =
    isInSame ? SceneGeometry::Cell{ first.Instance, triangle } : this->Geometry->Find(b);
  const auto getPart = [this](const SceneGeometry::Cell& at)
  { return at.Instance ? at.Instance->Part : this->Mesh.GetPartId(at.Triangle); };
  return this->GetMaterialIdAt(first) == this->GetMaterialIdAt(second) &&
    getPart(first) == getPart(second);
}

//------------------------------------------------------------------------------
int SceneSurfaces::FindMaterialId(vtkIdType cell) const
{
  return this->GetMaterialIdAt(this->Geometry->Find(cell));
}

//------------------------------------------------------------------------------
int SceneSurfaces::GetMaterialIdAt(const SceneGeometry::Cell& at) const
{
  if (!at.Instance)
  {
    return this->Mesh.GetMaterialId(at.Triangle);
  }
  return at.Instance->Material >= 0
    ? at.Instance->Material
    : this->Prototypes[static_cast<std::size_t>(at.Instance->PrototypeId)].GetMaterialId(
        at.Triangle);
}

//------------------------------------------------------------------------------
int SceneSurfaces::FindPartId(vtkIdType cell) const
{
  const SceneGeometry::Cell at = this->Geometry->Find(cell);
  return at.Instance ? at.Instance->Part : this->Mesh.GetPartId(at.Triangle);
}

//------------------------------------------------------------------------------
Vec3 SceneSurfaces::FindNormal(vtkIdType cell) const
{
  const SceneGeometry::Cell at = this->Geometry->Find(cell);
  if (!at.Instance)
  {
    return this->Mesh.GetNormal(at.Triangle);
  }
  const auto prototype = static_cast<std::size_t>(at.Instance->PrototypeId);
  const Vec3 turned = at.Instance->Place.Rotate(this->Prototypes[prototype].GetNormal(at.Triangle));
  // Rounds like a copy of the prototype.
  return { RoundToFloat(turned[0]), RoundToFloat(turned[1]), RoundToFloat(turned[2]) };
}

//------------------------------------------------------------------------------
Status SceneSurfaces::AddGrid(vtkImageData* grid, vtkIdType& firstCell)
{
  const std::string what = "voxel grid " + std::to_string(this->Grids.size());
  Status status;
  Grid added;
  added.FirstCell = firstCell = this->NumberOfCells;
  added.FirstMaterial = static_cast<int>(this->Reflections.size());
  added.Part = this->CountParts() + static_cast<int>(this->Grids.size());
  added.Materials = FindArray<vtkIntArray>(grid, names::MaterialIds, 1, what, status);
  auto* name =
    vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray(names::PartName));
  added.Name = name && name->GetNumberOfValues() > 0 ? std::string(name->GetValue(0)) : "";
  this->NumberOfCells += grid->GetNumberOfCells();
  const MaterialTable own = GetMaterials(grid);
  this->GridMaterials.insert(this->GridMaterials.end(), own.begin(), own.end());
  this->Grids.push_back(added);
  const Status material = this->AddMaterials(grid, what);
  status = status.IsOk() ? material : status;
  const int count = static_cast<int>(this->Reflections.size()) - added.FirstMaterial;
  return status.IsOk() ? this->CheckMaterialIds(added.Materials, count, what) : status;
}

//------------------------------------------------------------------------------
const SceneSurfaces::Grid& SceneSurfaces::FindGrid(vtkIdType cell) const
{
  std::size_t i = this->Grids.size() - 1;
  while (this->Grids[i].FirstCell > cell)
  {
    --i;
  }
  return this->Grids[i];
}

//------------------------------------------------------------------------------
/// Counts the parts of the scene, without grids.
int SceneSurfaces::CountParts() const
{
  if (this->PartNames)
  {
    return static_cast<int>(this->PartNames->GetNumberOfValues());
  }
  int range[2] = { 0, 0 };
  if (this->Mesh.PartArray && this->Mesh.PartArray->GetNumberOfValues() > 0)
  {
    this->Mesh.PartArray->GetValueRange(range);
  }
  int last = range[1];
  for (std::size_t i = 0; this->Geometry && i < this->Geometry->GetInstances().size(); ++i)
  {
    last = std::max(last, this->Geometry->GetInstances()[i].Part);
  }
  return this->NumberOfTriangles > 0 ? last + 1 : 0;
}

//------------------------------------------------------------------------------
void SceneSurfaces::PassFields(vtkPolyData* scene, vtkPolyData* echoes) const
{
  const vtkSmartPointer<vtkStringArray> parts = this->MakePartNames();
  vtkAbstractArray* crs = scene->GetFieldData()->GetAbstractArray(names::CRS);
  for (vtkAbstractArray* array : { static_cast<vtkAbstractArray*>(parts), crs })
  {
    if (array)
    {
      echoes->GetFieldData()->AddArray(array);
    }
  }
  if (!this->GridMaterials.empty())
  {
    MaterialTable all = GetMaterials(scene);
    all.insert(all.end(), this->GridMaterials.begin(), this->GridMaterials.end());
    SetMaterials(echoes, all);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkStringArray> SceneSurfaces::MakePartNames() const
{
  const bool hasNames = std::any_of(
    this->Grids.begin(), this->Grids.end(), [](const Grid& grid) { return !grid.Name.empty(); });
  if (this->Grids.empty() || !(this->PartNames || hasNames))
  {
    return this->PartNames;
  }
  auto all = vtkSmartPointer<vtkStringArray>::New();
  all->SetName(names::PartName);
  for (int i = 0; i < this->CountParts(); ++i)
  {
    all->InsertNextValue(this->PartNames ? this->PartNames->GetValue(i) : std::to_string(i));
  }
  for (const Grid& grid : this->Grids)
  {
    all->InsertNextValue(grid.Name.empty() ? std::to_string(grid.Part) : grid.Name);
  }
  return all;
}

//------------------------------------------------------------------------------
Status SceneSurfaces::AddMaterials(vtkDataObject* data, const std::string& what)
{
  const std::size_t first = this->Reflections.size();
  const auto isShare = [](double x) { return x >= 0.0 && x <= 1.0; };
  const MaterialTable materials = GetMaterials(data);
  for (const Material& m : materials)
  {
    const bool scatters = m.Optics.Kind == OpticsKind::Opaque || m.Optics.Kind == OpticsKind::Leaf;
    const double unset = scatters ? DefaultReflectance : 0.0; // mirrors and glass are clean
    const double rho = std::isnan(m.Reflectance) ? unset : m.Reflectance;
    const double exponent = m.SpecularExponent;
    if (!isShare(rho) || !isShare(m.Specularity) || !(exponent >= 0.0 && exponent <= 1e6))
    {
      return Status::Error("material " + std::to_string(this->Reflections.size() - first) + " of " +
        what + ", " + m.Name + ", has reflectance " + std::to_string(rho) + ", specularity " +
        std::to_string(m.Specularity) + " and specular exponent " + std::to_string(exponent) +
        "; give the first two within [0, 1] and the last within [0, 1e6]");
    }
    const std::string fault = FindFault(m.Optics);
    if (!fault.empty())
    {
      return Status::Error("material " + std::to_string(this->Reflections.size() - first) + " of " +
        what + ", " + m.Name + ", " + fault);
    }
    if (m.Optics.Kind == OpticsKind::Leaf && rho + m.Optics.Transmittance > 1.0)
    {
      return Status::Error("material " + std::to_string(this->Reflections.size() - first) + " of " +
        what + ", " + m.Name + ", is a leaf with reflectance " + std::to_string(rho) +
        " and transmittance " + std::to_string(m.Optics.Transmittance) +
        "; together they are at most 1");
    }
    this->Reflections.push_back({ rho, m.Specularity, exponent });
    this->Classifications.push_back(m.Classification);
  }
  this->AddOptics(materials);
  return {};
}

//------------------------------------------------------------------------------
/// Adds the optics of the materials added last; a row for every material once one of them has
/// optics.
void SceneSurfaces::AddOptics(const MaterialTable& materials)
{
  const bool hasOptics = std::any_of(materials.begin(), materials.end(),
    [](const Material& m) { return m.Optics.Kind != OpticsKind::Opaque; });
  if (this->HasOptics() || hasOptics)
  {
    this->Optics.resize(this->Reflections.size() - materials.size());
    for (const Material& m : materials)
    {
      this->Optics.push_back(m.Optics);
    }
  }
}

//------------------------------------------------------------------------------
void SceneSurfaces::SetWavelength(double wavelength)
{
  std::transform(this->Optics.begin(), this->Optics.end(), this->Optics.begin(),
    [wavelength](const MaterialOptics& optics) { return GetOpticsAt(optics, wavelength); });
}

//------------------------------------------------------------------------------
Status SceneSurfaces::CheckMaterialIds(vtkIntArray* ids, int count, const std::string& what) const
{
  int range[2] = { 0, 0 };
  if (ids && ids->GetNumberOfValues() > 0)
  {
    ids->GetValueRange(range);
  }
  if (range[0] >= 0 && range[1] < count)
  {
    return {};
  }
  return Status::Error(std::string("cell array ") + names::MaterialIds + " of " + what +
    " ranges from " + std::to_string(range[0]) + " to " + std::to_string(range[1]) +
    ", but its field data has " + std::to_string(count) + " materials");
}

} // namespace helios
