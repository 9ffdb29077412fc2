// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Errors of the glTF reader on bad documents, with the JSON path of the value.
#include "heliosGltfTesting.h"
#include "vtkHeliosMemoryLimit.h"

#include <limits>

using helios::BadFile;
using namespace helios::gltf;

namespace
{

void Check(const std::vector<BadFile>& cases)
{
  helios::CheckErrors<vtkHeliosGLTFSceneReader>("a.gltf", cases);
}

std::string Replace(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

/// A tetrahedron, with accessors 0 (positions) and 1 (indices).
std::string MakeGood()
{
  return MakeTetrahedra("{\"mesh\":0}");
}

std::string Change(const std::string& from, const std::string& to)
{
  return Replace(MakeGood(), from, to);
}

/// A triangle of positions, and indices.
std::string MakeTriangle(
  const std::vector<float>& positions, const std::vector<std::uint16_t>& indices)
{
  Maker maker;
  const int points = maker.AddFloats(positions);
  return maker.MakeText(
    MakeMembers("{\"mesh\":0}", { MakePrimitive(points, maker.AddIndices(indices)) }));
}

std::string MakeInstances(
  const std::vector<float>& places, const std::vector<float>& turns, int components = 4)
{
  Maker maker;
  const int corners = maker.AddFloats(Corners);
  const std::string translation = std::to_string(maker.AddFloats(places));
  const std::string rotation = std::to_string(maker.AddFloats(turns, components));
  const std::string attributes =
    "{\"TRANSLATION\":" + translation + ",\"ROTATION\":" + rotation + "}";
  return maker.MakeText(MakeMembers(
    "{\"mesh\":0,\"extensions\":{\"EXT_mesh_gpu_instancing\":{\"attributes\":" + attributes + "}}}",
    { MakePrimitive(corners) }));
}

} // namespace

TEST_CASE("GLTFErrors: files that are no glTF 2.0", "[GLTFErrors]")
{
  Check({ { "", ":1: is not valid JSON at column 1" },
    { "[]", ": is JSON, but no object; check the name of the file" },
    { "{}", ": asset.version: is \"\", not 2.0; give a file of glTF 2.0, or export it again" },
    { Change("\"2.0\"", "\"1.0\""), ": asset.version: is \"1.0\", not 2.0" },
    { Change("\"scene\":0",
        "\"extensionsRequired\":[\"KHR_lights_punctual\",\"KHR_draco_mesh_"
        "compression\"]"),
      ": extensionsRequired[1]: \"KHR_draco_mesh_compression\" is not supported, and may change "
      "the geometry; export without it (without compression)" },
    { Change("\"scene\":0", "\"extensionsRequired\":[\"ACME_tubes\"]"),
      ": extensionsRequired[0]: \"ACME_tubes\" is not supported, and may change the geometry" },
    { Change("\"scene\":0", "\"extensionsRequired\":[\"EXT_texture_compression\"]"),
      ": extensionsRequired[0]: \"EXT_texture_compression\" is not supported" },
    { Change("\"scene\":0", "\"extensionsRequired\":[7]"),
      ": extensionsRequired[0]: 7 is not supported" } });
}

TEST_CASE("GLTFErrors: containers", "[GLTFErrors]")
{
  Maker maker;
  const std::string members =
    MakeMembers("{\"mesh\":0}", { MakePrimitive(maker.AddFloats(Corners)) });
  const std::string good = maker.MakeBinary(members);
  std::string old = good;
  old[4] = 1;
  Check({ { "glTF", ": its container is not of version 2; export glTF 2.0" },
    { old, ": its container is not of version 2" },
    { good.substr(0, 12), ": has no chunk of JSON; write it again" },
    { good.substr(0, 60), ": a chunk of " },
    { good.substr(0, good.size() - 4),
      ": a chunk of 48 bytes starts at byte " + std::to_string(good.size() - 48) +
        ", and 44 follow, so the file is cut off; copy or write it again" },
    { good.substr(0, good.size() - 56),
      ": buffers[0].uri: is missing, and the file has no binary chunk; write it again" } });
}

TEST_CASE("GLTFErrors: scenes and nodes", "[GLTFErrors]")
{
  Check({ { Change("\"scene\":0", "\"scene\":1"),
            ": scene: is 1, and scenes has 1 elements, counted from 0; correct the index" },
    { Change("{\"nodes\":[0]}", "{\"nodes\":[7]}"),
      ": scenes[0].nodes[0]: is 7, and nodes has 1 elements" },
    { MakeTetrahedra("{\"mesh\":2}"), ": nodes[0].mesh: is 2, and meshes has 1 elements" },
    { MakeTetrahedra("{\"mesh\":\"a\"}"), ": nodes[0].mesh: is \"a\", and meshes has 1" },
    { MakeTetrahedra("{\"children\":[1,-1]},{}"),
      ": nodes[0].children[1]: is -1, and nodes has 2 elements" },
    { MakeTetrahedra("{\"children\":[1]},{\"children\":[0]}"),
      ": nodes[0]: is reached twice, and a node has one parent at most; copy it, or remove one" },
    { MakeTetrahedra("{\"translation\":[1,2]}"),
      ": nodes[0].translation: is a list of 2, not 3 numbers; correct it" },
    { MakeTetrahedra("{\"matrix\":7}"), ": nodes[0].matrix: is 7, not 16 numbers; correct it" },
    { MakeTetrahedra("{\"rotation\":[0,0,0,0]}"),
      ": nodes[0].rotation: has no length; give a unit quaternion" },
    { MakeTetrahedra("{\"scale\":[1e200,1,1],\"children\":[1]},{\"scale\":[1e200,1,1]}"),
      ": nodes[1]: is moved to infinity; correct its matrix, or its parents'" },
    { Replace(MakeTriangle({ 0, 0, 0, 3e38F, 0, 0, 0, 1, 0 }, { 0, 1, 2 }), "{\"mesh\":0}",
        "{\"mesh\":0,\"scale\":[1e300,1,1]}"),
      ": nodes[0]: moves a vertex of its mesh to infinity; correct its matrix" } });
}

TEST_CASE("GLTFErrors: instances", "[GLTFErrors]")
{
  const std::string at = ": nodes[0].extensions.EXT_mesh_gpu_instancing.attributes";
  Check({ { MakeInstances({ 0, 0, 0, 1, 0, 0 }, { 0, 0, 0, 1 }),
            at + ".ROTATION: has 1 elements, and others have 2; write the file again" },
    { MakeInstances({ 0, 0, 0 }, { 0, 0, 0 }, 3),
      ": accessors[2].type: is \"VEC3\", and \"VEC4\" is needed here; correct it" },
    { MakeInstances({ 0, 0, 0 }, { 0, 0, 0, 0 }),
      at + ": instance 0 has no length of rotation, or is not finite; correct it" },
    { MakeInstances({ std::numeric_limits<float>::infinity(), 0, 0 }, { 0, 0, 0, 1 }),
      at + ": instance 0 has no length of rotation, or is not finite" } });
}

TEST_CASE("GLTFErrors: meshes", "[GLTFErrors]")
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::string at = ": meshes[0].primitives[0]";
  Check({ { Change("\"primitives\":[", "\"primitives\":3,\"other\":["),
            ": meshes[0].primitives: is 3, not a list of primitives; write the file again" },
    { Change("\"POSITION\":0", "\"NORMAL\":0"),
      at + ".attributes.POSITION: is missing; write the file again" },
    { Change("\"POSITION\":0", "\"POSITION\":4"),
      at + ".attributes.POSITION: is 4, and accessors has 2 elements, counted from 0" },
    { Change("\"indices\":1", "\"indices\":1,\"mode\":7"),
      at + ".mode: is 7, not one of 0 to 6; write the file again" },
    { Change("\"indices\":1", "\"indices\":1,\"mode\":-1"),
      at + ".mode: is -1, not a whole number of 0 or more; correct it" },
    { Change("\"indices\":1", "\"indices\":1,\"material\":0"),
      at + ".material: is 0, and materials has 0 elements" },
    { MakeTriangle({ 0, 0, 0, 1, 0, 0, 0, nan, 0 }, { 0, 1, 2 }),
      at + ".attributes.POSITION: vertex 2 is NaN or infinite; correct the vertex, or remove it" },
    { MakeTriangle({ 0, 0, 0, 1, 0, 0, 0, 1, 0 }, { 0, 1, 3 }),
      at + ".indices: element 2 is 3, and the primitive has 3 vertices, counted from 0; correct" },
    { MakeTriangle({ 0, 0, 0, 1, 0, 0, 0, 1, 0 }, { 0, 1, 2, 0 }),
      at + ": has 4 corners, not a multiple of three; write the file again" },
    { MakeTetrahedra("{\"mesh\":0}",
        ",\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,2,0,1]}}]"),
      ": materials[0].pbrMetallicRoughness.baseColorFactor: is a list of 4, not four numbers from "
      "0 to 1; correct it" } });
}

TEST_CASE("GLTFErrors: accessors", "[GLTFErrors]")
{
  const std::string positions = "\"componentType\":5126,\"count\":4,\"type\":\"VEC3\"";
  const auto change = [&positions](const std::string& to) { return Change(positions, to); };
  const auto sparse = [&positions](const std::string& to)
  { return Change(positions, positions + ",\"sparse\":{" + to + "}"); };
  Check({ { change("\"componentType\":5126,\"count\":4,\"type\":\"VEC2\""),
            ": accessors[0].type: is \"VEC2\", and \"VEC3\" is needed here; correct it" },
    { change("\"componentType\":5124,\"count\":4,\"type\":\"VEC3\""),
      ": accessors[0].componentType: is 5124, not one of 5120, 5121, 5122, 5123, 5125, 5126" },
    { change("\"componentType\":5126,\"count\":-4,\"type\":\"VEC3\""),
      ": accessors[0].count: is -4, not a whole number of 0 or more; correct it" },
    { change("\"componentType\":5126,\"count\":4000000000,\"type\":\"VEC3\""),
      ": accessors[0].count: is 4000000000, above 2147483647; split the file" },
    { change("\"componentType\":5126,\"count\":5,\"type\":\"VEC3\""),
      ": accessors[0]: 5 elements of 12 bytes, every 12 from byte 0, do not fit into the 48 bytes "
      "of their bufferView; write the file again" },
    { change(positions + ",\"byteOffset\":4"),
      ": accessors[0]: 4 elements of 12 bytes, every 12 from byte 4, do not fit into the 48" },
    { sparse("\"count\":5"),
      ": accessors[0].sparse.count: is 5, and the accessor has 4 elements; correct it" },
    { sparse("\"count\":1,\"indices\":{\"bufferView\":1}"),
      ": accessors[0].sparse.indices.componentType: is null, not one of 5120" },
    { sparse("\"count\":1,\"indices\":{\"bufferView\":9,\"componentType\":5123}"),
      ": accessors[0].sparse.indices.bufferView: is 9, and bufferViews has 2 elements" },
    { sparse("\"count\":1,\"indices\":{\"bufferView\":1,\"componentType\":5123}"),
      ": accessors[0].sparse.values.bufferView: is null, and bufferViews has 2 elements" },
    { sparse("\"count\":4,\"indices\":{\"bufferView\":0,\"componentType\":5125},"
             "\"values\":{\"bufferView\":0}"),
      ": accessors[0].sparse.indices: element 3 is not an index below 4; correct it" } });
}

TEST_CASE("GLTFErrors: buffers", "[GLTFErrors]")
{
  const std::string view = "\"buffer\":0,\"byteOffset\":0,\"byteLength\":48";
  const std::string data = "data:application/octet-stream;base64,";
  const auto uri = [](const std::string& text)
  {
    Maker maker;
    const int corners = maker.AddFloats(Corners);
    return maker.MakeJson(MakeMembers("{\"mesh\":0}", { MakePrimitive(corners) }), text);
  };
  Check({ { Change(view, "\"buffer\":3"),
            ": bufferViews[0].buffer: is 3, and buffers has 1 elements, counted from 0" },
    { Change(view, "\"buffer\":0,\"byteOffset\":0.5"),
      ": bufferViews[0].byteOffset: is 0.5, not a whole number of 0 or more; correct it" },
    { Change(view, "\"buffer\":0,\"byteOffset\":40,\"byteLength\":48"),
      ": bufferViews[0]: ends at byte 88, and buffers[0] has 72; correct byteOffset and "
      "byteLength" },
    { Change(view, view + ",\"byteStride\":8"),
      ": accessors[0]: 4 elements of 12 bytes, every 8 from byte 0, do not fit" },
    { Change("\"byteLength\":72", "\"byteLength\":73"),
      ": buffers[0]: has 72 bytes in place of byteLength 73, so it is cut off; copy or write it" },
    { uri("none.bin"), ": buffers[0].uri: " },
    { uri("https://a.org/a.bin"),
      ": buffers[0].uri: \"https://a.org/a.bin\" is not the name of a file beside the document" },
    { uri("data:text/plain,abc"),
      ": buffers[0].uri: \"data:text/plain,abc\" is not data in base64; write the file again" },
    { uri(data + "AAA"), ": buffers[0].uri: has 3 characters of base64, not a multiple of 4" },
    { uri(data + "A=!="), ": buffers[0].uri: has characters that are not base64" },
    { uri(data + "===="), ": buffers[0].uri: has 4 characters of base64, not" },
    { uri(data), ": buffers[0]: has 0 bytes in place of byteLength 48" },
    { Change("\"uri\":\"", "\"uri\":3,\"was\":\""),
      ": buffers[0].uri: is 3, not a text; correct it" } });
}

TEST_CASE("GLTFErrors: a missing buffer is named", "[GLTFErrors]")
{
  Maker maker;
  const int corners = maker.AddFloats(Corners);
  Reading reading(
    "a.gltf", maker.MakeJson(MakeMembers("{\"mesh\":0}", { MakePrimitive(corners) }), "none.bin"));
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError(reading.Path + ": buffers[0].uri: " + reading.Folder / "none.bin" +
    ": cannot be read: No such"));
}

TEST_CASE("GLTFErrors: skins are reported", "[GLTFErrors]")
{
  Reading reading("a.gltf", MakeTetrahedra("{\"mesh\":0}", ",\"skins\":[{\"joints\":[0]}]"));
  CHECK(reading.Read());
  CHECK(reading.Log->HasWarning(reading.Path +
    ": skins[0]: skins are not applied, so meshes are where their nodes are; apply them before "
    "export"));
}

TEST_CASE("GLTFErrors: primitives that share vertices need memory", "[GLTFErrors]")
{
  Maker maker;
  const int corners = maker.AddFloats(std::vector<float>(3 * 9999));
  std::string primitives = MakePrimitive(corners);
  for (int i = 1; i < 300; ++i)
  {
    primitives += "," + MakePrimitive(corners);
  }
  Reading reading("a.glb", maker.MakeBinary(MakeMembers("{\"mesh\":0}", { primitives })));
  vtkHeliosMemoryLimit::SetLimit(8.0 + vtkHeliosMemoryLimit::GetUsed());
  CHECK_FALSE(reading.Read());
  vtkHeliosMemoryLimit::SetLimit(0.0);
  CHECK(reading.Log->HasError("vertices and triangles of a mesh need about"));
}

TEST_CASE("GLTFErrors: copies need memory", "[GLTFErrors]")
{
  // A mesh of one triangle at more places than 32-bit cells can have.
  Maker maker;
  const int corners = maker.AddFloats({ 0, 0, 0, 1, 0, 0, 0, 1, 0 });
  std::vector<std::uint32_t> strip(100002);
  for (std::size_t i = 0; i < strip.size(); ++i)
  {
    strip[i] = i % 3;
  }
  const int indices = maker.AddIndices(strip);
  std::string nodes = "{\"children\":[1";
  std::string rest = ",{\"mesh\":0}";
  for (int i = 2; i <= 8000; ++i)
  {
    nodes += "," + std::to_string(i);
    rest += ",{\"mesh\":0}";
  }
  const std::string strips = MakePrimitive(corners, indices, ",\"mode\":5");
  Reading reading("a.glb", maker.MakeBinary(MakeMembers(nodes + "]}" + rest, { strips })));
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError(reading.Path +
    ": more than 715827882 triangles or 2147483647 vertices at all places; split the file"));
}
