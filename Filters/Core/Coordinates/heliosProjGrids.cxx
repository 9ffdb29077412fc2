// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosProjGrids.h"

#include <cmath>
#include <set>

namespace helios
{

namespace
{

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

} // namespace

//------------------------------------------------------------------------------
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

} // namespace helios
