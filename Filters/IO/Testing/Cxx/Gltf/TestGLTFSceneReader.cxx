// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// glTF documents as scenes: areas and volumes by formula.
#include "heliosGltfTesting.h"
#include "vtkHeliosMemoryLimit.h"

#include <cmath>

using helios::Material;
using helios::Vec3;
using namespace helios::gltf;

namespace
{

/// z up of a point of a document.
Vec3 TurnUp(double x, double y, double z)
{
  return { x, -z, y };
}

void CheckCorner(Reading& reading, vtkIdType triangle, int corner, const Vec3& expected)
{
  CHECK((reading.Corner(triangle, corner) - expected).Norm() < 1e-12);
}

/// The first square in the plane of x and y, four vertices as a list, strip and fan.
std::string MakeSquare(int mode)
{
  Maker maker;
  const std::vector<float> list = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0 };
  const std::vector<float> strip = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0 };
  const std::vector<float> fan = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 };
  const int points = maker.AddFloats(mode == 4 ? list : mode == 5 ? strip : fan);
  return maker.MakeText(MakeMembers(
    "{\"mesh\":0}", { MakePrimitive(points, -1, ",\"mode\":" + std::to_string(mode)) }));
}

} // namespace

TEST_CASE("GLTFSceneReader: text, container and separate buffer are the same", "[GLTFSceneReader]")
{
  Maker maker;
  const int corners = maker.AddFloats(Corners);
  const std::string members =
    MakeMembers("{\"mesh\":0}", { MakePrimitive(corners, maker.AddIndices(Faces)) });
  for (const std::string& bytes :
    { maker.MakeText(members), maker.MakeBinary(members), maker.MakeJson(members, "a%20b.bin") })
  {
    Reading reading("a.gltf", bytes);
    reading.Write("a b.bin", maker.Bytes);
    INFO(bytes);
    REQUIRE(reading.Read());
    CHECK(reading.Log->Warnings.empty());
    CHECK(reading.Triangles() == 4);
    CHECK(reading.Points() == 4);
    CHECK(reading.Volume() == Approx(1.0 / 6.0));
    CHECK(reading.Area() == Approx(1.5 + std::sqrt(0.75)));
    CheckCorner(reading, 1, 2, TurnUp(0, 0, 1));
    CHECK(reading.Scene()->GetPoints()->GetDataType() == VTK_DOUBLE);
    CHECK(reading.MaterialOf(0).Name == "default");
  }
}

TEST_CASE("GLTFSceneReader: indices of each type", "[GLTFSceneReader]")
{
  Maker maker;
  const int points = maker.AddFloats({ 0, 0, 0, 9, 9, 9, 1, 0, 0, 0, 1, 0 });
  const std::vector<std::string> primitives = { MakePrimitive(points,
                                                  maker.AddIndices<std::uint8_t>({ 0, 2, 3 })),
    MakePrimitive(points, maker.AddIndices<std::uint16_t>({ 0, 2, 3 })),
    MakePrimitive(points, maker.AddIndices<std::uint32_t>({ 0, 2, 3 })) };
  Reading reading("a.gltf",
    maker.MakeText(
      MakeMembers("{\"children\":[1,2,3]},{\"mesh\":0},{\"mesh\":1},{\"mesh\":2}", primitives)));
  REQUIRE(reading.Read());
  CHECK(reading.Triangles() == 3);
  CHECK(reading.Points() == 9); // unused vertices are dropped
  CHECK(reading.Area() == Approx(1.5));
}

TEST_CASE("GLTFSceneReader: lists, strips and fans face the same way", "[GLTFSceneReader]")
{
  for (const int mode : { 4, 5, 6 })
  {
    INFO(mode);
    Reading reading("a.gltf", MakeSquare(mode));
    REQUIRE(reading.Read());
    REQUIRE(reading.Triangles() == 2);
    CHECK(reading.Area() == Approx(1.0));
    for (const vtkIdType i : { 0, 1 })
    {
      const Vec3 a = reading.Corner(i, 0);
      const Vec3 normal = (reading.Corner(i, 1) - a).Cross(reading.Corner(i, 2) - a);
      CHECK(normal[1] == Approx(-1.0)); // z of the document
    }
  }
  Reading points("a.gltf", MakeSquare(0));
  REQUIRE(points.Read());
  CHECK(points.Triangles() == 0);
  CHECK(points.Log->HasWarning(": no triangles, so the scene is empty; add meshes of triangles"));
}

TEST_CASE("GLTFSceneReader: nodes move their meshes and children", "[GLTFSceneReader]")
{
  // 90 degrees about y, twice the size, and moved; below it a matrix of columns.
  const std::string nodes = "{\"translation\":[447422.999,5,7],\"rotation\":[0,0.5,0,0.5],"
                            "\"scale\":[2,2,3],\"mesh\":0,\"children\":[1]},"
                            "{\"matrix\":[1,0,0,0,0,2,0,0,0,0,1,0,10,20,30,1],\"mesh\":0}";
  Reading reading("a.gltf", MakeTetrahedra(nodes));
  REQUIRE(reading.Read());
  REQUIRE(reading.Triangles() == 8);
  CHECK(reading.Points() == 8);
  // p of the parent: (2 x, 2 y, 3 z), then x' = z, z' = -x.
  const auto move = [](double x, double y, double z)
  { return TurnUp(447422.999 + 3 * z, 5 + 2 * y, 7 - 2 * x); };
  CHECK((reading.Corner(0, 0) - move(0, 0, 0)).Norm() < 1e-9);
  CHECK((reading.Corner(0, 1) - move(0, 1, 0)).Norm() < 1e-9);
  CHECK((reading.Corner(0, 2) - move(1, 0, 0)).Norm() < 1e-9);
  CHECK((reading.Corner(1, 2) - move(0, 0, 1)).Norm() < 1e-9);
  CHECK((reading.Corner(4, 1) - move(10, 22, 30)).Norm() < 1e-9);
  CHECK((reading.Corner(5, 2) - move(10, 20, 31)).Norm() < 1e-9);
}

TEST_CASE("GLTFSceneReader: mirrored meshes face outside", "[GLTFSceneReader]")
{
  Reading reading("a.gltf", MakeTetrahedra("{\"mesh\":0,\"scale\":[-2,1,1]}"));
  REQUIRE(reading.Read());
  CHECK(reading.Volume() == Approx(2.0 / 6.0));
}

TEST_CASE("GLTFSceneReader: the up axis can be z", "[GLTFSceneReader]")
{
  Reading reading("a.gltf", MakeTetrahedra("{\"mesh\":0}"));
  CHECK(reading.Reader->GetUpAxis() == vtkHeliosGLTFSceneReader::UP_AXIS_Y);
  reading.Reader->SetUpAxisToZ();
  REQUIRE(reading.Read());
  CheckCorner(reading, 1, 2, Vec3(0, 0, 1));
}

TEST_CASE("GLTFSceneReader: instances of EXT_mesh_gpu_instancing", "[GLTFSceneReader]")
{
  Maker maker;
  const int corners = maker.AddFloats(Corners);
  const int faces = maker.AddIndices(Faces);
  const int places = maker.AddFloats({ 10, 0, 0, 20, 5, 0 });
  const float h = std::sqrt(0.5F);
  const int turns = maker.AddFloats({ 0, 0, 0, 1, 0, 0, h, h }, 4); // 90 degrees about z
  const int sizes = maker.AddFloats({ 1, 1, 1, 2, 2, 2 });
  const std::string node = "{\"mesh\":0,\"translation\":[0,0,100],\"extensions\":"
                           "{\"EXT_mesh_gpu_instancing\":{\"attributes\":{\"TRANSLATION\":" +
    std::to_string(places) + ",\"ROTATION\":" + std::to_string(turns) +
    ",\"SCALE\":" + std::to_string(sizes) + "}}}}";
  Reading reading("a.glb",
    maker.MakeBinary(MakeMembers(node, { MakePrimitive(corners, faces) }) +
      ",\"extensionsRequired\":[\"EXT_mesh_gpu_instancing\"]"));
  REQUIRE(reading.Read());
  REQUIRE(reading.Triangles() == 8);
  CheckCorner(reading, 0, 2, TurnUp(11, 0, 100));
  const Vec3 turned = TurnUp(20, 7, 100); // x becomes y
  CHECK((reading.Corner(4, 2) - turned).Norm() < 1e-6);
}

TEST_CASE("GLTFSceneReader: sparse accessors", "[GLTFSceneReader]")
{
  Maker maker;
  const int base = maker.AddView(ToBytes<float>({ 0, 0, 0, 9, 9, 9, 0, 1, 0 }));
  const auto sparse = [&maker](
                        const std::vector<std::uint8_t>& rows, const std::vector<float>& values)
  {
    return ",\"sparse\":{\"count\":" + std::to_string(rows.size()) +
      ",\"indices\":{\"bufferView\":" + std::to_string(maker.AddView(ToBytes(rows))) +
      ",\"componentType\":5121},\"values\":{\"bufferView\":" +
      std::to_string(maker.AddView(ToBytes(values))) + "}}";
  };
  const int replaced = maker.AddAccessor(base, 5126, 3, "VEC3", sparse({ 1 }, { 2, 0, 0 }));
  const int alone =
    maker.AddAccessor(-1, 5126, 3, "VEC3", sparse({ 1, 2 }, { 4, 0, 0, 0, 1, 0 })); // else zeros
  Reading reading("a.gltf",
    maker.MakeText(MakeMembers("{\"children\":[1,2]},{\"mesh\":0},{\"mesh\":1}",
      { MakePrimitive(replaced), MakePrimitive(alone) })));
  REQUIRE(reading.Read());
  REQUIRE(reading.Triangles() == 2);
  CheckCorner(reading, 0, 1, TurnUp(2, 0, 0));
  CheckCorner(reading, 1, 1, TurnUp(4, 0, 0));
  CheckCorner(reading, 1, 2, TurnUp(0, 1, 0));
}

TEST_CASE("GLTFSceneReader: positions of integers, with gaps", "[GLTFSceneReader]")
{
  Maker maker;
  const int view = maker.AddView(
    ToBytes<std::int16_t>({ 0, 0, 0, 7, 32767, 0, -32768, 7, 0, 16384, 0, 7 }), 8); // every 4th
  const int whole = maker.AddAccessor(view, 5122, 3, "VEC3");
  const int fractions = maker.AddAccessor(view, 5122, 3, "VEC3", ",\"normalized\":true");
  const int last = maker.AddAccessor(view, 5122, 2, "VEC3", ",\"byteOffset\":8");
  Reading reading("a.gltf",
    maker.MakeText(MakeMembers("{\"children\":[1,2]},{\"mesh\":0},{\"mesh\":1},{\"mesh\":2}",
                     { MakePrimitive(whole), MakePrimitive(fractions), MakePrimitive(last) }) +
      ",\"extensionsRequired\":[\"KHR_mesh_quantization\"]"));
  REQUIRE(reading.Read());
  REQUIRE(reading.Triangles() == 2);
  CheckCorner(reading, 0, 1, TurnUp(32767, 0, -32768));
  CheckCorner(reading, 1, 1, TurnUp(1, 0, -1));
  CheckCorner(reading, 1, 2, TurnUp(0, 16384 / 32767.0, 0));
}

TEST_CASE("GLTFSceneReader: materials", "[GLTFSceneReader]")
{
  Maker maker;
  const int points = maker.AddFloats({ 0, 0, 0, 1, 0, 0, 0, 1, 0 });
  const std::string materials =
    ",\"materials\":[{\"name\":\"leaf\",\"pbrMetallicRoughness\":{\"baseColorFactor\":"
    "[0.1,0.5,0.2,1]}},{\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.1,0.5,0.2,1],"
    "\"baseColorTexture\":{\"index\":0}}},{\"name\":\"wall\"}]";
  std::vector<std::string> primitives;
  for (const char* material : { ",\"material\":2", ",\"material\":0", ",\"material\":1", "" })
  {
    primitives.push_back(MakePrimitive(points, -1, material));
  }
  const std::string bytes = maker.MakeText(
    MakeMembers(
      "{\"children\":[1,2,3,4]},{\"mesh\":0},{\"mesh\":1},{\"mesh\":2},{\"mesh\":3}", primitives) +
    materials);
  Reading reading("a.gltf", bytes);
  REQUIRE(reading.Read());
  CHECK(reading.MaterialOf(0).Name == "wall");
  CHECK(std::isnan(reading.MaterialOf(0).Reflectance)); // not set
  CHECK(reading.MaterialOf(1).Name == "leaf");
  CHECK(reading.MaterialOf(1).Reflectance ==
    Approx(0.2126 * 0.1 + 0.7152 * 0.5 + 0.0722 * 0.2)); // weights of the luminance
  CHECK(reading.MaterialOf(2).Name == "material1");
  CHECK(std::isnan(reading.MaterialOf(2).Reflectance)); // the texture has the colour
  CHECK(reading.MaterialOf(3).Name == "default");
  reading.Reader->SetMaterialFileName(
    reading.Write("a.mtl", "newmtl leaf\nhelios_reflectance 0.4\nhelios_classification 5\n")
      .c_str());
  REQUIRE(reading.Read());
  CHECK(reading.MaterialOf(1).Reflectance == 0.4);
  CHECK(reading.MaterialOf(1).Classification == 5);
  CHECK(reading.MaterialOf(0).Name == "wall");
}

TEST_CASE("GLTFSceneReader: the default scene, the first, or all nodes", "[GLTFSceneReader]")
{
  const auto read = [](const std::string& scenes)
  {
    Maker maker;
    const int points = maker.AddFloats({ 0, 0, 0, 1, 0, 0, 0, 1, 0 });
    Reading reading("a.gltf",
      maker.MakeText(scenes +
        "\"nodes\":[{\"mesh\":0},{\"mesh\":0,\"scale\":[2,2,2],\"children\":[2]},{\"mesh\":0}],"
        "\"meshes\":[{\"primitives\":[" +
        MakePrimitive(points) + "]}]"));
    REQUIRE(reading.Read());
    return reading.Area();
  };
  const std::string scenes = "\"scenes\":[{\"nodes\":[0]},{\"nodes\":[1]},{}],";
  CHECK(read(scenes) == Approx(0.5));
  CHECK(read(scenes + "\"scene\":1,") == Approx(2.0 + 2.0));
  CHECK(read("") == Approx(0.5 + 2.0 + 2.0));
}

TEST_CASE("GLTFSceneReader: memory is checked before it is needed", "[GLTFSceneReader]")
{
  Reading reading("a.gltf", MakeTetrahedra("{\"mesh\":0}"));
  vtkHeliosMemoryLimit::SetLimit(0.0005);
  CHECK_FALSE(reading.Read());
  vtkHeliosMemoryLimit::SetLimit(0.0);
  CHECK(reading.Log->HasError("bytes of the file need about"));
}

TEST_CASE("GLTFSceneReader: reading can be aborted", "[GLTFSceneReader]")
{
  std::string nodes = "{\"children\":[1";
  std::string rest = ",{\"mesh\":0}";
  for (int i = 2; i <= 300; ++i)
  {
    nodes += "," + std::to_string(i);
    rest += ",{\"mesh\":0}";
  }
  Reading reading("a.gltf", MakeTetrahedra(nodes + "]}" + rest));
  reading.Reader->AddObserver(
    vtkCommand::ProgressEvent, reading.Reader.Get(), &vtkHeliosGLTFSceneReader::AbortExecuteOn);
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError(
    reading.Path + ": reading was aborted at mesh 256 of 300; update again to read it"));
}
