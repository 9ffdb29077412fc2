// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The dialect: filters of parts, and their parameters.
#include "heliosXmlTables.h"

#include "heliosMessages.h"
#include "heliosSurveyData.h"
#include "heliosXmlValue.h"

#include <string>

namespace helios
{

using namespace rows;

namespace
{

constexpr auto Voxels = &PartData::Voxels;
constexpr auto Material = &PartData::Material;
constexpr auto Cells = &PartData::Vegetation;
constexpr XmlRange OtherMaterials = { 0.0, 999999.0 };

/// Sets the number of materials besides the first.
bool SetOtherMaterials(MaterialData& material, const XmlValue& value, Messages& log)
{
  const XmlValueRule rule = Integer("", "").In("", OtherMaterials);
  int others = 0;
  const bool isGood = value.Text.empty() || ParseInteger(value, rule, log, others);
  material.Count = isGood ? 1 + others : material.Count;
  return isGood;
}

std::string GetOtherMaterials(const MaterialData& material)
{
  return std::to_string(material.Count - 1);
}

/// Values of the choices y and z.
constexpr int UpIsY[] = { 1, 0 };

} // namespace

//------------------------------------------------------------------------------
std::vector<XmlElementRule> MakeFilterRules()
{
  // clang-format off
  return {
  { "filter", "a processing step of a part; the parameters depend on the type, see below",
    {
      Text("type", "type of filter").Required(),
    },
    { Many("param") } },

  { "param", "a parameter of a filter",
    {
      Text("type", "string, double, integer, boolean, vec3 or rotation: not needed, it follows from the key"),
      Text("key", "name of the parameter").Required(),
      Text("value", "value of the parameter; a rotation has rot children instead"),
      Word("rotations", "global local", "whether each rot rotates about fixed axes (global) or about the axes already rotated (local)").Default("global"),
    },
    { Many("rot") } },

  { "filter:objloader", "a Wavefront OBJ file with its MTL files",
    {
      Text("filepath", "the file").Names(XmlFile::Needed),
      Text("efilepath", "a folder and a regular expression for file names; overrides filepath").Names(XmlFile::Pattern),
      Word("up", "~y z", "the axis that points up").Meaning(UpIsY).At<&PartData::UpIsY>(),
      Flag("recomputeVertexNormals", "incidence angles use the face normals").Ignored(),
      Flag("castShadows", "for display only; parts always cast shadows").Ignored(),
      Flag("receiveShadows", "for display only").Ignored(),
    },
    {} },

  { "filter:geotiffloader", "a raster of heights",
    {
      Text("filepath", "a GeoTIFF, or a VRT of GeoTIFFs; the first band is the height").Names(XmlFile::Needed),
      Text("efilepath", "a folder and a regular expression for file names; overrides filepath").Names(XmlFile::Pattern),
      Text("matfile", "an MTL file, the material of all cells").Default("the default material").Names(XmlFile::Needed).At<Material, &MaterialData::File>(),
      Text("matname", "the material in matfile").Default("the alphabetically first").At<Material, &MaterialData::Name>(),
    },
    {} },

  { "filter:xyzloader", "points as text, converted to solid voxels",
    {
      Text("filepath", "the file").Names(XmlFile::Needed),
      Text("efilepath", "a folder and a regular expression for file names; overrides filepath").Names(XmlFile::Pattern),
      Text("separator", "column separators besides blanks and tabs").At<Voxels, &VoxelData::Separators>(),
      Number("voxelSize", "edge length of a voxel").In("m", { 1e-6, 1e6 }).At<Voxels, &VoxelData::Size>(),
      Number("maxColorValue", "colours are not used").Ignored(),
      Integer("normalXIndex", "column of the normal's x, from 0; if any of the three is given, normals are read").In("", Column).Default("3").At<Voxels, &VoxelData::NormalIndex, 0>(),
      Integer("normalYIndex", "column of the normal's y").In("", Column).Default("4").At<Voxels, &VoxelData::NormalIndex, 1>(),
      Integer("normalZIndex", "column of the normal's z").In("", Column).Default("5").At<Voxels, &VoxelData::NormalIndex, 2>(),
      Integer("rgbRIndex", "colours are not used").Ignored(),
      Integer("rgbGIndex", "colours are not used").Ignored(),
      Integer("rgbBIndex", "colours are not used").Ignored(),
      Integer("estimateNormals", "not 0: normals are estimated from the points of a voxel").In("", { 0.0, 1e9 }).At<Voxels, &VoxelData::EstimateNormals>(),
      Vector("defaultNormal", "normal of voxels without one").Default("that of the faces").At<Voxels, &VoxelData::DefaultNormal>(),
      Flag("snapNeighborNormal", "whether a voxel has the normal of the point nearest its centre instead of the mean").At<Voxels, &VoxelData::SnapNeighborNormal>(),
      Flag("sparse", "storage of other programs").Ignored(),
      Text("matfile", "an MTL file, the material of all cells").Default("the default material").Names(XmlFile::Needed).At<Material, &MaterialData::File>(),
      Text("matname", "the material in matfile").Default("the alphabetically first").At<Material, &MaterialData::Name>(),
      Integer("randomMaterials", "number of additional materials with a random change of the reflectance").In("", OtherMaterials).By<SetOtherMaterials, GetOtherMaterials, Material>(),
      Number("randomRange", "maximum of that change, up or down").In("", { 0.0, 1.0 }).At<Material, &MaterialData::RandomRange>(),
    },
    {} },

  { "filter:detailedvoxels", "vegetation as AMAPVox voxels",
    {
      Text("filepath", "the file").Names(XmlFile::Needed),
      Text("efilepath", "a folder and a regular expression for file names; overrides filepath").Names(XmlFile::Pattern),
      Word("intersectionMode", "~transmittive scaled fixed", "model of the voxels").At<Cells, &VegetationData::Mode>(),
      Number("intersectionArgument", "scaled: exponent of the edge length").In("", { 0.0, 100.0 }).At<Cells, &VegetationData::Exponent>(),
      Flag("randomShift", "scaled: whether cubes are shifted at random in their cells").At<Cells, &VegetationData::RandomShift>(),
      Text("ladlut", "a table of leaf angle distributions").Default("none").Names(XmlFile::Needed).At<Cells, &VegetationData::LeafTable>(),
      Text("matfile", "an MTL file, the material of all cells").Default("the default material").Names(XmlFile::Needed).At<Material, &MaterialData::File>(),
      Text("matname", "the material in matfile").Default("the alphabetically first").At<Material, &MaterialData::Name>(),
      Integer("randomMaterials", "number of additional materials with a random change of the reflectance").In("", OtherMaterials).By<SetOtherMaterials, GetOtherMaterials, Material>(),
      Number("randomRange", "maximum of that change, up or down").In("", { 0.0, 1.0 }).At<Material, &MaterialData::RandomRange>(),
    },
    {} },

  { "filter:plyloader", "a polygon file, text or binary",
    {
      Text("filepath", "the file").Names(XmlFile::Needed),
      Text("efilepath", "a folder and a regular expression for file names; overrides filepath").Names(XmlFile::Pattern),
      Word("up", "~y z", "the axis that points up").Meaning(UpIsY).At<&PartData::UpIsY>(),
      Text("matfile", "an MTL file, the material of all triangles").Default("the default material").Names(XmlFile::Needed).At<Material, &MaterialData::File>(),
      Text("matname", "the material in matfile").Default("the alphabetically first").At<Material, &MaterialData::Name>(),
    },
    {} },

  { "filter:stlloader", "a stereolithography file, text or binary",
    {
      Text("filepath", "the file").Names(XmlFile::Needed),
      Text("efilepath", "a folder and a regular expression for file names; overrides filepath").Names(XmlFile::Pattern),
      Word("up", "~y z", "the axis that points up").Meaning(UpIsY).At<&PartData::UpIsY>(),
      Text("matfile", "an MTL file, the material of all triangles").Default("the default material").Names(XmlFile::Needed).At<Material, &MaterialData::File>(),
      Text("matname", "the material in matfile").Default("the alphabetically first").At<Material, &MaterialData::Name>(),
    },
    {} },

  { "filter:cityjsonloader", "a city model, CityJSON 2.0 or 1.1",
    {
      Text("filepath", "the file").Names(XmlFile::Needed),
      Text("efilepath", "a folder and a regular expression for file names; overrides filepath").Names(XmlFile::Pattern),
      Text("lod", "level of detail, such as 2.2").Default("the highest of each object").At<&PartData::LevelOfDetail>(),
      Text("matfile", "an MTL file, whose materials replace those of the same name: RoofSurface, WallSurface, Road ...").Default("the default material").Names(XmlFile::Needed).At<Material, &MaterialData::File>(),
    },
    {} },

  { "filter:gltfloader", "a glTF 2.0 document, .gltf or .glb; its y axis points up",
    {
      Text("filepath", "the file").Names(XmlFile::Needed),
      Text("efilepath", "a folder and a regular expression for file names; overrides filepath").Names(XmlFile::Pattern),
      Text("matfile", "an MTL file, whose materials replace those of the same name").Default("none").Names(XmlFile::Needed).At<Material, &MaterialData::File>(),
    },
    {} },

  { "filter:lasloader", "points of a LAS or LAZ file, converted to solid voxels",
    {
      Text("filepath", "the file").Names(XmlFile::Needed),
      Text("efilepath", "a folder and a regular expression for file names; overrides filepath").Names(XmlFile::Pattern),
      Text("classes", "the classes whose points are read, such as 3 4 5").Default("all").At<Voxels, &VoxelData::Classes>(),
      Number("voxelSize", "edge length of a voxel").In("m", { 1e-6, 1e6 }).At<Voxels, &VoxelData::Size>(),
      Integer("estimateNormals", "not 0: normals are estimated from the points of a voxel").In("", { 0.0, 1e9 }).At<Voxels, &VoxelData::EstimateNormals>(),
      Vector("defaultNormal", "normal of voxels without one").Default("that of the faces").At<Voxels, &VoxelData::DefaultNormal>(),
      Text("matfile", "an MTL file, the material of all cells").Default("the default material").Names(XmlFile::Needed).At<Material, &MaterialData::File>(),
      Text("matname", "the material in matfile").Default("the alphabetically first").At<Material, &MaterialData::Name>(),
      Integer("randomMaterials", "number of additional materials with a random change of the reflectance").In("", OtherMaterials).By<SetOtherMaterials, GetOtherMaterials, Material>(),
      Number("randomRange", "maximum of that change, up or down").In("", { 0.0, 1.0 }).At<Material, &MaterialData::RandomRange>(),
    },
    {} },

  { "filter:crs", "reprojects the part before it is rotated; also crstransform, transform",
    {
      Text("source", "source coordinate system").Default("that of the file").At<&CrsData::Source>(),
      Text("target", "target coordinate system").Required().At<&CrsData::Target>(),
      Number("epoch", "epoch of the coordinates, a decimal year, for systems that move with a plate").In("", { 0.0, 3000.0 }).At<&CrsData::Epoch>(),
      Number("heightUnit", "metres per unit of the heights of the file; 0: as its system states, else that of x and y").In("m", { 0.0, 1000.0 }).At<&CrsData::HeightUnit>(),
    },
    {} },

  { "filter:repair", "merges vertices, removes degenerate and duplicate triangles",
    {},
    {} },

  { "filter:simplify", "reduces the number of triangles; the two surfaces are guaranteed to be within a distance; needs CGAL",
    {
      Number("maximumDistance", "maximum distance of the surfaces").In("m", { 1e-9, 1e6 }).Required().At<&PartData::SimplifyDistance>(),
    },
    {} },

  { "filter:frames", "a mesh that deforms: numbered files with the same faces, or an animation of glTF; points move on straight lines from frame to frame",
    {
      Text("efilepath", "a folder and a regular expression for the names of the frames").Default("those of the loader").Names(XmlFile::Pattern),
      Number("framesPerSecond", "rate of the files; of an animation, the rate at which it is posed").In("1/s", { 1e-6, 1e6 }).Default("required; 25 of an animation").At<&FramesData::Rate>(),
      Word("atEnd", "error hold loop", "what a survey finds before the first and after the last frame: an error, that frame, or the frames again").At<&FramesData::End>(),
      Number("tStart", "time of the frames at time 0 of the survey").In("s", Moment).At<&FramesData::Start>(),
      Text("animation", "name of an animation of glTF, or its number from 0").Default("the first").At<&FramesData::Animation>(),
    },
    {} },

  { "filter:scale", "scales the part about its origin",
    {
      Number("scale", "factor; the last scale of a part is used").In("", { 1e-9, 1e9 }).At<&PartData::Scale>(),
    },
    {} },

  { "filter:translate", "moves the part. The last translate of a part is used",
    {
      Vector("offset", "displacement").In("m").At<&PartData::Translation>(),
      Integer("onGround", "not 0: the lowest corner is moved onto the ground below").In("", { -1e9, 1e9 }).At<&PartData::OnGround>(),
    },
    {} },

  { "filter:rotate", "rotates the part about its origin; rotations add up",
    {
      Rotated("rotation", "rot children").Default("none"),
    },
    {} },
  };
  // clang-format on
}

} // namespace helios
