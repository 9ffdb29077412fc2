// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Surveys in a separate folder, and their readers.

#ifndef heliosSurveyFiles_h
#define heliosSurveyFiles_h

#include "heliosErrorObserver.h"
#include "heliosSurveyData.h"
#include "vtkHeliosSurvey.h"
#include "vtkHeliosSurveyReader.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace helios
{
namespace test
{

inline std::string ReadText(const std::string& path)
{
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline vtkSmartPointer<ErrorObserver> Observe(vtkObject* object)
{
  auto log = vtkSmartPointer<ErrorObserver>::Take(ErrorObserver::New());
  log->Watch(object);
  return log;
}

/// A folder with a scene, two scanners and two platforms; a test adds its survey.
class Files
{
public:
  Files()
  {
    std::string name = (std::filesystem::temp_directory_path() / "vtkHeliosSurveyXXXXXX").string();
    this->Folder = ::mkdtemp(name.data());
    this->Write("plane.obj", "v -50 -50 0\nv 50 -50 0\nv 50 50 0\nv -50 50 0\nf 1 2 3 4\n");
    this->Write("scene.xml", R"(<document><scene id="s"><part id="floor">
<filter type="objloader"><param type="string" key="filepath" value="plane.obj"/></filter>
</part></scene></document>)");
    this->Write("assets.xml", R"(<document>
<platform id="tripod" type="static"><scannerMount x="0" y="0" z="1.5"/></platform>
<platform id="plane" type="linearpath"><scannerMount z="0.7">
<rot axis="x" angle_deg="-90"/><rot axis="z" angle_deg="90"/></scannerMount></platform>
<scanner id="tls" optics="rotating" accuracy_m="0.005" beamDivergence_rad="0.0004"
 headRotatePerSecMax_deg="60" pulseFreqs_Hz="100000, 300000" pulseLength_ns="5" rangeMin_m="0.5"
 receivedEnergyMin_W="0.002" scanAngleMax_deg="120" scanAngleEffectiveMax_deg="50"
 scanFreqMin_Hz="3" scanFreqMax_Hz="120"><FWFSettings beamSampleQuality="2"/>
<beamOrigin x="0" y="0" z="0.2"/></scanner>
<scanner id="als" optics="conic" pulseFreqs_Hz="200000" scanAngleMax_deg="20" scanFreqMax_Hz="80"/>
</document>)");
  }
  ~Files() { std::filesystem::remove_all(this->Folder); }
  Files(const Files&) = delete;
  void operator=(const Files&) = delete;

  void Write(const std::string& name, const std::string& text) const
  {
    std::filesystem::create_directories((this->Folder / name).parent_path());
    std::ofstream(this->Folder / name, std::ios::binary) << text;
  }

  /// Replaces the first occurrence of a text in a file, which must contain it.
  void Replace(const std::string& name, const std::string& from, const std::string& to) const
  {
    std::string text = ReadText(*this / name);
    const std::size_t at = text.find(from);
    INFO(name << " has no " << from);
    REQUIRE(at != std::string::npos);
    this->Write(name, text.replace(at, from.size(), to));
  }

  std::string operator/(const std::string& name) const { return (this->Folder / name).string(); }

private:
  std::filesystem::path Folder;
};

/// A reader of survey.xml, which is written first if its content is given.
struct Reading
{
  vtkNew<vtkHeliosSurveyReader> Reader;
  vtkSmartPointer<ErrorObserver> Log = Observe(Reader);
  bool Good;

  explicit Reading(const Files& files)
  {
    this->Reader->SetFileName((files / "survey.xml").c_str());
    this->Good = this->Reader->Read();
  }

  Reading(const Files& files, const std::string& attributes, const std::string& inside)
    : Reading(WriteSurvey(files, attributes, inside))
  {
  }

  const SurveyData& Data() const { return this->Reader->GetSurvey()->GetData(); }

private:
  /// The content before the first leg goes before the survey.
  static const Files& WriteSurvey(
    const Files& files, const std::string& attributes, const std::string& inside)
  {
    const std::size_t legs = std::min(inside.find("<leg"), inside.size());
    files.Write("survey.xml",
      "<?xml version=\"1.0\"?>\n<document>\n" + inside.substr(0, legs) +
        "<survey name=\"test\" scene=\"scene.xml#s\" " + attributes + ">\n" + inside.substr(legs) +
        "\n</survey></document>");
    return files;
  }
};

inline const char* const Tripod = R"(platform="assets.xml#tripod" scanner="assets.xml#tls")";
inline const char* const Flight = R"(platform="assets.xml#plane" scanner="assets.xml#als")";

/// A tripod with a head rotation of 10 degrees.
inline const char* const OneLeg = R"(<leg><platformSettings x="1" y="2" z="3"/>
<scannerSettings scanFreq_hz="50" headRotatePerSec_deg="10" headRotateStop_deg="10"/></leg>)";

/// A flight of 20 m in two legs of 40,000 pulses, and its end point.
inline const char* const ThreeLegs =
  R"(<leg><platformSettings x="0" z="100" movePerSec_m="50"/>
<scannerSettings scanFreq_hz="50" scanAngle_deg="5"/></leg>
<leg><platformSettings x="10" z="100" movePerSec_m="50"/>
<scannerSettings scanFreq_hz="50" scanAngle_deg="5"/></leg>
<leg><platformSettings x="20" z="100" movePerSec_m="50"/>
<scannerSettings scanFreq_hz="50" scanAngle_deg="5" active="false"/></leg>)";

} // namespace test
} // namespace helios

#endif
