// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Animations of glTF: interpolation of keys, and errors. Poses are compared in numpy, too
// (Python/tests/scenes/test_gltf_animation.py).
#include "heliosGltfTesting.h"

#include <cmath>
#include <functional>

using namespace helios::gltf;

namespace
{

/// A tetrahedron that is moved by an animation of some interpolation and values of its translation.
struct Animated
{
  std::string Interpolation = "LINEAR";
  std::string Node = "{\"mesh\":0}";
  std::string More;      ///< more of the document
  std::string Primitive; ///< more attributes of the primitive
  std::string Target = "{\"node\":0,\"path\":\"translation\"}";
  std::vector<float> Times = { 0.0f, 1.0f, 3.0f };
  std::vector<float> Values = { 0, 0, 0, 1, 0, 0, 1, 4, 0 };

  std::string Make() const
  {
    Maker maker;
    const int corners = maker.AddFloats(Corners);
    const int faces = maker.AddIndices(Faces);
    const int times = maker.AddFloats(this->Times, 1);
    const int values = maker.AddFloats(this->Values);
    return maker.MakeText("\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[" + this->Node +
      "],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" + std::to_string(corners) +
      this->Primitive + "},\"indices\":" + std::to_string(faces) + "}]}]," + this->More +
      "\"animations\":[{\"name\":\"go\",\"channels\":[{\"sampler\":0,\"target\":" + this->Target +
      "}],\"samplers\":[{\"input\":" + std::to_string(times) + ",\"output\":" +
      std::to_string(values) + ",\"interpolation\":\"" + this->Interpolation + "\"}]}]");
  }
};

/// Returns the first point at a time, in the axes of the document.
helios::Vec3 GetFirst(Reading& reading, double time)
{
  reading.Reader->SetAnimationTime(time);
  REQUIRE(reading.Read());
  const double* p = reading.Reader->GetOutput()->GetPoint(0);
  return { p[0], p[2], -p[1] };
}

} // namespace

TEST_CASE("GLTFAnimation: keys are interpolated as the file says", "[GLTFAnimation]")
{
  Animated model;
  SECTION("linearly")
  {
    Reading reading("a.gltf", model.Make());
    reading.Reader->SetAnimation("go");
    CHECK(GetFirst(reading, 0.25) == helios::Vec3(0.25, 0, 0));
    CHECK(reading.Reader->GetAnimationDuration() == 3.0);
    CHECK(GetFirst(reading, 1.0) == helios::Vec3(1, 0, 0));
    CHECK(GetFirst(reading, 1.5) == helios::Vec3(1, 1, 0));
    CHECK(GetFirst(reading, 9.0) == helios::Vec3(1, 4, 0));
    CHECK(reading.Reader->GetOutput()->GetNumberOfPolys() == 4);
  }
  SECTION("by steps")
  {
    model.Interpolation = "STEP";
    Reading reading("a.gltf", model.Make());
    reading.Reader->SetAnimation("0");
    CHECK(GetFirst(reading, 0.99) == helios::Vec3(0, 0, 0));
    CHECK(GetFirst(reading, 1.0) == helios::Vec3(1, 0, 0));
  }
  SECTION("by cubic splines: x = t^3")
  {
    model.Interpolation = "CUBICSPLINE";
    model.Times = { 1.0f, 3.0f };
    model.Values = { 0, 0, 0, 1, 0, 0, 3, 0, 0, 27, 0, 0, 27, 0, 0, 0, 0, 0 };
    Reading reading("a.gltf", model.Make());
    reading.Reader->SetAnimation("go");
    for (const double t : { 1.0, 1.3, 2.0, 2.9 })
    {
      CHECK(GetFirst(reading, t)[0] == Approx(t * t * t).epsilon(1e-12));
    }
    CHECK(GetFirst(reading, 0.5)[0] == 1.0);
  }
}

TEST_CASE("GLTFAnimation: bad animations and skins are errors", "[GLTFAnimation]")
{
  struct Row
  {
    std::function<void(Animated&)> Change;
    const char* Animation;
    std::string Message;
  };
  const auto skin = [](Animated& a)
  {
    a.Node = "{\"mesh\":0,\"skin\":0}";
    a.More = "\"skins\":[{\"joints\":[0]}],";
  };
  const Row row = GENERATE_COPY(
    Row{
      [](Animated&) {}, "run", "a.gltf: animations: no animation \"run\"; the file has 0 \"go\"" },
    Row{ [](Animated&) {}, "1", "animations: no animation \"1\"; the file has 0 \"go\"" },
    Row{ [](Animated& a) { a.Target = "{\"node\":3,\"path\":\"scale\"}"; }, "go",
      "animations[0].channels[0].target.node" },
    Row{ [](Animated& a) { a.Target = "{\"path\":\"scale\"}"; }, "go",
      "animations[0].channels: none of them moves a node; give another animation" },
    Row{ [](Animated& a) { a.Node = "{\"mesh\":0,\"matrix\":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}"; },
      "go", "channels[0].target: moves nodes[0], which has a matrix; give it translation" },
    Row{ [](Animated& a) { a.Interpolation = "SMOOTH"; }, "go",
      "animations[0].samplers[0].interpolation: is \"SMOOTH\", not LINEAR, STEP or CUBICSPLINE" },
    Row{ [](Animated& a) {
          a.Times = { 0.0f, 2.0f, 2.0f };
        },
      "go", "animations[0].samplers[0].input: has times that do not ascend from 0 or above" },
    Row{ [](Animated& a) { a.Values.resize(6); }, "go",
      "animations[0].samplers[0].output: has 6 numbers for 3 times" },
    Row{ skin, "go",
      "meshes[0].primitives[0].attributes.JOINTS_0: is missing, but a skin moves the mesh; paint" },
    Row{ [skin](Animated& a)
      {
        skin(a);
        a.Primitive = ",\"JOINTS_0\":0";
      },
      "go", "accessors[0].type: is \"VEC3\", and \"VEC4\" is needed here" },
    Row{ [skin](Animated& a)
      {
        skin(a);
        a.More = "\"skins\":[{\"joints\":[]}],";
      },
      "go", "skins[0].joints: has no joints; write the file again" });
  Animated model;
  row.Change(model);
  Reading reading("a.gltf", model.Make());
  reading.Reader->SetAnimation(row.Animation);
  CHECK_FALSE(reading.Read());
  INFO(reading.Log->Errors << "\nexpected: " << row.Message);
  CHECK(reading.Log->HasError(row.Message));
}

TEST_CASE("GLTFAnimation: a file without an animation is an error", "[GLTFAnimation]")
{
  const std::string key = "\"animations\"";
  std::string text = Animated().Make();
  Reading reading("a.gltf", text.replace(text.find(key), key.size(), "\"extras\""));
  reading.Reader->SetAnimation("go");
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError("a.gltf: animations: the file has no animation; give one that has"));
}

TEST_CASE("GLTFAnimation: all triangles are kept, with or without area", "[GLTFAnimation]")
{
  Animated model;
  model.Target = "{\"node\":0,\"path\":\"scale\"}";
  model.Values = { 0, 0, 0, 1, 1, 1, 1, 1, 1 };
  Reading reading("a.gltf", model.Make());
  reading.Reader->SetAnimation("go");
  reading.Reader->SetKeepAll(true);
  CHECK(GetFirst(reading, 0.0) == helios::Vec3(0, 0, 0));
  CHECK(reading.Reader->GetOutput()->GetNumberOfPolys() == 4);
  CHECK(reading.Reader->GetOutput()->GetNumberOfPoints() == 4);
  CHECK(reading.Reader->GetNumberOfFaces() == 4);
}
