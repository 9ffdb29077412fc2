// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlPart.h"

#include "heliosMessages.h"
#include "heliosXmlFilter.h"
#include "heliosXmlFrames.h"
#include "heliosXmlMotion.h"
#include "heliosXmlRules.h"

#include <algorithm>
#include <array>

namespace helios
{

namespace
{

/// Reads the filters of one <part> or <swap>.
class PartReader
{
public:
  PartReader(const XmlElement& element, Assets& assets)
    : Element(element)
    , Files(assets)
  {
  }

  PartData Read();

  /// Reads a <swap> of a part that is already read.
  SwapData ReadSwap(const PartData& part);

private:
  using Reading = void (PartReader::*)(const XmlFilter&);

  static Reading FindReading(const std::string& type);
  void ReadFilters();
  void ReadSwaps();
  void ReadObjLoader(const XmlFilter& filter);
  void ReadPlyLoader(const XmlFilter& filter) { this->ReadMeshLoader(filter, Loader::Ply); }
  void ReadStlLoader(const XmlFilter& filter) { this->ReadMeshLoader(filter, Loader::Stl); }
  void ReadCityLoader(const XmlFilter& filter) { this->ReadMeshLoader(filter, Loader::CityJson); }
  void ReadGltfLoader(const XmlFilter& filter) { this->ReadMeshLoader(filter, Loader::Gltf); }
  void ReadGeoTiffLoader(const XmlFilter& filter) { this->ReadMeshLoader(filter, Loader::GeoTiff); }
  void ReadMeshLoader(const XmlFilter& filter, Loader type);
  void ReadXyzLoader(const XmlFilter& filter);
  void ReadLasLoader(const XmlFilter& filter) { this->ReadMeshLoader(filter, Loader::Las); }
  void ReadNormals(const XmlFilter& filter);
  void ReadVegetation(const XmlFilter& filter);
  bool StartLoader(const XmlFilter& filter, Loader type);
  void ReadMaterial(const XmlFilter& filter);
  void ReadCrs(const XmlFilter& filter);
  void ReadRepair(const XmlFilter&) { this->Part.Repair = true; }
  void ReadSimplify(const XmlFilter& filter);
  void ReadFrames(const XmlFilter& filter) { helios::ReadFrames(filter, this->Files, this->Part); }
  void ReadRotate(const XmlFilter& filter);
  void ReadScale(const XmlFilter& filter);
  void ReadTranslate(const XmlFilter& filter);
  void WarnIfRepeated(const XmlFilter& filter, bool& seen);
  void ReportFilter(const XmlFilter& filter);
  void CheckTurbid();

  const XmlElement& Element;
  Assets& Files;
  PartData Part;
  bool IsSwap = false;
  bool HasFilter = false;
  bool HasLoader = false;
  bool HasScale = false;
  bool HasTranslate = false;
};

//------------------------------------------------------------------------------
PartData PartReader::Read()
{
  this->Element.CheckNames();
  this->Part.Where = this->Element.Where();
  this->Element.ReadStored(this->Part);
  this->ReadFilters();
  if (!this->HasLoader)
  {
    this->Element.GetMessages().Error(this->Part.Where + ": <" + this->Element.GetTag() +
      "> has no loader; add a <filter type=\"objloader\"> or another one of " +
      JoinChoices(GetLoaders()));
  }
  this->CheckTurbid();
  CheckFrames(this->Part, this->Element.GetMessages());
  this->ReadSwaps();
  return this->Part;
}

//------------------------------------------------------------------------------
void PartReader::ReadFilters()
{
  for (const XmlElement& element : this->Element.GetChildren("filter"))
  {
    const XmlFilter filter(element);
    (this->*FindReading(filter.GetType()))(filter);
    this->HasFilter = true;
  }
}

//------------------------------------------------------------------------------
void PartReader::ReadSwaps()
{
  const PartData part = this->Part;
  for (const XmlElement& swap : this->Element.GetChildren("swap"))
  {
    this->Part.Swaps.push_back(PartReader(swap, this->Files).ReadSwap(part));
  }
  const bool areParts = this->Part.Files.size() > 1 && !this->Part.Frames.IsGiven();
  if (!this->Part.Swaps.empty() && this->Part.Name.empty() && areParts)
  {
    this->Element.GetMessages().Error(this->Part.Swaps.front().Part.Where +
      ": <swap> needs one part, but this <part> has several files and no id, so each file is a "
      "part; give <part> an id=\"...\" to make them one");
  }
}

//------------------------------------------------------------------------------
SwapData PartReader::ReadSwap(const PartData& part)
{
  Messages& log = this->Element.GetMessages();
  SwapData swap;
  bool keepsCrs = true;
  this->Element.CheckNames();
  this->Element.ReadStored(swap);
  this->Element.Read("keepCRS", keepsCrs);
  this->IsSwap = true;
  this->Part = part; // with its loader and filters, without its rotation, scale and translation
  this->Part.Where = this->Element.Where();
  this->Part.Rotation = Quaternion(1.0, 0.0, 0.0, 0.0);
  this->Part.Scale = 1.0;
  this->Part.Translation = Vec3(0.0, 0.0, 0.0);
  this->Part.OnGround = false;
  this->ReadFilters();
  if (!keepsCrs)
  {
    log.Warning(this->Part.Where +
      ": keepCRS=\"false\" is not used: scenes are not shifted, and geometry keeps its "
      "coordinates");
  }
  if (swap.IsRemoved && this->HasFilter)
  {
    log.Warning(
      this->Part.Where + ": force_null=\"true\" removes the part; the filters are not used");
  }
  if (!swap.IsRemoved && !this->HasFilter)
  {
    log.Error(this->Part.Where +
      ": <swap> has no filter; add a loader, or filters that turn, scale or move the part, or "
      "force_null=\"true\" to remove it");
  }
  if (!swap.IsRemoved)
  {
    this->CheckTurbid();
    CheckFrames(this->Part, log);
  }
  swap.Part = this->Part;
  return swap;
}

//------------------------------------------------------------------------------
PartReader::Reading PartReader::FindReading(const std::string& type)
{
  static const std::map<std::string, Reading> readings = {
    { "objloader", &PartReader::ReadObjLoader },
    { "geotiffloader", &PartReader::ReadGeoTiffLoader },
    { "xyzloader", &PartReader::ReadXyzLoader },
    { "detailedvoxels", &PartReader::ReadVegetation },
    { "plyloader", &PartReader::ReadPlyLoader },
    { "stlloader", &PartReader::ReadStlLoader },
    { "cityjsonloader", &PartReader::ReadCityLoader },
    { "gltfloader", &PartReader::ReadGltfLoader },
    { "lasloader", &PartReader::ReadLasLoader },
    { "crs", &PartReader::ReadCrs },
    { "repair", &PartReader::ReadRepair },
    { "simplify", &PartReader::ReadSimplify },
    { "frames", &PartReader::ReadFrames },
    { "rotate", &PartReader::ReadRotate },
    { "scale", &PartReader::ReadScale },
    { "translate", &PartReader::ReadTranslate },
  };
  const auto found = readings.find(type);
  return found != readings.end() ? found->second : &PartReader::ReportFilter;
}

//------------------------------------------------------------------------------
bool PartReader::StartLoader(const XmlFilter& filter, Loader type)
{
  Messages& log = filter.GetMessages();
  if (this->HasLoader)
  {
    log.Error(filter.Where() + ": a second loader in one <" + this->Element.GetTag() +
      (this->IsSwap ? ">; remove one" : ">; make a <part> of each"));
    return false;
  }
  if (this->IsSwap && this->HasFilter)
  {
    log.Error(filter.Where() + ": filter " + filter.GetType() +
      " comes after other filters of a <swap>, and would undo them; put it first");
    return false;
  }
  this->HasLoader = true;
  if (this->IsSwap) // nothing of the part remains
  {
    PartData fresh;
    fresh.Where = this->Part.Where;
    fresh.Name = this->Part.Name;
    fresh.Classification = this->Part.Classification;
    fresh.Species = this->Part.Species;
    fresh.Tree = this->Part.Tree;
    this->Part = fresh;
  }
  this->Part.Type = type;
  const XmlDocument& document = filter.GetElement().GetDocument();
  if (filter.Has("efilepath"))
  {
    this->Part.Files = this->Files.FindFiles(filter.GetValue("efilepath"), document);
  }
  else if (filter.Has("filepath"))
  {
    this->Part.Files = { this->Files.FindFile(filter.GetValue("filepath"), document) };
  }
  else
  {
    log.Error(filter.Where() + ": filter " + filter.GetType() +
      " has no filepath; add <param key=\"filepath\" value=\"...\">");
  }
  return true;
}

//------------------------------------------------------------------------------
void PartReader::ReadObjLoader(const XmlFilter& filter)
{
  if (this->StartLoader(filter, Loader::Obj))
  {
    filter.ReadStored(this->Part);
  }
}

//------------------------------------------------------------------------------
/// Reads a loader with a material file.
void PartReader::ReadMeshLoader(const XmlFilter& filter, Loader type)
{
  if (this->StartLoader(filter, type))
  {
    filter.ReadStored(this->Part);
    this->ReadMaterial(filter);
  }
}

//------------------------------------------------------------------------------
void PartReader::ReadXyzLoader(const XmlFilter& filter)
{
  if (!this->StartLoader(filter, Loader::Xyz))
  {
    return;
  }
  filter.ReadStored(this->Part);
  this->ReadNormals(filter);
  this->ReadMaterial(filter);
}

//------------------------------------------------------------------------------
void PartReader::ReadNormals(const XmlFilter& filter)
{
  VoxelData& voxels = this->Part.Voxels;
  const bool wanted = filter.Has("estimateNormals") || filter.Has("normalXIndex") ||
    filter.Has("normalYIndex") || filter.Has("normalZIndex");
  voxels.ReadNormals = wanted && !voxels.EstimateNormals;
}

//------------------------------------------------------------------------------
void PartReader::ReadVegetation(const XmlFilter& filter)
{
  if (!this->StartLoader(filter, Loader::Vegetation))
  {
    return;
  }
  VegetationData& cells = this->Part.Vegetation;
  filter.ReadStored(this->Part);
  if (filter.Has("ladlut"))
  {
    cells.LeafTable =
      this->Files.FindFile(filter.GetValue("ladlut"), filter.GetElement().GetDocument());
  }
  this->ReadMaterial(filter);
}

//------------------------------------------------------------------------------
/// Checks for filters that turbid cells do not support: they are not a mesh.
void PartReader::CheckTurbid()
{
  Messages& log = this->Element.GetMessages();
  if (this->Part.IsTurbid() && !this->Part.Crs.empty())
  {
    log.Error(this->Part.Crs.front().Where +
      ": filter crs cannot reproject transmittive voxels; give the grid in the scene's system, or "
      "intersectionMode=\"scaled\" or \"fixed\"");
  }
  if (this->Part.IsTurbid() && (this->Part.Repair || this->Part.SimplifyDistance > 0.0))
  {
    log.Warning(
      this->Part.Where + ": filters repair and simplify have no effect on transmittive voxels");
  }
}

//------------------------------------------------------------------------------
void PartReader::ReadMaterial(const XmlFilter& filter)
{
  MaterialData& material = this->Part.Material;
  material.Where = filter.Where();
  int others = 0;
  filter.Read("randomMaterials", others);
  material.Count = 1 + others;
  if (filter.Has("matfile"))
  {
    const XmlDocument& document = filter.GetElement().GetDocument();
    material.Where = filter.GetValue("matfile").Where;
    material.File = this->Files.FindFile(filter.GetValue("matfile"), document);
  }
  for (const char* key : { "matname", "randomMaterials" })
  {
    if (material.File.empty() && !filter.Has("matfile") && filter.Has(key))
    {
      const XmlValue value = filter.GetValue(key);
      filter.GetMessages().Warning(value.Where + ": " + key + "=\"" + value.Text +
        "\" is not used without a matfile; add <param key=\"matfile\" value=\"....mtl\">");
    }
  }
}

//------------------------------------------------------------------------------
void PartReader::ReadCrs(const XmlFilter& filter)
{
  CrsData crs;
  crs.Where = filter.Where();
  filter.ReadStored(crs);
  if (crs.Target.empty())
  {
    filter.GetMessages().Error(
      crs.Where + ": filter crs has no target; add <param key=\"target\" value=\"EPSG:...\">");
  }
  this->Part.Crs.push_back(crs);
}

//------------------------------------------------------------------------------
void PartReader::ReadSimplify(const XmlFilter& filter)
{
  if (!filter.Has("maximumDistance"))
  {
    filter.GetMessages().Error(filter.Where() +
      ": filter simplify has no maximumDistance; add <param key=\"maximumDistance\" "
      "value=\"0.01\"> with the metres that the surface may move");
  }
  filter.ReadStored(this->Part);
}

//------------------------------------------------------------------------------
void PartReader::ReadRotate(const XmlFilter& filter)
{
  if (filter.Has("rotation"))
  {
    this->Part.Rotation = filter.GetParameter("rotation").ReadRotation() * this->Part.Rotation;
  }
}

//------------------------------------------------------------------------------
void PartReader::ReadScale(const XmlFilter& filter)
{
  if (filter.Has("scale"))
  {
    this->WarnIfRepeated(filter, this->HasScale);
    filter.ReadStored(this->Part);
  }
}

//------------------------------------------------------------------------------
void PartReader::ReadTranslate(const XmlFilter& filter)
{
  this->WarnIfRepeated(filter, this->HasTranslate);
  this->Part.Translation = Vec3(0.0, 0.0, 0.0);
  this->Part.OnGround = false;
  filter.ReadStored(this->Part);
}

//------------------------------------------------------------------------------
void PartReader::WarnIfRepeated(const XmlFilter& filter, bool& seen)
{
  if (seen)
  {
    filter.GetMessages().Warning(filter.Where() + ": a repeated filter " + filter.GetType() +
      " replaces the one before it in this <" + this->Element.GetTag() + ">");
  }
  seen = true;
}

//------------------------------------------------------------------------------
void PartReader::ReportFilter(const XmlFilter& filter)
{
  static const std::array<const char*, 2> later = { "assumematerials", "wms" };
  const std::string& type = filter.GetType();
  const std::vector<std::string>& now = GetFilterTypes();
  std::string text = filter.Where() + ": filter type=\"" + type + "\" ";
  if (std::find(later.begin(), later.end(), type) != later.end())
  {
    text += "is not supported by this version; supported are ";
  }
  else
  {
    const std::string nearest = FindNearestName(type, now);
    text +=
      "is unknown; " + (nearest.empty() ? "" : "did you mean " + nearest + "? ") + "Filters are ";
  }
  filter.GetMessages().Error(text + JoinChoices(now));
  this->HasLoader = this->HasLoader || type.find("load") != std::string::npos ||
    type.find("voxel") != std::string::npos;
}

/// Reads the trajectory that a part follows, if there is one.
void ReadTrack(const XmlElement& element, Assets& assets, TrajectoryFileData& track)
{
  if (!element)
  {
    return;
  }
  element.CheckNames();
  element.ReadStored(track);
  track.Where = element.Where();
  track.File = element.Has("file")
    ? assets.FindFile(
        { "file", element.GetText("file"), element.Where("file") }, element.GetDocument())
    : std::string();
  if (!element.Has("file"))
  {
    element.GetMessages().Error(
      element.Where() + ": <trajectory> has no file; give the one with the path of the part");
  }
}

/// Sets the motion of a part and its swaps; turbid voxels have none.
void SetMotion(const XmlElement& element, const MotionData& motion, PartData& part)
{
  part.Motion = motion;
  const char* const what = !motion.Sequences.empty() ? "dmotion"
    : element.GetChild("trajectory")                 ? "trajectory"
                                                     : nullptr;
  if (part.IsTurbid() && (what || !motion.Mount.empty()))
  {
    element.GetMessages().Error(
      (what ? element.GetChild(what).Where() + ": <" + what + ">" : element.Where() + ": mount") +
      " does not move transmittive voxels; give intersectionMode=\"scaled\" or "
      "\"fixed\", or remove it");
  }
}

} // namespace

//------------------------------------------------------------------------------
PartData ReadPart(const XmlElement& element, const XmlElement& scene, Assets& assets)
{
  PartData part = PartReader(element, assets).Read();
  MotionData motion = ReadMotion(element, scene);
  motion.Where = element.Where();
  ReadTrack(element.GetChild("trajectory"), assets, motion.Track);
  SetMotion(element, motion, part);
  for (SwapData& swap : part.Swaps)
  {
    SetMotion(element, motion, swap.Part);
  }
  return part;
}

} // namespace helios
