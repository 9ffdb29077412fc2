// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged glTF documents give an error or a valid scene.
#include "heliosGltfTesting.h"

using namespace helios::gltf;

namespace
{

/// A document with all that is read: nodes, instances, a sparse accessor, strips, materials.
Maker MakeParts(std::string& members)
{
  Maker maker;
  const int corners = maker.AddFloats(Corners);
  const int faces = maker.AddIndices(Faces);
  const int places = maker.AddFloats({ 10, 0, 0, 20, 5, 0 });
  const int rows = maker.AddView(ToBytes<std::uint8_t>({ 1 }));
  const int values = maker.AddView(ToBytes<float>({ 2, 0, 0 }));
  const int sparse = maker.AddAccessor(0, 5126, 4, "VEC3",
    ",\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":" + std::to_string(rows) +
      ",\"componentType\":5121},\"values\":{\"bufferView\":" + std::to_string(values) + "}}");
  members =
    MakeMembers(
      "{\"children\":[1,2],\"rotation\":[0,0.5,0,0.5]},{\"mesh\":0,\"extensions\":{\"EXT_mesh_gpu_"
      "instancing\":{\"attributes\":{\"TRANSLATION\":" +
        std::to_string(places) + "}}}},{\"mesh\":1,\"translation\":[1,2,3]}",
      { MakePrimitive(corners, faces, ",\"material\":0"),
        MakePrimitive(sparse, -1, ",\"mode\":5") }) +
    ",\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.1,0.5,0.2,1]}}]";
  return maker;
}

} // namespace

TEST_CASE("GLTFMutations: damaged files give an error or a valid scene", "[mutation]")
{
  std::string members;
  const Maker maker = MakeParts(members);
  helios::CheckMutations<vtkHeliosGLTFSceneReader>(
    "a.gltf", { maker.MakeText(members), maker.MakeBinary(members) });
}

TEST_CASE("GLTFMutations: changed numbers give an error or a valid scene", "[mutation]")
{
  std::string members;
  const std::string good = MakeParts(members).MakeText(members);
  for (int seed = 0; seed < helios::GetNumberOfMutations(); ++seed)
  {
    INFO("seed " << seed);
    Reading reading("a.gltf", helios::Mutator(static_cast<unsigned>(seed)).ChangeNumber(good));
    if (reading.Read())
    {
      helios::CheckScene(reading);
    }
  }
}
