// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosColumnNames.h"

#include "vtkHeliosArrayNames.h"
#include "vtkHeliosFoliageArrayNames.h"

#include <vtkType.h>

#include <cctype>
#include <string>

namespace names = vtkHeliosArrayNames;
namespace foliage = vtkHeliosFoliageArrayNames;

namespace helios
{

namespace
{

struct KnownColumn
{
  const char* Words; ///< names, lower case, with a blank before and after each
  NamedColumn Column;
};

// Names by PDAL, CloudCompare, LAStools, MeshLab, ParaView and pandas, and by the arrays of
// vtkHelios.
const KnownColumn KnownColumns[] = {
  { " x easting xcoord xcoordinate points:0 points0 ", { "", 0, 3, VTK_DOUBLE } },
  { " y northing ycoord ycoordinate points:1 points1 ", { "", 1, 3, VTK_DOUBLE } },
  { " z elevation zcoord zcoordinate points:2 points2 ", { "", 2, 3, VTK_DOUBLE } },
  { " r red diffusered rgb:0 rgb0 ", { names::RGB, 0, 3, VTK_FLOAT } },
  { " g green diffusegreen rgb:1 rgb1 ", { names::RGB, 1, 3, VTK_FLOAT } },
  { " b blue diffuseblue rgb:2 rgb2 ", { names::RGB, 2, 3, VTK_FLOAT } },
  { " rf ", { names::RGB, 0, 3, VTK_FLOAT, true } },
  { " gf ", { names::RGB, 1, 3, VTK_FLOAT, true } },
  { " bf ", { names::RGB, 2, 3, VTK_FLOAT, true } },
  { " nx normals:0 normals0 normalsx ", { names::Normals, 0, 3, VTK_DOUBLE } },
  { " ny normals:1 normals1 normalsy ", { names::Normals, 1, 3, VTK_DOUBLE } },
  { " nz normals:2 normals2 normalsz ", { names::Normals, 2, 3, VTK_DOUBLE } },
  { " intensity i refl ", { names::Intensity, 0, 1, VTK_DOUBLE } },
  { " classification class classificationids classid label ",
    { names::ClassificationIds, 0, 1, VTK_INT } },
  { " returnnumber rn ", { names::ReturnNumber, 0, 1, VTK_UNSIGNED_CHAR } },
  { " numberofreturns numreturns nr ", { names::NumberOfReturns, 0, 1, VTK_UNSIGNED_CHAR } },
  { " gpstime time ", { names::GpsTime, 0, 1, VTK_DOUBLE } },
  { " legids ", { names::LegIds, 0, 1, VTK_INT } },
  { " pointsourceid pointsource ", { names::LegIds, 0, 1, VTK_INT, false, -1.0 } }, // name in LAS
  { " userdata ", { names::UserData, 0, 1, VTK_UNSIGNED_CHAR } },
  { " scananglerank scanangle ", { names::ScanAngle, 0, 1, VTK_DOUBLE } },
  { " scandirectionflag ", { names::ScanDirectionFlag, 0, 1, VTK_UNSIGNED_CHAR } },
  { " edgeofflightline ", { names::EdgeOfFlightLine, 0, 1, VTK_UNSIGNED_CHAR } },
  { " infrared nir nearinfrared ", { names::NearInfrared, 0, 1, VTK_UNSIGNED_SHORT } },
  { " scanchannel scannerchannel channelids ", { names::ChannelIds, 0, 1, VTK_INT } },
  { " classificationflags ", { names::ClassificationFlags, 0, 1, VTK_UNSIGNED_CHAR } },
  { " pulseids ", { names::PulseIds, 0, 1, VTK_TYPE_INT64 } },
  { " partids ", { names::PartIds, 0, 1, VTK_INT } },
  { " materialids ", { names::MaterialIds, 0, 1, VTK_INT } },
  { " treeids treeid ", { foliage::TreeIds, 0, 1, VTK_INT } }, // treeID of lidR
  { " speciesids ", { foliage::SpeciesIds, 0, 1, VTK_INT } },
  { " organids ", { foliage::OrganIds, 0, 1, VTK_UNSIGNED_CHAR } },
  { " amplitude ", { names::Amplitude, 0, 1, VTK_DOUBLE } },
  { " echowidth ", { names::EchoWidth, 0, 1, VTK_DOUBLE } },
  { " range ", { names::Range, 0, 1, VTK_DOUBLE } },
  { " reflectance ", { names::Reflectance, 0, 1, VTK_DOUBLE } },
  { " relativeamplitude ", { names::RelativeAmplitude, 0, 1, VTK_DOUBLE } },
  { " deviation ", { names::Deviation, 0, 1, VTK_DOUBLE } },
  { " incidenceangle ", { names::IncidenceAngle, 0, 1, VTK_DOUBLE } },
  { " cellids ", { names::CellIds, 0, 1, VTK_TYPE_INT64 } },
  { " waveformids ", { names::WaveformIds, 0, 1, VTK_TYPE_INT64 } },
  { " columnids ", { names::ColumnIds, 0, 1, VTK_TYPE_INT64 } },
  { " hit ", { names::Hit, 0, 1, VTK_UNSIGNED_CHAR } },
  { " specularevents ", { names::SpecularEvents, 0, 1, VTK_INT } },
  { " scatteredamplitude ", { names::ScatteredAmplitude, 0, 1, VTK_DOUBLE } },
  { " scattereddeviation ", { names::ScatteredDeviation, 0, 1, VTK_DOUBLE } },
  { " radialvelocity ", { names::RadialVelocity, 0, 1, VTK_DOUBLE } },
  { " weight ", { names::Weight, 0, 1, VTK_DOUBLE } },
  { " waterdepth ", { names::WaterDepth, 0, 1, VTK_DOUBLE } },
  { " truepoint0 truepoint:0 ", { names::TruePoint, 0, 3, VTK_DOUBLE } },
  { " truepoint1 truepoint:1 ", { names::TruePoint, 1, 3, VTK_DOUBLE } },
  { " truepoint2 truepoint:2 ", { names::TruePoint, 2, 3, VTK_DOUBLE } },
  { " n0 normal:0 ", { names::Normal, 0, 3, VTK_DOUBLE } },
  { " n1 normal:1 ", { names::Normal, 1, 3, VTK_DOUBLE } },
  { " n2 normal:2 ", { names::Normal, 2, 3, VTK_DOUBLE } },
  { " direction0 direction:0 ", { names::Direction, 0, 3, VTK_DOUBLE } },
  { " direction1 direction:1 ", { names::Direction, 1, 3, VTK_DOUBLE } },
  { " direction2 direction:2 ", { names::Direction, 2, 3, VTK_DOUBLE } },
  { " orientation0 orientation:0 ", { names::Orientation, 0, 4, VTK_DOUBLE } },
  { " orientation1 orientation:1 ", { names::Orientation, 1, 4, VTK_DOUBLE } },
  { " orientation2 orientation:2 ", { names::Orientation, 2, 4, VTK_DOUBLE } },
  { " orientation3 orientation:3 ", { names::Orientation, 3, 4, VTK_DOUBLE } },
  { " velocity0 velocity:0 ", { names::Velocity, 0, 3, VTK_DOUBLE } },
  { " velocity1 velocity:1 ", { names::Velocity, 1, 3, VTK_DOUBLE } },
  { " velocity2 velocity:2 ", { names::Velocity, 2, 3, VTK_DOUBLE } },
  { " partposition0 partposition:0 ", { names::PartPosition, 0, 3, VTK_DOUBLE } },
  { " partposition1 partposition:1 ", { names::PartPosition, 1, 3, VTK_DOUBLE } },
  { " partposition2 partposition:2 ", { names::PartPosition, 2, 3, VTK_DOUBLE } },
  { " partorientation0 partorientation:0 ", { names::PartOrientation, 0, 4, VTK_DOUBLE } },
  { " partorientation1 partorientation:1 ", { names::PartOrientation, 1, 4, VTK_DOUBLE } },
  { " partorientation2 partorientation:2 ", { names::PartOrientation, 2, 4, VTK_DOUBLE } },
  { " partorientation3 partorientation:3 ", { names::PartOrientation, 3, 4, VTK_DOUBLE } },
  { " partvelocity0 partvelocity:0 ", { names::PartVelocity, 0, 3, VTK_DOUBLE } },
  { " partvelocity1 partvelocity:1 ", { names::PartVelocity, 1, 3, VTK_DOUBLE } },
  { " partvelocity2 partvelocity:2 ", { names::PartVelocity, 2, 3, VTK_DOUBLE } },
};

struct CommonName
{
  const char* Array;
  const char* Name;
};

const CommonName CommonNames[] = {
  { names::ClassificationIds, "Classification" },
  { names::NearInfrared, "Infrared" },
  { names::ChannelIds, "ScanChannel" },
};

/// Returns the lower case without quotes, blanks, _ and -, up to a unit in brackets.
std::string Normalize(std::string_view name)
{
  std::string word;
  for (const char c : name.substr(0, name.find_first_of("[(")))
  {
    if (std::string_view(" \t\"'_-").find(c) == std::string_view::npos)
    {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  constexpr std::string_view prefix = "scalar"; // prefix of CloudCompare
  if (word.size() > prefix.size() && word.substr(0, prefix.size()) == prefix)
  {
    word.erase(0, prefix.size());
  }
  constexpr std::string_view normal = "normal"; // before x, y or z, or 0, 1 or 2
  if (word.size() == normal.size() + 1 && word.substr(0, normal.size()) == normal)
  {
    word.erase(1, normal.size() - 1);
  }
  return word;
}

} // namespace

NamedColumn FindNamedColumn(std::string_view name)
{
  const std::string word = ' ' + Normalize(name) + ' ';
  for (const KnownColumn& known : KnownColumns)
  {
    if (word.size() > 2 && std::string_view(known.Words).find(word) != std::string_view::npos)
    {
      return known.Column;
    }
  }
  return {};
}

const char* GetCommonName(std::string_view array)
{
  for (const CommonName& common : CommonNames)
  {
    if (array == common.Array)
    {
      return common.Name;
    }
  }
  return nullptr;
}

} // namespace helios
