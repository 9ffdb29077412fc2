// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A survey for the viewer's tests: a flight of 1 s over a 2 m step.

#ifndef heliosStepFiles_h
#define heliosStepFiles_h

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace helios::viewer
{

constexpr double StepHeight = 2.0; // [m]

/// A folder with the survey; beams of 5 mrad are 0.5 m wide on the ground.
class StepFiles
{
public:
  StepFiles()
  {
    std::string name =
      (std::filesystem::temp_directory_path() / "vtkHeliosInspectorXXXXXX").string();
    this->Folder = ::mkdtemp(name.data());
    this->Write("ground.obj", "v -60 -60 0\nv 60 -60 0\nv 60 60 0\nv -60 60 0\nf 1 2 3 4\n");
    this->Write("plate.obj", "v -60 0 2\nv 60 0 2\nv 60 60 2\nv -60 60 2\nf 1 2 3 4\n");
    this->Write("scene.xml", R"(<document><scene id="s"><part id="ground">
<filter type="objloader"><param type="string" key="filepath" value="ground.obj"/></filter></part>
<part id="plate"><filter type="objloader"><param type="string" key="filepath" value="plate.obj"/>
</filter></part></scene></document>)");
    this->Write("assets.xml", R"(<document>
<platform id="plane" type="linearpath"><scannerMount>
<rot axis="x" angle_deg="-90"/><rot axis="z" angle_deg="90"/></scannerMount></platform>
<scanner id="als" optics="rotating" accuracy_m="0" beamDivergence_rad="0.005" pulseFreqs_Hz="2000"
 pulseLength_ns="4" scanAngleMax_deg="10" scanAngleEffectiveMax_deg="10" scanFreqMin_Hz="1"
 scanFreqMax_Hz="100"/></document>)");
    this->Write("survey.xml", R"(<document><survey name="step" scene="scene.xml#s"
 platform="assets.xml#plane" scanner="assets.xml#als">
<leg><platformSettings x="-10" y="0" z="100" movePerSec_m="20"/>
<scannerSettings active="true" pulseFreq_hz="2000" scanFreq_hz="10" scanAngle_deg="5"/></leg>
<leg><platformSettings x="10" y="0" z="100" movePerSec_m="20"/>
<scannerSettings active="false"/></leg></survey></document>)");
  }
  ~StepFiles() { std::filesystem::remove_all(this->Folder); }

  void Write(const std::string& name, const std::string& text) const
  {
    std::ofstream(this->Folder / name) << text;
  }

  /// Replaces the first occurrence of a required text in a file.
  void Replace(const std::string& name, const std::string& from, const std::string& to) const
  {
    std::ifstream file(this->Folder / name);
    std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    this->Write(name, text.replace(text.find(from), from.size(), to)); // throws if missing
  }

  std::filesystem::path Folder;
};

} // namespace helios::viewer

#endif
