// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The dialect: scenes and parts.
#include "heliosXmlTables.h"

#include "heliosPartTable.h"
#include "heliosSurveyData.h"

namespace helios
{

using namespace rows;

namespace
{

constexpr XmlRange Classes = { 0.0, 255.0 };
constexpr XmlRange Scales = { 1e-9, 1e9 };
constexpr XmlRange Trees = { 0.0, 2147483647.0 };

} // namespace

//------------------------------------------------------------------------------
std::vector<XmlElementRule> MakeSceneRules()
{
  // clang-format off
  return {
  { "scene", "the parts to scan",
    {
      Text("id", "identifier for references").At<&SceneData::Id>(),
      Text("name", "a title").At<&SceneData::Name>(),
      Text("crs", "coordinate system of parts without one of their own, as EPSG:n, WKT or PROJ").Default("a local frame in metres").At<&SceneData::Crs>(),
      Integer("dynStep", "pulses of a channel between updates of moving parts").In("", Steps).Default("1"),
      Number("dynTimeStep", "time between updates of moving parts, instead of dynStep").In("s", TimeStep).Default("as dynStep"),
      Word("motion", "steps continuous", "whether parts jump from step to step, or every pulse sees them where they are at its time, between two steps").At<&MotionData::IsContinuous>(),
    },
    { Many("part"), Many("partTable"), One("sunDir", "light of the display; sunlight as noise is solarIrradiance_W_m2_nm of the scanner").Ignored(), One("sky", "background of the display").Ignored(), One("skybox", "background of the display").Ignored() } },

  { "part", "a mesh: a loader, then filters that rotate, scale and move it, in this order",
    {
      Text("id", "name of the part, and object of its points").Default("its number").At<&PartData::Name>(),
      Text("name", "the name of a part is its id").Ignored(),
      Integer("classification", "class of its echoes").In("", Classes).Default("those of its materials").At<&PartData::Classification>(),
      Text("species", "species of the tree that the part is").At<&PartData::Species>(),
      Integer("tree", "number of the tree that the part is, or is a part of: TreeIds of its echoes").In("", Trees).Default("with a species, the number of the part").At<&PartData::Tree>(),
      Integer("dynStep", "updates of the scene per update of the part").In("", Steps).Default("1"),
      Number("dynTimeStep", "time between updates of the part: a multiple of the scene's dynTimeStep, if it has one").In("s", TimeStep).Default("as dynStep"),
      Integer("kdtDynStep", "updates of the part per update of the geometry that rays see").In("", Steps).Default("1"),
      Number("kdtDynTimeStep", "time between updates of the geometry that rays see").In("s", TimeStep).Default("as kdtDynStep"),
      Word("motion", "steps continuous", "whether the part jumps from step to step, or every pulse sees it where it is at its time").Default("as of the scene").At<&MotionData::IsContinuous>(),
      Text("mount", "id of the part that carries it: a wheel moves with its car, and by its own motion beside the car at rest").At<&MotionData::Mount>(),
    },
    { Many("filter"), One("color", "colour of the display").Ignored(), Many("swap"), Many("dmotion"), One("trajectory", "the path of the part's frame, in which its filters place it") } },

  { "trajectory", "a file with positions and attitudes of the frame of a part, read as trajectories of platforms are",
    {
      Text("file", "the file").Required().Names(XmlFile::Needed).At<&TrajectoryFileData::File>(),
      Word("format", "~auto columns sbet tum euroc", "format of the file; auto: by its ending, .sbet and .out SBET, .tum TUM, others text columns").At<&TrajectoryFileData::Format>(),
      Text("crs", "SBET: geographic coordinate system of the file, as EPSG:n, WKT or PROJ").Default("EPSG:4979").At<&TrajectoryFileData::Crs>(),
      Word("body", "~rightForwardUp forwardLeftUp forwardRightDown", "TUM, EuRoC: axes x, y, z of the body").At<&TrajectoryFileData::Body>(),
      Text("separator", "column separator").KeepsBlanks().At<&TrajectoryFileData::Separator>(),
      Integer("tIndex", "column of time, from 0").In("", Column).Default("0").At<&TrajectoryFileData::Columns, 0>(),
      Integer("rollIndex", "column of roll").In("", Column).Default("1").At<&TrajectoryFileData::Columns, 1>(),
      Integer("pitchIndex", "column of pitch").In("", Column).Default("2").At<&TrajectoryFileData::Columns, 2>(),
      Integer("yawIndex", "column of yaw").In("", Column).Default("3").At<&TrajectoryFileData::Columns, 3>(),
      Integer("xIndex", "column of x").In("", Column).Default("4").At<&TrajectoryFileData::Columns, 4>(),
      Integer("yIndex", "column of y").In("", Column).Default("5").At<&TrajectoryFileData::Columns, 5>(),
      Integer("zIndex", "column of z").In("", Column).Default("6").At<&TrajectoryFileData::Columns, 6>(),
      Word("interpolationDomain", "position position_and_attitude", "which columns the file has").At<&TrajectoryFileData::HasAttitude>(),
      Flag("toRadians", "true: the angles in the file are degrees; false: radians").Inverted().At<&TrajectoryFileData::IsInRadians>(),
      Number("tStart", "time in the file at time 0 of the survey").In("s", Moment).Default("the first one").At<&TrajectoryFileData::StartTime>(),
    },
    {} },

  { "partTable", "parts from a list, after all other parts of the scene: a row for each place where a model stands",
    {
      Text("file", "a CSV file with a line of names of columns, which are the attributes of row, and a line per part").Default("row children").Names(XmlFile::Needed).At<&PartTableData::File>(),
      Integer("seed", "seed of the random values of the table, which --seed does not change").In("", { 0.0, 2147483647.0 }).At<&PartTableData::Seed>(),
      Number("yawMin_deg", "lowest random yaw_deg").In("deg", HeadAngle).At<&PartTableData::YawMin>(),
      Number("yawMax_deg", "highest random yaw_deg").In("deg", HeadAngle).At<&PartTableData::YawMax>(),
      Number("scaleMin", "lowest random scale").In("", Scales).At<&PartTableData::ScaleMin>(),
      Number("scaleMax", "highest random scale").In("", Scales).At<&PartTableData::ScaleMax>(),
    },
    { Many("model"), Many("row") } },

  { "model", "a part that rows of a table place: a loader, then filters as of a part",
    {
      Text("id", "name of the model in rows").Required().At<&PartData::Name>(),
      Number("share", "its share of the rows without a model, in proportion to that of the others; 0: only rows that name it").In("", { 0.0, 1e9 }).At<&TableModel::Share>(),
      Integer("classification", "class of the echoes of its parts").In("", Classes).Default("those of its materials").At<&PartData::Classification>(),
      Text("species", "species of its trees").At<&PartData::Species>(),
    },
    { Many("filter") } },

  { "row", "a part of a table: the model, as its filters make it, is rotated, scaled and moved",
    {
      Text("model", "id of a model, or a file with a mesh").Default("one of the models at random").Names(XmlFile::Optional).At<&TableRow::Model>(),
      Number("x", "place of the origin of the model").In("m").Required().At<&TableRow::X>(),
      Number("y", "place of the origin of the model").In("m").Required().At<&TableRow::Y>(),
      Number("z", "place of the origin of the model").In("m").Default("that at which its lowest corner is on the ground below").At<&TableRow::Z>(),
      Number("yaw_deg", "rotation about the vertical, anticlockwise from above").In("deg", HeadAngle).Default("random, from yawMin_deg to yawMax_deg").At<&TableRow::Yaw>(),
      Number("scale", "factor").In("", Scales).Default("random, from scaleMin to scaleMax").At<&TableRow::Scale>(),
      Text("id", "name of the part, and object of its points").Default("the number of the part").At<&TableRow::Name>(),
      Integer("classification", "class of its echoes").In("", Classes).Default("that of the model").At<&TableRow::Classification>(),
      Text("species", "species of the tree").Default("that of the model").At<&TableRow::Species>(),
      Integer("tree", "number of the tree, as in an inventory: TreeIds of its echoes").In("", Trees).Default("with a species, the number of the part").At<&TableRow::Tree>(),
    },
    {} },

  { "dmotion", "motion of the part: each step applies all its motions, in their order; the first dmotion starts",
    {
      Text("id", "identifier for next"),
      Integer("loop", "number of steps; 0: without end").In("", { 0.0, 1e9 }).Required(),
      Text("next", "id of the next dmotion; an earlier one makes a cycle").Default("none: the part stops"),
    },
    { Many("motion") } },

  { "motion", "one motion of a step",
    {
      Word("type", "~identity translation rotation reflection glideplane helical rotsym", "type of motion").Required(),
      Vector("vec", "translation: displacement per step").In("m"),
      Vector("axis", "rotation, helical, rotsym: rotation axis, right-handed"),
      Number("angle", "angle per step").In("deg", { -1e6, 1e6 }).At<&Motion::Angle>(),
      Vector("center", "rotation, rotsym: a point on the axis").In("m").At<&Motion::Center>(),
      Vector("ortho", "reflection, glideplane: normal of the plane through 0;0;0"),
      Vector("shift", "glideplane: displacement in the plane").In("m").Default("0;0;0"),
      Number("glide", "helical: displacement along the axis per step").In("m").At<&Motion::Glide>(),
      Flag("selfMode", "whether 0;0;0 is the current centroid of the part").At<&Motion::IsSelf>(),
      Number("autoCRS", "not needed: scenes are not shifted, coordinates are always those of the scene").Ignored(),
    },
    {} },

  { "swap", "geometry that replaces the part in later epochs of the survey",
    {
      Integer("swapStep", "number of epochs").In("epochs", { 1.0, 9999.0 }).At<&SwapData::Epochs>(),
      Flag("keepCRS", "whether its geometry is shifted with the scene; scenes are not shifted here, so false only causes a warning").Default("true"),
      Flag("force_null", "whether the part is removed").At<&SwapData::IsRemoved>(),
      Text("swapIndices", "no program reads it").Later(),
    },
    { Many("filter") } },
  };
  // clang-format on
}

} // namespace helios
