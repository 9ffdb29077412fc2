// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// City models made for tests.

#ifndef heliosCityTesting_h
#define heliosCityTesting_h

#include "heliosSceneReading.h"
#include "vtkHeliosCityJSONReader.h"

#include <string>

namespace helios::city
{

using Reading = SceneReading<vtkHeliosCityJSONReader>;

/// The corners of a box of 4 m by 3 m by 2 m, in centimetres, the corners of a window of 1 m by 1 m
/// in its front, and the corners of a square of 10 m around it, below.
inline const std::string Vertices =
  "[[0,0,0],[400,0,0],[400,300,0],[0,300,0],[0,0,200],[400,0,200],[400,300,200],[0,300,200],"
  "[100,0,50],[200,0,50],[200,0,150],[100,0,150],"
  "[-300,-300,0],[700,-300,0],[700,700,0],[-300,700,0]]";

/// The shells of a solid: the front has a hole.
inline const std::string Box = "[[[[0,3,2,1]],[[4,5,6,7]],[[0,1,5,4],[8,11,10,9]],[[1,2,6,5]],"
                               "[[2,3,7,6]],[[3,0,4,7]]]]";

inline const std::string Semantics =
  "{\"surfaces\":[{\"type\":\"GroundSurface\"},{\"type\":\"RoofSurface\"},{\"type\":"
  "\"WallSurface\"}],\"values\":[[0,1,2,2,2,null]]}";

/// A file with some objects, of version 2.0.
inline std::string MakeFile(const std::string& objects, const std::string& more = "")
{
  return "{\"type\":\"CityJSON\",\"version\":\"2.0\",\n\"transform\":{\"scale\":[0.01,0.01,0.01],"
         "\"translate\":[85000.5,447000.25,-1]},\n" +
    more + "\"CityObjects\":{\n" + objects + "\n},\n\"vertices\":" + Vertices + "\n}\n";
}

inline std::string MakeObject(
  const std::string& name, const std::string& type, const std::string& geometries)
{
  return "\"" + name + "\":{\"type\":\"" + type + "\",\"geometry\":[" + geometries + "]}";
}

inline std::string MakeGeometry(const std::string& type, const std::string& lod,
  const std::string& boundaries, const std::string& semantics = "null")
{
  return "{\"type\":\"" + type + "\",\"lod\":\"" + lod + "\",\"boundaries\":" + boundaries +
    (semantics == "null" ? "" : ",\"semantics\":" + semantics) + "}";
}

/// A building with its ground around it.
inline std::string MakeHouse(const std::string& more = "")
{
  return MakeFile(MakeObject("house", "Building", MakeGeometry("Solid", "2.2", Box, Semantics)) +
      ",\n" +
      MakeObject(
        "yard", "LandUse", MakeGeometry("MultiSurface", "1", "[[[12,13,14,15],[0,1,2,3]]]")),
    more);
}

} // namespace helios::city

#endif
