// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged OBJ files give an error or a complete scene.
#include "heliosObjMutations.h"

#include <catch2/catch.hpp>

TEST_CASE("ObjMutations: damaged files give an error or a whole scene", "[mutation]")
{
  helios::TestFolder folder;
  folder.Write("a.mtl", helios::GoodMtl);
  folder.Write("a.obj", helios::GoodObj);
  const int count = helios::GetNumberOfMutations();
  int sceneCount = 0;
  for (int seed = 0; seed < count; ++seed)
  {
    const std::string text = helios::MutateText(helios::GoodObj, static_cast<unsigned>(seed));
    folder.Write("a.obj", text);
    INFO("seed " << seed << '\n' << text);
    bool isScene = false;
    REQUIRE(helios::ReadMutation(folder.GetPath("a.obj"), isScene) == "");
    sceneCount += isScene;
  }
  CHECK(sceneCount > count / 20); // both occur
  CHECK(sceneCount < count - count / 20);
}
