// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Mirrors and glass in material files.
#include "heliosObjTestFiles.h"

#include "vtkHeliosObjSceneWriter.h"

#include <vtkFieldData.h>

#include <catch2/catch.hpp>

#include <string>

using helios::MaterialOptics;
using helios::ObjReading;
using helios::ObjSquare;
using helios::OpticsKind;
using helios::TestFolder;

namespace
{

/// The optics of a material of some lines.
MaterialOptics ReadOptics(const std::string& lines)
{
  TestFolder folder;
  folder.Write("a.mtl", "newmtl m\n" + lines);
  ObjReading reading(folder.Write("a.obj", "mtllib a.mtl\n" + ObjSquare + "usemtl m\nf 1 2 3\n"));
  REQUIRE(reading.Read());
  CHECK(reading.Log->Warnings.empty());
  return reading.MaterialOf(0).Optics;
}

void CheckError(const std::string& lines, const std::string& message)
{
  TestFolder folder;
  const std::string path = folder.Write("a.mtl", "newmtl m\n" + lines);
  ObjReading reading(folder.Write("a.obj", "mtllib a.mtl\n" + ObjSquare + "usemtl m\nf 1 2 3\n"));
  INFO(lines);
  CHECK_FALSE(reading.Read());
  INFO("said: " << reading.Log->Errors);
  CHECK(reading.Log->HasError(path + message));
}

} // namespace

TEST_CASE("MtlOptics: kinds and numbers", "[MtlOptics]")
{
  CHECK(ReadOptics("helios_optics mirror\nhelios_mirrorReflectance 0.8\n") ==
    MaterialOptics{ OpticsKind::Mirror, 0.8 });
  CHECK(ReadOptics("Ni 1.52\nhelios_thickness 0.006\nhelios_optics pane\nhelios_attenuation 4\n") ==
    MaterialOptics{ OpticsKind::Pane, 1.0, 1.52, 0.006, 4.0 });
  CHECK(ReadOptics("helios_optics volume\nNi 1.33\n") ==
    MaterialOptics{ OpticsKind::Volume, 1.0, 1.33 });
}

TEST_CASE("MtlOptics: waters", "[MtlOptics]")
{
  const MaterialOptics clear = ReadOptics("helios_water clear\n");
  CHECK(clear.Kind == OpticsKind::Water);
  CHECK(clear.RefractiveIndex == 1.34);
  CHECK(clear.Attenuation == 0.116);
  CHECK(clear.Backscatter == 2.6e-4);
  CHECK(ReadOptics("helios_optics water\n") ==
    MaterialOptics{ OpticsKind::Water, 1.0, helios::WaterIndex });
  const MaterialOptics own =
    ReadOptics("helios_water harbour\nNi 1.333\nhelios_attenuation 1\nhelios_backscatter 1e-3\n"
               "helios_meanSquareSlope 0.02\nhelios_optics water\n");
  CHECK(own == MaterialOptics{ OpticsKind::Water, 1.0, 1.333, 0.004, 1.0, 1e-3, 0.0, 250.0, 0.02 });
  CHECK(ReadOptics("helios_optics leaf\nhelios_transmittance 0.4\n").Transmittance == 0.4);
  const MaterialOptics sign =
    ReadOptics("helios_optics retroreflector\nhelios_retroreflection 70\n");
  CHECK(sign.Kind == OpticsKind::Retroreflector);
  CHECK(sign.Retroreflection == 70.0);
  CHECK(ReadOptics("helios_water coastal\n").Attenuation == 0.182);
}

TEST_CASE("MtlOptics: media whose index follows the wavelength", "[MtlOptics]")
{
  CHECK(ReadOptics("helios_optics pane\nhelios_dispersion sodaLime\n").Dispersion ==
    helios::DispersionKind::SodaLime);
  CHECK(ReadOptics("helios_water clear\nhelios_dispersion water\n").Dispersion ==
    helios::DispersionKind::Water);
  CheckError("helios_optics pane\nhelios_dispersion flint\n",
    ":3: helios_dispersion \"flint\" is unknown; give water, sodaLime, bk7 or silica, or the index "
    "as "
    "Ni");
}

TEST_CASE("MtlOptics: standard keys count only where they are asked for", "[MtlOptics]")
{
  CHECK(ReadOptics("illum 7\nNi 9\nd 0.1\n") == MaterialOptics());
  const MaterialOptics mirror = ReadOptics("helios_optics illum\nillum 5\nKs 0.9 0.9 0.6\n");
  CHECK(mirror.Kind == OpticsKind::Mirror);
  CHECK(mirror.MirrorReflectance == Approx(0.8));
  CHECK(ReadOptics("helios_optics illum\nillum 7\nNi 1.6\n").Kind == OpticsKind::Volume);
  CHECK(ReadOptics("helios_optics illum\nillum 4\n").Kind == OpticsKind::Pane);
  CHECK(ReadOptics("helios_optics illum\nillum 2\nd 0.3\n").Kind == OpticsKind::Pane);
  CHECK(ReadOptics("helios_optics illum\nillum 2\nd 1\n") == MaterialOptics());
}

TEST_CASE("MtlOptics: numbers without a kind have no effect, with a warning", "[MtlOptics]")
{
  TestFolder folder;
  const std::string path = folder.Write("a.mtl", "newmtl m\nNi 1.5\nhelios_thickness 0.01\n");
  ObjReading reading(folder.Write("a.obj", "mtllib a.mtl\n" + ObjSquare + "usemtl m\nf 1 2 3\n"));
  REQUIRE(reading.Read());
  CHECK(reading.Log->HasWarning(path +
    ":3: helios_thickness has no effect without helios_optics; "
    "add helios_optics with the kind, such as pane"));
  CHECK(reading.MaterialOf(0).Optics == MaterialOptics());
}

TEST_CASE("MtlOptics: a scene without them has no columns for them", "[MtlOptics]")
{
  TestFolder folder;
  folder.Write("a.mtl", "newmtl m\nNi 1.5\nd 0.5\nillum 6\n");
  ObjReading reading(folder.Write("a.obj", "mtllib a.mtl\n" + ObjSquare + "usemtl m\nf 1 2 3\n"));
  REQUIRE(reading.Read());
  CHECK_FALSE(reading.Scene()->GetFieldData()->HasArray(vtkHeliosArrayNames::MaterialOptics));
}

TEST_CASE("MtlOptics: the writer's file has the same optics", "[MtlOptics]")
{
  TestFolder folder;
  folder.Write("a.mtl",
    "newmtl m\nhelios_optics water\nNi 1.3\nhelios_thickness 0.1\nhelios_attenuation 0.3\n"
    "helios_backscatter 1e-3\nhelios_meanSquareSlope 0.01\nhelios_dispersion silica\n");
  ObjReading reading(folder.Write("a.obj", "mtllib a.mtl\n" + ObjSquare + "usemtl m\nf 1 2 3\n"));
  REQUIRE(reading.Read());
  vtkNew<vtkHeliosObjSceneWriter> writer;
  writer->SetInputData(reading.Scene());
  writer->SetFileName(folder.GetPath("b.obj").c_str());
  REQUIRE(writer->Write());
  ObjReading again(folder.GetPath("b.obj"));
  REQUIRE(again.Read());
  CHECK(again.MaterialOf(0) == reading.MaterialOf(0));
}

TEST_CASE("MtlOptics: errors", "[MtlOptics]")
{
  CheckError("helios_optics glas\n",
    ":2: helios_optics \"glas\" is unknown; give mirror, pane, volume, water, leaf, "
    "retroreflector, or illum for what illum and d mean");
  CheckError("helios_optics illum\n",
    ":2: helios_optics is illum, but the material has no illum and no d below 1; add one, or name "
    "its kind");
  CheckError("Ni 0.9\nhelios_optics pane\n", ":2: Ni \"0.9\" is not a number from 1 to 4");
  CheckError("helios_optics mirror\nhelios_mirrorReflectance much\n",
    ":3: helios_mirrorReflectance \"much\" is not a number from 0 to 1");
  CheckError("helios_optics pane\nhelios_thickness -1\n",
    ":3: helios_thickness \"-1\" is not a number from 0 to 10");
  CheckError("helios_optics volume\nhelios_attenuation nan\n",
    ":3: helios_attenuation \"nan\" is not a number from 0 to 1e+06");
  CheckError("helios_water muddy\n",
    ":2: helios_water \"muddy\" is unknown; give clear, coastal or harbour");
  CheckError("helios_optics pane\nhelios_water clear\n",
    ":3: helios_water is of helios_optics water only; remove one of them");
  CheckError("helios_optics illum\nillum 2\nd 2\n", ":4: d \"2\" is not a number from 0 to 1");
}
