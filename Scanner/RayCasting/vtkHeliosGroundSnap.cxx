// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosGroundSnap.h"

#include "heliosMaterialTable.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosBvhRayCaster.h"

#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <vector>

namespace names = vtkHeliosArrayNames;

namespace
{

/// Places on the ground, asked whether any lies within the outline of a cell.
class Places
{
public:
  explicit Places(vtkPolyData* points)
  {
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      double p[3];
      points->GetPoint(i, p);
      this->Sorted.push_back({ p[0], p[1] });
    }
    std::sort(this->Sorted.begin(), this->Sorted.end());
  }

  bool AreIn(vtkPoints* points, vtkIdType size, const vtkIdType* corners) const
  {
    vtkBoundingBox box;
    for (vtkIdType i = 0; i < size; ++i)
    {
      double p[3];
      points->GetPoint(corners[i], p);
      box.AddPoint(p);
    }
    const std::array<double, 2> least = { box.GetMinPoint()[0], box.GetMinPoint()[1] };
    const std::array<double, 2> most = { box.GetMaxPoint()[0], box.GetMaxPoint()[1] };
    auto place = std::lower_bound(this->Sorted.begin(), this->Sorted.end(), least);
    while (place != this->Sorted.end() && !((*place)[1] >= least[1] && (*place)[1] <= most[1]) &&
      (*place)[0] <= most[0])
    {
      ++place;
    }
    return place != this->Sorted.end() && (*place)[0] <= most[0];
  }

private:
  std::vector<std::array<double, 2>> Sorted;
};

/// The scene's cells at some places that have a ground material; all where none has.
vtkSmartPointer<vtkPolyData> ExtractGround(vtkPolyData* scene, const Places& places)
{
  const helios::MaterialTable materials = helios::GetMaterials(scene);
  vtkDataArray* ids = scene->GetCellData()->GetArray(names::MaterialIds);
  const auto isGround = [&materials, ids](vtkIdType cell)
  {
    const double id = ids ? ids->GetComponent(cell, 0) : 0.0;
    return id >= 0.0 && id < static_cast<double>(materials.size()) &&
      materials[static_cast<std::size_t>(id)].IsGround;
  };
  vtkCellArray* cells = scene->GetPolys();
  const vtkIdType count = cells->GetNumberOfCells();
  bool hasGround = false;
  for (vtkIdType cell = 0; cell < count && !hasGround; ++cell)
  {
    hasGround = isGround(cell);
  }
  vtkNew<vtkCellArray> polys;
  polys->Use32BitStorage();
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    vtkIdType size;
    const vtkIdType* corners;
    cells->GetCellAtId(cell, size, corners);
    if ((!hasGround || isGround(cell)) && places.AreIn(scene->GetPoints(), size, corners))
    {
      polys->InsertNextCell(size, corners);
    }
  }
  auto ground = vtkSmartPointer<vtkPolyData>::New();
  ground->SetPoints(scene->GetPoints());
  ground->SetPolys(polys);
  return ground;
}

/// The height of the highest surface at each point; NaN where there is none.
std::vector<double> GetHeights(vtkPolyData* points, const vtkHeliosRayCaster* caster)
{
  double bounds[6] = {};
  if (caster->GetMesh().GetNumberOfTriangles() > 0)
  {
    caster->GetMesh().GetBounds(bounds);
  }
  const double top = bounds[5] + std::max(1.0, bounds[5] - bounds[4]);
  std::vector<double> heights;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    const vtkHeliosRay ray{ { p[0], p[1], top }, { 0.0, 0.0, -1.0 } };
    vtkHeliosHit hit;
    caster->Intersect(&ray, &hit, 1);
    heights.push_back(hit.CellId < 0 ? std::nan("") : top - hit.Range);
  }
  return heights;
}

/// "point 3 at x 1, y 2"
std::string Describe(vtkPolyData* points, vtkIdType index)
{
  double p[3];
  points->GetPoint(index, p);
  std::ostringstream text;
  text << std::setprecision(15) << "point " << index << " at x " << p[0] << ", y " << p[1];
  return text.str();
}

/// The first point whose x or y is not a number, or -1.
vtkIdType FindNotFinite(vtkPolyData* points)
{
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]))
    {
      return i;
    }
  }
  return -1;
}

} // namespace

vtkStandardNewMacro(vtkHeliosGroundSnap);

vtkHeliosGroundSnap::vtkHeliosGroundSnap()
{
  this->SetNumberOfInputPorts(2);
}

void vtkHeliosGroundSnap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "HeightAboveGround: " << this->HeightAboveGround << "\n";
}

int vtkHeliosGroundSnap::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkHeliosGroundSnap::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* scene = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(input);
  const vtkIdType count = input->GetNumberOfPoints();
  if (count == 0)
  {
    return 1;
  }
  if (scene->GetNumberOfCells() == 0)
  {
    vtkErrorMacro(<< "The scene on port 1 is empty: it has no ground to put points onto.");
    return 0;
  }
  const vtkIdType notFinite = FindNotFinite(input);
  if (notFinite >= 0)
  {
    vtkErrorMacro(<< "No ground for " << Describe(input, notFinite) << "; it must be finite.");
    return 0;
  }
  vtkNew<vtkHeliosBvhRayCaster> caster;
  const vtkSmartPointer<vtkPolyData> ground = ExtractGround(scene, Places(input));
  if (ground->GetNumberOfCells() > 0 && !caster->Build(ground))
  {
    vtkErrorMacro(<< "No rays can be cast onto the scene on port 1.");
    return 0;
  }

  const std::vector<double> heights = GetHeights(input, caster);
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  points->SetNumberOfPoints(count);
  vtkDataArray* onGround = input->GetPointData()->GetArray(names::OnGround);
  for (vtkIdType i = 0; i < count; ++i)
  {
    double p[3];
    input->GetPoint(i, p);
    const bool isSnapped = !onGround || onGround->GetComponent(i, 0) != 0.0;
    if (isSnapped && std::isnan(heights[i]))
    {
      vtkErrorMacro(<< "The scene has no ground above or below " << Describe(input, i)
                    << "; move the point into the scene or clear its " << names::OnGround << ".");
      return 0;
    }
    p[2] = isSnapped ? heights[i] + this->HeightAboveGround : p[2];
    points->SetPoint(i, p);
  }
  output->SetPoints(points);
  return 1;
}
