// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoordinateTransform.h"

#include "heliosCoordinateSystemData.h"
#include "heliosProj.h"
#include "heliosProjGrids.h"
#include "heliosStatus.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
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

PJ_COORD ToProj(const AxisOrder& axes, const double in[3], double epoch)
{
  PJ_COORD out = proj_coord(0.0, 0.0, 0.0, epoch > 0.0 ? epoch : HUGE_VAL);
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
  const bool isCut = system.IsCut || (system.IsCompound && other.IsPlane);
  return crs && isCut ? GetHorizontalPart(context, crs.get()) : std::move(crs);
}

///@{
/// Epochs at which the motion of the Earth's plates is measured [years].
constexpr double SomeYear = 2020.0;
constexpr double YearsApart = 10.0;
///@}

/// Returns the distance of two near points of a system [m].
double GetLength(const CoordinateSystem& system, const double a[3], const double b[3])
{
  constexpr double metresPerDegree = 111195.0; // a sphere as large as the Earth
  const double unit = system.IsGeographic() ? metresPerDegree : system.GetUnit();
  const double parallel = system.IsGeographic() ? std::cos(vtkMath::RadiansFromDegrees(a[1])) : 1.0;
  return std::hypot(
    parallel * unit * (b[0] - a[0]), unit * (b[1] - a[1]), system.GetHeightUnit() * (b[2] - a[2]));
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
  /// @{
  /// Factors to metres before, and from metres after, for heights that PROJ does not transform.
  double HeightUnit = 1.0;
  double HeightFactor = 1.0;
  ///@}
  double Epoch = 0.0; // 0: not known

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
  p[2] *= this->HeightUnit;
  if (this->From->IsLocal)
  {
    this->From->Projection->ToGeographic(from, p);
  }
  const PJ_COORD image =
    proj_trans(this->Operation.get(), PJ_FWD, ToProj(this->From->Axes, p, this->Epoch));
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
  this->State->HeightUnit = from.HeightUnit;
  this->State->HeightFactor = from.HeightFactor;
  this->State->Epoch = from.Epoch;
  if (from.Context)
  {
    // Forward() fails for every point if there is no operation.
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
    state->HeightUnit = from.IsPlane || isCut ? from.HeightUnit : 1.0;
    state->HeightFactor = to.IsPlane || isCut ? 1.0 / to.HeightUnit : 1.0;
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
void CoordinateTransform::SetEpoch(double year)
{
  this->State->Epoch = year;
}

//------------------------------------------------------------------------------
double CoordinateTransform::GetYearlyMotion(const double point[3])
{
  CoordinateTransform one(*this);
  CoordinateTransform other(*this);
  one.SetEpoch(SomeYear);
  other.SetEpoch(SomeYear + YearsApart);
  double a[3];
  double b[3];
  if (!this->State->Operation || one.Forward(point, a, 1) == 0 || other.Forward(point, b, 1) == 0)
  {
    return 0.0;
  }
  return GetLength(this->State->Target, a, b) / YearsApart;
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
  std::string warning;
  for (const std::string& part : { this->DescribeSeam(points, count),
         this->DescribeMissingGrids(points), this->GetEpochWarning(points) })
  {
    warning += (warning.empty() || part.empty() ? "" : ". ") + part;
  }
  return warning;
}

//------------------------------------------------------------------------------
std::string CoordinateTransform::GetEpochWarning(const double point[3])
{
  constexpr double noticed = 1e-5; // [m per year]
  const double motion = this->State->Epoch > 0.0 ? 0.0 : this->GetYearlyMotion(point);
  CoordinateTransform dated(*this);
  dated.SetEpoch(SomeYear);
  double still[3];
  double moved[3];
  if (motion < noticed || this->Forward(point, still, 1) == 0 ||
    dated.Forward(point, moved, 1) == 0)
  {
    return {};
  }
  std::ostringstream text;
  text.precision(2);
  text << "From " << this->State->Source.GetName() << " to " << this->State->Target.GetName()
       << " coordinates move by " << 100.0 * motion << " cm a year, and their epoch is not known: "
       << "the result is " << GetLength(this->State->Target, still, moved)
       << " m off for coordinates of " << std::fixed << std::setprecision(0) << SomeYear
       << "; give the epoch, a decimal year";
  return text.str();
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
std::string FindMetric(const CoordinateSystem& system, const double point[3])
{
  CoordinateSystem geographic;
  CoordinateTransform toPlace;
  double place[3];
  const bool isPlaced = geographic.Set("EPSG:4326").IsOk() &&
    toPlace.Set(system, geographic).IsOk() && toPlace.Forward(point, place, 1) < 0 &&
    std::abs(place[1]) <= 90.0;
  return isPlaced ? "EPSG:" + std::to_string(GetUTMCode(place[1], place[0])) : std::string();
}

//------------------------------------------------------------------------------
Status CheckMetric(const CoordinateSystem& system, const double point[3])
{
  if (system.IsMetric())
  {
    return {};
  }
  const std::string target = FindMetric(system, point);
  return Status::Error(system.GetName() + " is in " + system.GetUnitName() +
    "; reproject it to a metric system, e.g. <filter type=\"crs\"> with target " +
    (target.empty() ? "a UTM zone" : target));
}

} // namespace helios
