// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Extensions that do not concern triangles, hidden nodes, weights of morph targets, transparency.
#include "heliosGltfTesting.h"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace helios;
using namespace helios::gltf;

namespace
{

/// A triangle with two morph targets, the second of which has no positions; nodes 0 and 1 have it.
std::string MakeMorphs(const std::string& node, const std::string& mesh, int moves = 3)
{
  Maker maker;
  const int points = maker.AddFloats({ 0, 0, 0, 1, 0, 0, 0, 1, 0 });
  std::vector<float> up;
  for (int i = 0; i < moves; ++i)
  {
    up.insert(up.end(), { 0.0F, 0.0F, i == 2 ? 4.0F : 2.0F });
  }
  const int target = maker.AddFloats(up);
  return maker.MakeText("\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":[{\"mesh\":0" + node +
    "},{\"mesh\":0,\"translation\":[10,0,0]}],\"meshes\":[{\"primitives\":[" +
    MakePrimitive(
      points, -1, ",\"targets\":[{\"POSITION\":" + std::to_string(target) + "},{\"NORMAL\":0}]") +
    "]" + mesh + "}]");
}

void CheckHeights(const std::string& text, double first, double second)
{
  Reading reading("a.gltf", text);
  reading.Reader->SetUpAxisToZ();
  INFO(text);
  REQUIRE(reading.Read());
  REQUIRE(reading.Triangles() == 2);
  CHECK(reading.Corner(0, 0)[2] == Approx(first));
  CHECK(reading.Corner(0, 2)[2] == Approx(2.0 * first));
  CHECK(reading.Corner(1, 0)[2] == Approx(second));
  CHECK(reading.Log->Warnings.empty());
}

void CheckMorphError(const std::string& text, const std::string& message)
{
  Reading reading("a.gltf", text);
  INFO(message);
  CHECK_FALSE(reading.Read());
  INFO("said: " << reading.Log->Errors);
  CHECK(reading.Log->HasError(reading.Path + message));
}

} // namespace

TEST_CASE("GLTFExtras: required extensions that change no triangle are read past", "[GLTFExtras]")
{
  for (const char* name : { "KHR_materials_unlit", "KHR_materials_variants",
         "KHR_texture_transform", "KHR_texture_basisu", "EXT_texture_webp", "KHR_lights_punctual",
         "EXT_lights_image_based", "KHR_xmp", "KHR_xmp_json_ld", "EXT_structural_metadata",
         "EXT_mesh_features", "EXT_instance_features", "EXT_feature_metadata",
         "CESIUM_primitive_outline", "KHR_animation_pointer", "KHR_node_visibility",
         "KHR_interactivity", "KHR_audio_emitter", "KHR_physics_rigid_bodies",
         "KHR_implicit_shapes", "MSFT_lod", "MSFT_packing_normalRoughnessMetallic",
         "ADOBE_materials_thin_transparency", "FB_ngon_encoding", "EXT_mesh_manifold", "VRMC_vrm" })
  {
    INFO(name);
    Reading reading("a.gltf",
      MakeTetrahedra("{\"mesh\":0}",
        std::string(",\"extensionsUsed\":[\"") + name + "\"],\"extensionsRequired\":[\"" + name +
          "\"]"));
    CHECK(reading.Read());
    CHECK(reading.Triangles() == 4);
    CHECK(reading.Log->Warnings.empty());
  }
}

TEST_CASE("GLTFExtras: extensions that are only used do not matter", "[GLTFExtras]")
{
  Reading reading("a.gltf",
    MakeTetrahedra(
      "{\"mesh\":0}", ",\"extensionsUsed\":[\"KHR_draco_mesh_compression\",\"ACME_any\"]"));
  CHECK(reading.Read());
  CHECK(reading.Triangles() == 4);
}

TEST_CASE("GLTFExtras: nodes that are not visible are left out with their children", "[GLTFExtras]")
{
  const std::string hidden = ",\"extensions\":{\"KHR_node_visibility\":{\"visible\":false}}";
  const std::string shown = ",\"extensions\":{\"KHR_node_visibility\":{\"visible\":true}}";
  const std::string plain = ",\"extensions\":{\"KHR_node_visibility\":{}}";
  const std::string required = ",\"extensionsRequired\":[\"KHR_node_visibility\"]";
  Reading some("a.gltf",
    MakeTetrahedra("{\"children\":[1,2,4]" + shown + "},{\"mesh\":0" + hidden +
        "},{\"mesh\":0,\"children\":[3]" + hidden + "},{\"mesh\":0" + shown +
        "},{\"mesh\":0,\"translation\":[5,0,0]" + plain + "}",
      required));
  REQUIRE(some.Read());
  REQUIRE(some.Triangles() == 4);
  CHECK(some.Corner(0, 0)[0] == 5.0);

  Reading bad("a.gltf",
    MakeTetrahedra(
      "{\"mesh\":0,\"extensions\":{\"KHR_node_visibility\":{\"visible\":\"no\"}}}", required));
  CHECK_FALSE(bad.Read());
  CHECK(bad.Log->HasError(bad.Path +
    ": nodes[0].extensions.KHR_node_visibility.visible: is \"no\", not true or false; correct it"));
}

TEST_CASE("GLTFExtras: default weights of morph targets are applied", "[GLTFExtras]")
{
  CheckHeights(MakeMorphs("", ""), 0.0, 0.0);
  CheckHeights(MakeMorphs("", ",\"weights\":[0,0]"), 0.0, 0.0);
  CheckHeights(MakeMorphs("", ",\"weights\":[0.5,1]"), 1.0, 1.0);
  CheckHeights(MakeMorphs(",\"weights\":[0.25,0]", ",\"weights\":[0.5,1]"), 0.5, 1.0);
  CheckHeights(MakeMorphs(",\"weights\":[1,0]", ""), 2.0, 0.0);
  CheckHeights(MakeMorphs(",\"weights\":[0,0]", ",\"weights\":[-1,0]"), 0.0, -2.0);
}

TEST_CASE("GLTFExtras: weights that do not fit are errors", "[GLTFExtras]")
{
  CheckMorphError(MakeMorphs(",\"weights\":7", ""),
    ": nodes[0].weights: is 7, not a list of finite numbers; correct it");
  CheckMorphError(MakeMorphs("", ",\"weights\":[1,\"a\"]"),
    ": meshes[0].weights: is a list of 2, not a list of finite numbers; correct it");
  CheckMorphError(MakeMorphs("", ",\"weights\":[1]"),
    ": meshes[0].primitives[0].targets: has 2 morph targets, and the mesh is placed with 1 "
    "weights; correct weights, or add targets");
  CheckMorphError(MakeMorphs("", ",\"weights\":[1,0]", 4),
    ": meshes[0].primitives[0].targets[0].POSITION: has 4 elements, and the primitive has 3 "
    "vertices; write the file again");
  std::string text = MakeMorphs("", ",\"weights\":[1,0]");
  text.replace(text.find("{\"POSITION\":1}"), 14, "{\"POSITION\":9}");
  CheckMorphError(
    text, ": meshes[0].primitives[0].targets[0].POSITION: is 9, and accessors has 2 elements");
}
