// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoordinateTransform.h"
#include "heliosMutation.h"
#include "heliosStatus.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <iterator>
#include <string>

namespace
{

const char* const Texts[] = {
  R"(PROJCS["WGS 84 / UTM zone 32N",GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],)"
  R"(PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],)"
  R"(PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",9],PARAMETER["scale_factor",0.9996],)"
  R"(PARAMETER["false_easting",500000],PARAMETER["false_northing",0],UNIT["metre",1]])",
  R"(GEOGCRS["WGS 84",DATUM["World Geodetic System 1984",ELLIPSOID["WGS 84",6378137,298.257223563]],)"
  R"(CS[ellipsoidal,2],AXIS["lat",north,ANGLEUNIT["degree",0.0174532925199433]],)"
  R"(AXIS["lon",east,ANGLEUNIT["degree",0.0174532925199433]]])",
  "+proj=tmerc +lat_0=0 +lon_0=9 +k=0.9996 +x_0=500000 +y_0=0 +datum=WGS84 +units=m",
  ("+proj=lcc +lat_1=49 +lat_2=44 +lat_0=46.5 +lon_0=3 +x_0=700000 +y_0=6600000 +ellps=GRS80 "
   "+towgs84=0,0,0"),
  "EPSG:25832+7837",
  "ENU 49.4 8.7 110",
};

} // namespace

TEST_CASE(
  "CoordinateSystem: a damaged text is an error or a system", "[CoordinateSystem][mutation]")
{
  helios::CoordinateSystem geographic;
  REQUIRE(geographic.Set("EPSG:4979").IsOk());
  int failures = 0;
  for (int seed = 0; seed < helios::GetNumberOfMutations(); ++seed)
  {
    helios::Mutator mutate(seed);
    const std::string text = mutate(Texts[seed % std::size(Texts)]);
    CAPTURE(seed, text);
    helios::CoordinateSystem system;
    const helios::Status status = system.Set(text);
    REQUIRE(status.IsOk() == system.IsSet());
    helios::CoordinateTransform transform;
    if (!status.IsOk() || !transform.Set(geographic, system).IsOk())
    {
      ++failures;
      continue;
    }
    const double place[3] = { 8.7, 49.4, 110.0 };
    double image[3];
    const bool isMoved = transform.Forward(place, image, 1) < 0;
    REQUIRE(isMoved == std::isfinite(image[0] + image[1] + image[2]));
    REQUIRE(helios::CheckMetric(system, place).IsOk() == system.IsMetric());
  }
  CHECK(failures > helios::GetNumberOfMutations() / 4);
  CHECK(failures < helios::GetNumberOfMutations());
}
