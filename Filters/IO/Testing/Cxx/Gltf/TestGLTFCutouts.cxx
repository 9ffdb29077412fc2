// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Materials of glTF documents that are cut or blended.
#include "heliosGltfTesting.h"
#include "heliosMaskMaking.h"
#include "heliosMaterialTable.h"

#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkPolyData.h>
#include <vtkTriangle.h>

#include <catch2/catch.hpp>

#include <map>
#include <string>

using helios::MakeMask;
using helios::MaskImage;
using helios::Material;
using helios::OpticsKind;
using helios::gltf::EncodeBase64;
using helios::gltf::MakePrimitive;
using helios::gltf::Maker;
using helios::gltf::Reading;

namespace
{

const std::vector<float> Square = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 };
const std::vector<float> Textures = { 0, 1, 1, 1, 1, 0, 0, 0 }; // v downward
const std::vector<std::uint16_t> Faces = { 0, 1, 2, 0, 2, 3 };

/// Opaque in the lower left quarter, but for a margin.
MaskImage MakeQuarter()
{
  return MakeMask(64, 64, [](double x, double y) { return x < 32 && y < 32 ? 1.0 : 0.0; });
}

/// A square of a material with an image, which is in the document as a view or as text.
struct Card
{
  std::string Image; // bytes
  std::string Sampler;
  std::vector<float> Places = Textures;
  bool IsEmbedded = true;
  bool HasTexture = true;

  std::string MakeText(const std::string& material) const
  {
    Maker maker;
    const int corners = maker.AddFloats(Square);
    const int places = maker.AddFloats(this->Places, 2);
    const int faces = maker.AddIndices(Faces);
    const int view = maker.AddView(this->Image);
    std::string primitive = MakePrimitive(corners, faces, ",\"material\":0");
    const std::string end = ",\"TEXCOORD_0\":" + std::to_string(places) + "}";
    primitive.replace(primitive.find('}'), 1, this->HasTexture ? end : "}");
    return maker.MakeText(helios::gltf::MakeMembers("{\"mesh\":0}", { primitive }) +
      ",\"materials\":[{\"name\":\"leaf\"," + material + "}],\"textures\":[{\"source\":0" +
      (this->Sampler.empty() ? "" : ",\"sampler\":0") + "}],\"samplers\":[{" + this->Sampler +
      "}],\"images\":[{" +
      (this->IsEmbedded ? "\"bufferView\":" + std::to_string(view)
                        : "\"uri\":\"data:image/png;base64," + EncodeBase64(this->Image) + "\"") +
      "}]");
  }
};

const std::string Mask =
  "\"alphaMode\":\"MASK\",\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}";

/// Returns the area of the triangles by material.
std::map<int, double> ComputeAreas(vtkPolyData* scene)
{
  std::map<int, double> areas;
  vtkDataArray* ids = scene->GetCellData()->GetArray("MaterialIds");
  for (vtkIdType i = 0; i < scene->GetNumberOfCells(); ++i)
  {
    vtkNew<vtkIdList> corners;
    scene->GetCellPoints(i, corners);
    double p[3][3];
    for (int k = 0; k < 3; ++k)
    {
      scene->GetPoint(corners->GetId(k), p[k]);
    }
    areas[static_cast<int>(ids->GetComponent(i, 0))] += vtkTriangle::TriangleArea(p[0], p[1], p[2]);
  }
  return areas;
}

std::map<int, double> ReadAreas(const std::string& text, const std::string& warning = "")
{
  Reading reading("a.gltf", text);
  REQUIRE(reading.Read());
  INFO("said: " << reading.Log->Warnings);
  CHECK(warning.empty() == reading.Log->Warnings.empty());
  CHECK((warning.empty() || reading.Log->HasWarning(warning)));
  return ComputeAreas(reading.Scene());
}

} // namespace

TEST_CASE("GLTFCutouts: MASK leaves the place of the texture", "[GLTFCutouts]")
{
  Card card{ helios::FormatPng(MakeQuarter(), 4), "" };
  for (const bool isEmbedded : { true, false })
  {
    card.IsEmbedded = isEmbedded;
    Reading reading("a.gltf", card.MakeText(Mask));
    REQUIRE(reading.Read());
    vtkPolyData* scene = reading.Scene();
    CHECK(ComputeAreas(scene)[0] == Approx(0.25).epsilon(2e-3));
    double bounds[6];
    scene->GetBounds(bounds); // y is up: the square stands, and v is downward
    CHECK(bounds[0] == Approx(0.0).margin(1e-6));
    CHECK(bounds[1] == Approx(0.5).epsilon(0.02));
    CHECK(bounds[4] == Approx(0.0).margin(1e-6));
    CHECK(bounds[5] == Approx(0.5).epsilon(0.02));
  }
}

TEST_CASE("GLTFCutouts: threshold and factor", "[GLTFCutouts]")
{
  const Card card{
    helios::FormatPng(MakeMask(64, 64, [](double x, double) { return x / 64.0; }), 4), ""
  };
  const auto read = [&](const std::string& more, const std::string& factor)
  {
    return ReadAreas(card.MakeText("\"alphaMode\":\"MASK\"" + more +
      ",\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0},\"baseColorFactor\":[1,1,1," +
      factor + "]}"))[0];
  };
  CHECK(read("", "1") == Approx(0.5).epsilon(0.01));
  CHECK(read(",\"alphaCutoff\":0.25", "1") == Approx(0.75).epsilon(0.01));
  CHECK(read(",\"alphaCutoff\":0.25", "0.5") == Approx(0.5).epsilon(0.01));
}

TEST_CASE("GLTFCutouts: BLEND makes leaves that transmit the rest", "[GLTFCutouts]")
{
  const Card card{
    helios::FormatPng(MakeMask(64, 64, [](double x, double) { return x < 32 ? 0.25 : 1.0; }), 4), ""
  };
  Reading reading("a.gltf",
    card.MakeText(
      "\"alphaMode\":\"BLEND\",\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}"));
  REQUIRE(reading.Read());
  const helios::MaterialTable materials = helios::GetMaterials(reading.Scene());
  double light = 0.0;
  double area = 0.0;
  for (const auto& [row, part] : ComputeAreas(reading.Scene()))
  {
    const Material& material = materials[static_cast<std::size_t>(row)];
    const double opacity = row == 0 ? 1.0 : 1.0 - material.Optics.Transmittance;
    CHECK((row == 0 || material.Optics.Kind == OpticsKind::Leaf));
    CHECK((row == 0 || material.Reflectance == Approx(0.5 * opacity)));
    light += opacity * part;
    area += part;
  }
  CHECK(area == Approx(1.0).epsilon(2e-3));
  CHECK(light == Approx(0.5 * (0.25 + 1.0)).epsilon(0.01));
  CHECK(materials[1].Name == "leaf (opacity 0.251)");
}

TEST_CASE("GLTFCutouts: opacity of a factor alone", "[GLTFCutouts]")
{
  const Card card{ helios::FormatPng(MakeQuarter(), 4), "" };
  const auto make = [&](const std::string& mode, const std::string& factor)
  {
    return card.MakeText("\"alphaMode\":\"" + mode +
      "\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,1,1," + factor + "]}");
  };
  CHECK(ReadAreas(make("OPAQUE", "0.2"))[0] == Approx(1.0));
  CHECK(ReadAreas(make("MASK", "0.2"), "no triangles, so the scene is empty").empty());
  CHECK(ReadAreas(make("MASK", "0.7"))[0] == Approx(1.0));
  CHECK(ReadAreas(make("BLEND", "1"))[0] == Approx(1.0));
  CHECK(ReadAreas(make("BLEND", "0.2"))[1] == Approx(1.0));
}

TEST_CASE("GLTFCutouts: samplers repeat, mirror and end", "[GLTFCutouts]")
{
  Card card{ helios::FormatPng(MakeQuarter(), 4), "" };
  card.Places = { 0, 1, 2, 1, 2, 0, 0, 0 }; // twice in u
  CHECK(ReadAreas(card.MakeText(Mask))[0] == Approx(0.25).epsilon(2e-3));
  card.Sampler = "\"wrapS\":33648";
  CHECK(ReadAreas(card.MakeText(Mask))[0] == Approx(0.25).epsilon(2e-3));
  card.Sampler = "\"wrapS\":33071";
  CHECK(ReadAreas(card.MakeText(Mask),
          "scanned as opaque: the texture repeats more than 4096 times over a triangle, or ends "
          "within it")[0] == Approx(1.0));
}

TEST_CASE("GLTFCutouts: what cannot be cut is opaque, and named", "[GLTFCutouts]")
{
  Card card{ helios::FormatPng(MakeQuarter(), 4), "" };
  const std::string start = ": materials[0].alphaMode: MASK of material \"leaf\" is not applied: 2 "
                            "triangles, 1 m2, of 1 material is scanned as opaque: ";
  const auto check = [&](const std::string& text, const std::string& fault)
  {
    INFO(fault);
    CHECK(ReadAreas(text, fault)[0] == Approx(1.0));
  };
  std::string text = card.MakeText(Mask);
  check(std::string(text).replace(text.find("\"index\":0"), 9, "\"index\":7"),
    ".pbrMetallicRoughness.baseColorTexture.index: is 7, and textures has 1 elements");
  check(std::string(text).replace(text.find("\"source\":0"), 10, "\"source\":7"),
    "textures[0].source: is 7, and images has 1 elements");
  check(std::string(text).replace(
          text.find("\"index\":0"), 9, "\"index\":0,\"extensions\":{\"KHR_texture_transform\":{}}"),
    "KHR_texture_transform is not read; apply it before export");
  card.HasTexture = false;
  check(card.MakeText(Mask), start + "they have no texture coordinates");
  card.HasTexture = true;
  card.Image = "no image";
  check(card.MakeText(Mask), start);
  card.IsEmbedded = false;
  check(
    card.MakeText(Mask), "images[0] is no image that is read; give PNG, JPEG, TIFF, BMP or PNM");
}

TEST_CASE("GLTFCutouts: a spectrum or optics of its own are cut, not blended", "[GLTFCutouts]")
{
  const MaskImage mask = MakeMask(64, 64, [](double x, double) { return x < 16 ? 0.25 : 1.0; });
  const Card card{ helios::FormatPng(mask, 4), "" };
  const std::string text = card.MakeText(
    "\"alphaMode\":\"BLEND\",\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}");
  const auto check = [&](const std::string& line, const std::string& has)
  {
    Reading reading("a.gltf", text);
    reading.Reader->SetMaterialFileName(
      reading.Write("a.mtl", "newmtl leaf\n" + line + "\n").c_str());
    REQUIRE(reading.Read());
    INFO(reading.Log->Warnings);
    CHECK(reading.Log->HasWarning("materials[0].alphaMode: BLEND of material \"leaf\": its opacity "
                                  "is cut at 0.5, as the material has " +
      has + "; give it a reflectance to blend it"));
    CHECK(ComputeAreas(reading.Scene())[0] == Approx(0.75).epsilon(5e-3));
  };
  check("helios_spectra grass", "a spectrum");
  check("helios_optics mirror", "optics of its own");
}
