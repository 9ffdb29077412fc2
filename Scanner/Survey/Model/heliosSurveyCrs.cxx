// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSurveyCrs.h"

#include "heliosCoordinateTransform.h"
#include "heliosMessages.h"
#include "heliosSceneCrs.h"
#include "heliosStatus.h"

#include <vtkPolyData.h>

namespace helios
{

namespace
{

/// Reads the system named by the attribute crs of a place in the file.
bool ReadCrs(
  const std::string& text, const std::string& where, Messages& log, CoordinateSystem& crs)
{
  const Status status = crs.Set(text);
  if (!status.IsOk())
  {
    log.Error(where + ": crs=\"" + text + "\" " + status.Message());
  }
  return status.IsOk();
}

/// Returns the system of the parts of a scene; not set if they have none.
CoordinateSystem GetPartsCrs(vtkPolyData* scene)
{
  CoordinateSystem crs;
  const std::string text = GetCRS(scene);
  if (!text.empty())
  {
    static_cast<void>(crs.Set(text)); // checked by its reader
  }
  return crs;
}

} // namespace

//------------------------------------------------------------------------------
bool SetSceneCrs(vtkPolyData* scene, const SceneData& data, Messages& log)
{
  CoordinateSystem crs = GetPartsCrs(scene);
  CoordinateSystem wanted;
  if (!data.Crs.empty() && !ReadCrs(data.Crs, data.Where, log, wanted))
  {
    return false;
  }
  if (crs.IsSet() && wanted.IsSet() && crs != wanted)
  {
    log.Error(data.Where + ": the coordinate system of the scene is " + wanted.GetName() +
      ", but its parts are in " + crs.GetName() +
      "; add <filter type=\"crs\"> with the scene's system as target to the parts");
    return false;
  }
  if (!crs.IsSet() && wanted.IsSet())
  {
    SetCRS(scene, data.Crs);
    crs = wanted;
  }
  const double* centre = scene->GetCenter();
  const Status status = crs.IsSet() ? CheckMetric(crs, centre) : Status();
  if (!status.IsOk())
  {
    log.Error(data.Where + ": the scene's system " + status.Message());
  }
  return status.IsOk();
}

//------------------------------------------------------------------------------
bool TransformPosition(const LegData& leg, vtkPolyData* scene, Messages& log, Vec3& position)
{
  position = leg.Position;
  if (leg.Crs.empty())
  {
    return true;
  }
  CoordinateSystem source;
  const CoordinateSystem target = GetPartsCrs(scene);
  if (!ReadCrs(leg.Crs, leg.Where, log, source))
  {
    return false;
  }
  if (!target.IsSet())
  {
    log.Error(leg.Where + ": crs=\"" + leg.Crs +
      "\", but the scene has no coordinate system to reproject the position into; give <scene> "
      "one, crs=\"EPSG:...\"");
    return false;
  }
  CoordinateTransform transform;
  Status status = transform.Set(source, target);
  if (status.IsOk() && transform.Forward(position.GetData(), position.GetData(), 1) >= 0)
  {
    status = Status::Error(transform.DescribeFailure(0, leg.Position.GetData()));
  }
  if (!status.IsOk())
  {
    log.Error(leg.Where + ": crs=\"" + leg.Crs + "\": " + status.Message());
  }
  return status.IsOk();
}

} // namespace helios
