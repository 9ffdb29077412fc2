// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoordinateTransform.h"

#include "heliosCoordinateSystemData.h"
#include "heliosProj.h"
#include "heliosStatus.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

namespace helios
{

namespace
{

/// System passed to PROJ for a local system; GeographicLib does the rest.
const char* const Geographic3D = "EPSG:4979";

bool IsFinite(const double p[3])
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

void FromProj(const AxisOrder& axes, const PJ_COORD& in, double out[3])
{
  for (int k = 0; k < 3; ++k)
  {
    out[k] = in.v[axes.From[k]] * axes.Factor[k];
  }
}

PJ_COORD ToProj(const AxisOrder& axes, const double in[3])
{
  PJ_COORD out = proj_coord(0.0, 0.0, 0.0, HUGE_VAL);
  for (int k = 0; k < 3; ++k)
  {
    out.v[axes.From[k]] = in[k] / axes.Factor[k];
  }
  return out;
}

/// Creates the PROJ object of a system: the horizontal part if the target has no vertical part.
ProjObject MakeEnd(
  const ProjContext& context, const CoordinateSystemData& system, const CoordinateSystemData& other)
{
  ProjObject crs = MakeProjCRS(context, system.IsLocal ? Geographic3D : system.Text);
  const bool isCut = system.IsCompound && other.IsPlane;
  return crs && isCut ? GetHorizontalPart(context, crs.get()) : std::move(crs);
}

struct Grids
{
  std::string Missing; // names, separated by commas
  double Accuracy = -1.0;
};

Grids GetGrids(const ProjContext& context, const PJ* operation)
{
  std::set<std::string> missing;
  const int count = proj_coordoperation_get_grid_used_count(context.Get(), operation);
  for (int i = 0; i < count; ++i)
  {
    const char* name = nullptr;
    int isAvailable = 0;
    proj_coordoperation_get_grid_used(context.Get(), operation, i, &name, nullptr, nullptr, nullptr,
      nullptr, nullptr, &isAvailable);
    if (!isAvailable && name)
    {
      missing.insert(name);
    }
  }
  Grids grids;
  for (const std::string& name : missing)
  {
    grids.Missing += (grids.Missing.empty() ? "" : ", ") + name;
  }
  grids.Accuracy = proj_coordoperation_get_accuracy(context.Get(), operation);
  return grids;
}

bool IsInArea(const ProjContext& context, const PJ* operation, const double place[2])
{
  double west = 0.0;
  double south = 0.0;
  double east = 0.0;
  double north = 0.0;
  if (!proj_get_area_of_use(context.Get(), operation, &west, &south, &east, &north, nullptr) ||
    west < -180.0)
  {
    return true; // not stated
  }
  const double longitude = std::remainder(place[0], 360.0);
  const bool isBetween =
    west <= east ? west <= longitude && longitude <= east : west <= longitude || longitude <= east;
  return isBetween && south <= place[1] && place[1] <= north;
}

/// Finds the most accurate operation with grids that are not installed, at a point if given.
Grids FindMissingGrids(
  const ProjContext& context, const PJ* source, const PJ* target, const double* place)
{
  const ProjFactory factory(proj_create_operation_factory_context(context.Get(), nullptr));
  proj_operation_factory_context_set_allow_ballpark_transformations(
    context.Get(), factory.get(), false);
  proj_operation_factory_context_set_spatial_criterion(
    context.Get(), factory.get(), PROJ_SPATIAL_CRITERION_PARTIAL_INTERSECTION);
  proj_operation_factory_context_set_grid_availability_use(
    context.Get(), factory.get(), PROJ_GRID_AVAILABILITY_IGNORED);
  const ProjList list(proj_create_operations(context.Get(), source, target, factory.get()));
  Grids best;
  for (int i = 0; list && i < proj_list_get_count(list.get()); ++i)
  {
    const ProjObject operation(proj_list_get(context.Get(), list.get(), i));
    const Grids grids = GetGrids(context, operation.get());
    const bool isBetter = best.Missing.empty() ||
      (grids.Accuracy >= 0.0 && (grids.Accuracy < best.Accuracy || best.Accuracy < 0.0));
    if (!grids.Missing.empty() && isBetter && (!place || IsInArea(context, operation.get(), place)))
    {
      best = grids;
    }
  }
  return best;
}

const char* const InstallGrids =
  "install it (Debian: proj-data; others: projsync, cdn.proj.org) in a folder of PROJ_DATA";

} // namespace

//------------------------------------------------------------------------------
struct CoordinateTransform::Internals
{
  CoordinateSystem Source;
  CoordinateSystem Target;
  std::shared_ptr<const CoordinateSystemData> From;
  std::shared_ptr<const CoordinateSystemData> To;
  bool IsIdentity = false;
  double HeightFactor = 1.0; // if PROJ does not transform heights

  std::unique_ptr<ProjContext> Context; // null: without PROJ
  ProjObject Operation;

  Status MakeOperation();
  std::string DescribeNoOperation(const PJ* source, const PJ* target) const;
  void Apply(const double from[3], double to[3]);
};

//------------------------------------------------------------------------------
Status CoordinateTransform::Internals::MakeOperation()
{
  this->Context = std::make_unique<ProjContext>();
  const ProjContext& context = *this->Context;
  const ProjObject source = MakeEnd(context, *this->From, *this->To);
  const ProjObject target = MakeEnd(context, *this->To, *this->From);
  if (!source || !target)
  {
    return Status::Error(
      "PROJ's database was not found (" + this->Context->ReleaseMessage() + "); set PROJ_DATA");
  }
  const char* const options[] = { "ALLOW_BALLPARK=NO", nullptr };
  const ProjObject plain(
    proj_create_crs_to_crs_from_pj(context.Get(), source.get(), target.get(), nullptr, options));
  this->Operation.reset(
    plain ? proj_normalize_for_visualization(context.Get(), plain.get()) : nullptr);
  return this->Operation ? Status()
                         : Status::Error(this->DescribeNoOperation(source.get(), target.get()));
}

//------------------------------------------------------------------------------
std::string CoordinateTransform::Internals::DescribeNoOperation(
  const PJ* source, const PJ* target) const
{
  const std::string reason = this->Context->ReleaseMessage();
  const Grids grids = FindMissingGrids(*this->Context, source, target, nullptr);
  const std::string start =
    "There is no transformation from " + this->Source.GetName() + " to " + this->Target.GetName();
  return grids.Missing.empty()
    ? start + (reason.empty() ? "" : " (" + reason + ")") +
      "; use systems whose datums PROJ can relate (in a PROJ string: add +datum or +towgs84)"
    : start + " without the grid " + grids.Missing + ", which PROJ does not find; " + InstallGrids;
}

//------------------------------------------------------------------------------
void CoordinateTransform::Internals::Apply(const double from[3], double to[3])
{
  if (this->Context && !this->Operation)
  {
    std::fill_n(to, 3, std::numeric_limits<double>::quiet_NaN());
    return;
  }
  double p[3] = { from[0], from[1], from[2] };
  if (!this->Operation)
  {
    double place[3];
    this->From->Projection->ToGeographic(p, place);
    this->To->Projection->FromGeographic(place, to);
    return;
  }
  if (this->From->IsLocal)
  {
    this->From->Projection->ToGeographic(from, p);
  }
  const PJ_COORD image = proj_trans(this->Operation.get(), PJ_FWD, ToProj(this->From->Axes, p));
  FromProj(this->To->Axes, image, to);
  to[2] *= this->HeightFactor;
  if (this->To->IsLocal)
  {
    std::copy_n(to, 3, p);
    this->To->Projection->FromGeographic(p, to);
  }
}

//------------------------------------------------------------------------------
CoordinateTransform::CoordinateTransform()
  : State(std::make_unique<Internals>())
{
}
CoordinateTransform::~CoordinateTransform() = default;
CoordinateTransform::CoordinateTransform(CoordinateTransform&& other) noexcept = default;

//------------------------------------------------------------------------------
CoordinateTransform::CoordinateTransform(const CoordinateTransform& other)
  : State(std::make_unique<Internals>())
{
  const Internals& from = *other.State;
  this->State->Source = from.Source;
  this->State->Target = from.Target;
  this->State->From = from.From;
  this->State->To = from.To;
  this->State->IsIdentity = from.IsIdentity;
  this->State->HeightFactor = from.HeightFactor;
  if (from.Context)
  {
    // Without an operation, Forward() fails for every point.
    static_cast<void>(this->State->MakeOperation());
  }
}

//------------------------------------------------------------------------------
CoordinateTransform& CoordinateTransform::operator=(CoordinateTransform other) noexcept
{
  std::swap(this->State, other.State);
  return *this;
}

//------------------------------------------------------------------------------
Status CoordinateTransform::Set(const CoordinateSystem& source, const CoordinateSystem& target)
{
  auto state = std::make_unique<Internals>();
  state->Source = source;
  state->Target = target;
  state->From = source.Data;
  state->To = target.Data;
  state->IsIdentity = source == target;
  const CoordinateSystemData& from = *state->From;
  const CoordinateSystemData& to = *state->To;
  Status status;
  if (!state->IsIdentity && (!from.Projection || !to.Projection))
  {
    const bool isCut = (from.IsCompound && to.IsPlane) || (from.IsPlane && to.IsCompound);
    state->HeightFactor = isCut ? from.HeightUnit / to.HeightUnit : 1.0;
    status = state->MakeOperation();
  }
  if (status.IsOk())
  {
    this->State = std::move(state);
  }
  return status;
}

//------------------------------------------------------------------------------
bool CoordinateTransform::IsIdentity() const
{
  return this->State->IsIdentity;
}

//------------------------------------------------------------------------------
vtkIdType CoordinateTransform::Forward(const double* from, double* to, vtkIdType count)
{
  vtkIdType failed = -1;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double* in = from + 3 * i;
    double* out = to + 3 * i;
    if (this->State->IsIdentity)
    {
      std::copy_n(in, 3, out);
    }
    else
    {
      this->State->Apply(in, out);
    }
    if (!IsFinite(out))
    {
      failed = failed < 0 ? i : failed;
      std::fill_n(out, 3, std::numeric_limits<double>::quiet_NaN());
    }
  }
  return failed;
}

//------------------------------------------------------------------------------
bool CoordinateTransform::GetJacobian(const double point[3], double jacobian[3][3])
{
  const double height = 10.0;
  const double plane = this->State->Source.IsGeographic() ? 1e-4 : height;
  for (int k = 0; k < 3; ++k)
  {
    double ends[6] = { point[0], point[1], point[2], point[0], point[1], point[2] };
    const double step = k == 2 ? height : plane;
    ends[k] -= step;
    ends[3 + k] += step;
    const double width = ends[3 + k] - ends[k];
    if (this->Forward(ends, ends, 2) >= 0)
    {
      return false;
    }
    for (int i = 0; i < 3; ++i)
    {
      jacobian[i][k] = (ends[3 + i] - ends[i]) / width;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool CoordinateTransform::GetRotation(const double point[3], double rotation[3][3])
{
  double jacobian[3][3];
  if (!this->GetJacobian(point, jacobian))
  {
    return false;
  }
  // Degrees of longitude and latitude differ in length: only the direction of each axis is used.
  const bool isFromAngles = this->State->Source.IsGeographic();
  double axes[3][3];
  for (int k = 0; k < 3; ++k)
  {
    for (int i = 0; i < 3; ++i)
    {
      axes[k][i] = isFromAngles ? jacobian[i][k] : jacobian[k][i];
    }
    if (!(vtkMath::Normalize(axes[k]) > 0.0))
    {
      return false;
    }
  }
  if (isFromAngles)
  {
    vtkMath::Transpose3x3(axes, axes);
  }
  vtkMath::Orthogonalize3x3(axes, rotation);
  return true;
}

//------------------------------------------------------------------------------
double CoordinateTransform::GetAccuracy() const
{
  const Internals& state = *this->State;
  if (!state.Operation)
  {
    return 0.0;
  }
  const ProjObject used(proj_trans_get_last_used_operation(state.Operation.get()));
  return used ? proj_coordoperation_get_accuracy(state.Context->Get(), used.get()) : -1.0;
}

//------------------------------------------------------------------------------
std::string CoordinateTransform::GetWarning(const double* points, vtkIdType count)
{
  if (!this->State->Operation || count == 0)
  {
    return {};
  }
  const std::string seam = this->DescribeSeam(points, count);
  const std::string grids = this->DescribeMissingGrids(points);
  return seam + (seam.empty() || grids.empty() ? "" : ". ") + grids;
}

//------------------------------------------------------------------------------
std::string CoordinateTransform::DescribeSeam(const double* points, vtkIdType count)
{
  std::set<std::string> operations;
  for (vtkIdType i = 0; i < count; ++i)
  {
    double ignored[3];
    const bool isMoved = this->Forward(points + 3 * i, ignored, 1) < 0;
    const ProjObject used(proj_trans_get_last_used_operation(this->State->Operation.get()));
    if (isMoved && used)
    {
      operations.insert(proj_pj_info(used.get()).description);
    }
  }
  return operations.size() < 2 ? std::string()
                               : "From " + this->State->Source.GetName() + " to " +
      this->State->Target.GetName() + " PROJ uses " + std::to_string(operations.size()) +
      " operations for different parts of the data (" + *operations.begin() + "; " +
      *operations.rbegin() + "): surfaces tear where these meet; split the data there";
}

//------------------------------------------------------------------------------
std::string CoordinateTransform::DescribeMissingGrids(const double point[3])
{
  const Internals& state = *this->State;
  double ignored[3];
  double place[3];
  CoordinateSystem geographic;
  CoordinateTransform toPlace;
  if (this->Forward(point, ignored, 1) == 0 ||
    !geographic.Set(state.From->IsLocal ? Geographic3D : "EPSG:4326").IsOk() ||
    !toPlace.Set(state.Source, geographic).IsOk() || toPlace.Forward(point, place, 1) == 0)
  {
    return {};
  }
  const double accuracy = this->GetAccuracy();
  const ProjObject source = MakeEnd(*state.Context, *state.From, *state.To);
  const ProjObject target = MakeEnd(*state.Context, *state.To, *state.From);
  const Grids grids = FindMissingGrids(*state.Context, source.get(), target.get(), place);
  const bool isAsGood = accuracy >= 0.0 && accuracy <= grids.Accuracy;
  if (grids.Missing.empty() || grids.Accuracy < 0.0 || isAsGood)
  {
    return {};
  }
  std::ostringstream text;
  text << "From " << state.Source.GetName() << " to " << state.Target.GetName()
       << " is accurate to ";
  accuracy >= 0.0 ? text << accuracy << " m" : text << "an unknown degree";
  text << " only; for " << grids.Accuracy << " m it needs the grid " << grids.Missing
       << ", which PROJ does not find; " << InstallGrids;
  return text.str();
}

//------------------------------------------------------------------------------
std::string CoordinateTransform::DescribeFailure(vtkIdType index, const double point[3]) const
{
  std::ostringstream text;
  text.precision(15);
  text << "Point " << index << " (" << point[0] << ", " << point[1] << ", " << point[2]
       << ") cannot be transformed from " << this->State->Source.GetName() << " to "
       << this->State->Target.GetName();
  const std::string reason =
    this->State->Context ? this->State->Context->ReleaseMessage() : std::string();
  text << (reason.empty() ? "" : " (" + reason + ")")
       << "; it must lie in the area of use of both, in the order "
       << (this->State->Source.IsGeographic() ? "longitude, latitude [degrees]" : "east, north")
       << ", height";
  return text.str();
}

//------------------------------------------------------------------------------
Status CheckMetric(const CoordinateSystem& system, const double point[3])
{
  if (system.IsMetric())
  {
    return {};
  }
  CoordinateSystem geographic;
  CoordinateTransform toPlace;
  double place[3];
  const bool isPlaced = geographic.Set("EPSG:4326").IsOk() &&
    toPlace.Set(system, geographic).IsOk() && toPlace.Forward(point, place, 1) < 0 &&
    std::abs(place[1]) <= 90.0;
  const std::string target =
    isPlaced ? "EPSG:" + std::to_string(GetUTMCode(place[1], place[0])) : "a UTM zone";
  return Status::Error(system.GetName() + " is in " + system.GetUnitName() +
    "; reproject it to a metric system, e.g. <filter type=\"crs\"> with target " + target);
}

} // namespace helios
