// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Every stored attribute of the dialect: read from a file and set by a method, it is the same.
#include "heliosXmlRules.h"

#include "heliosSurveyFiles.h"

#include <catch2/catch.hpp>

#include <map>
#include <string>
#include <vector>

using namespace helios;
using namespace helios::test;

namespace
{

/// The elements of a kind of attributes, the first of which has most.
const std::map<std::string, std::vector<std::string>> Elements = {
  { "survey", { "survey" } },
  { "scene", { "scene" } },
  { "part", { "part" } },
  { "scanner", { "scanner", "FWFSettings", "detectorSettings" } },
  { "platform", { "platform" } },
  { "leg", { "leg", "platformSettings", "scannerSettings" } },
};

/// Values that go with the rest of the survey, where others do not.
const std::map<std::string, std::string> Values = { { "beamDivergenceMinor_rad", "0.0002" },
  { "binSize_ns", "0.5" }, { "optics", "conic" }, { "opticsWarmupPhase_s", "0.5" },
  { "min", "-5.5" }, { "clipMin", "-5.5" }, { "expr", "0.001 * THETA" },
  { "distanceMeasurementError", "1 + 0.01 * t" }, { "seed", "40" },
  { "gpsStartTime", "gps:1400000000" }, { "interpolationDomain", "position" },
  { "pulseShape", "helios" }, { "trajectory", __FILE__ }, { "matfile", __FILE__ },
  { "ladlut", __FILE__ }, { "weather", "fog 0.5" } };

const XmlValueRule& FindRule(const std::string& element, const std::string& name)
{
  for (const XmlElementRule& rule : GetXmlRules())
  {
    for (const XmlValueRule& value : rule.Values)
    {
      if (element == rule.Name && name == value.Name)
      {
        return value;
      }
    }
  }
  FAIL(element + " " + name);
  return GetXmlRules().front().Values.front();
}

/// A valid value that is no default.
std::string MakeValue(const std::string& element, const std::string& name)
{
  const XmlValueRule& rule = FindRule(element, name);
  const std::vector<std::string> words = rule.GetChoices();
  if (Values.count(name) > 0)
  {
    return Values.at(name);
  }
  for (const char* number : { "5.5", "0.25", "0.0625", "300", "0.002" })
  {
    if (rule.Kind == XmlKind::Real && rule.Range.Contains(std::stod(number)))
    {
      return number;
    }
  }
  switch (rule.Kind)
  {
    case XmlKind::Integer:
      return name == "onGround" || name == "estimateNormals" ? "1" : "40";
    case XmlKind::Boolean:
      return name == "active" || name == "stopAndTurn" || name == "slowdownEnabled" ||
          name == "toRadians"
        ? "false"
        : "true";
    case XmlKind::Vector:
      return "1.5;0;-2";
    case XmlKind::RealList:
      return rule.Range.Contains(2500.0) ? "1000, 2500" : "1, 2.5";
    default:
      return words.empty() ? "other" : words[words[0] == "y" ? 0 : words.size() - 1];
  }
}

/// The element with the attribute, and the name of the attribute in it.
std::pair<std::string, std::string> FindPlace(const std::string& kind, const std::string& name)
{
  const std::size_t slash = name.find('/');
  if (slash != std::string::npos)
  {
    return { (kind == "part" ? "filter:" : "") + name.substr(0, slash), name.substr(slash + 1) };
  }
  for (const std::string& element : Elements.at(kind))
  {
    for (const XmlElementRule& rule : GetXmlRules())
    {
      const XmlValueRule* value = nullptr;
      for (const XmlValueRule& one : rule.Values)
      {
        value = element == rule.Name && name == one.Name && one.Store.Owner ? &one : value;
      }
      if (value)
      {
        return { element, name };
      }
    }
  }
  FAIL(kind + " " + name);
  return {};
}

/// The files of a survey with one attribute.
class AttributeFiles
{
public:
  AttributeFiles(const std::string& kind, const std::string& element, const std::string& attribute)
  {
    const auto in = [&](const char* place) { return element == place ? attribute : std::string(); };
    const bool isChild = kind != "part" && element != Elements.at(kind)[0];
    const std::string child = isChild ? "<" + element + " " + attribute + "/>" : std::string();
    const bool isOfSurvey = element == "detectorSettings";
    const auto inside = [&](const char* place)
    { return kind == place && !isOfSurvey ? child : std::string(); };
    this->All.Write("own.xml",
      "<document><scanner id=\"tls\" " + Without("optics", in("scanner"), "rotating") + " " +
        Without("scanAngleMax_deg", in("scanner"), "120") +
        Without("headRotatePerSecMax_deg", in("scanner"), "60") +
        Without("pulseFreqs_Hz", in("scanner"), "1000") + in("scanner") + ">" + inside("scanner") +
        "</scanner>\n<platform " + Without("id", in("platform"), "tripod") + in("platform") + ">" +
        inside("platform") + "</platform></document>");
    this->All.Write("scene.xml",
      "<document><scene " + Without("id", in("scene"), "s") + in("scene") + "><part " +
        Without("id", in("part"), "floor") + in("part") + ">" +
        MakeFilters(kind, element, attribute) + "</part></scene></document>");
    const bool isLeg = kind == "leg";
    const std::string leg = "<leg " + in("leg") + "><platformSettings " +
      (isLeg ? in("platformSettings") : "") + "/><scannerSettings " +
      Without("maxDuration_s", in("scannerSettings"), "9") +
      Without("verticalResolution_deg", in("scannerSettings"), "0.5") +
      Without("headRotateStop_deg", in("scannerSettings"), "40") +
      (isLeg ? in("scannerSettings") : "") + "/></leg>";
    const std::string id =
      element == "platform" && attribute.rfind("id=", 0) == 0 ? "other" : "tripod";
    const std::string scene = element == "scene" && attribute.rfind("id=", 0) == 0 ? "other" : "s";
    this->All.Write("survey.xml",
      "<document><survey name=\"test\" scene=\"scene.xml#" + scene + "\" platform=\"own.xml#" + id +
        "\" scanner=\"own.xml#tls\" " + in("survey") + ">" + (isOfSurvey ? child : "") + leg + leg +
        "</survey></document>");
  }

  const Files All;

private:
  /// The usual value of an attribute, unless it is the one given.
  static std::string Without(
    const std::string& name, const std::string& given, const std::string& usual)
  {
    return given.rfind(name + "=", 0) == 0 ? "" : name + "=\"" + usual + "\" ";
  }

  static std::string MakeFilters(
    const std::string& kind, const std::string& element, const std::string& attribute)
  {
    const std::string file = R"(<param key="filepath" value="plane.obj"/>)";
    if (kind != "part" || element == "part")
    {
      return "<filter type=\"objloader\">" + file + "</filter>";
    }
    const std::string type = element.substr(7);
    const std::string name = attribute.substr(0, attribute.find('='));
    const std::string parameter =
      "<param key=\"" + name + "\" value=" + attribute.substr(name.size() + 1) + "/>";
    const bool isLoader = type == "detailedvoxels" || type.find("loader") != std::string::npos;
    return "<filter type=\"" + (isLoader ? type : "objloader") + "\">" + file +
      (isLoader ? parameter + "</filter>"
                : "</filter><filter type=\"" + type + "\">" + parameter + "</filter>");
  }
};

/// A survey as AttributeFiles has, made by methods, without the attribute.
vtkSmartPointer<vtkHeliosSurvey> Make(const AttributeFiles& files, const std::string& loader)
{
  auto survey = vtkSmartPointer<vtkHeliosSurvey>::New();
  const int scanner = survey->AddScanner("tls");
  survey->SetScannerAttribute(scanner, "scanAngleMax_deg", "120");
  survey->SetScannerAttribute(scanner, "headRotatePerSecMax_deg", "60");
  survey->SetScannerAttribute(scanner, "pulseFreqs_Hz", "1000");
  survey->AddPlatform("tripod");
  survey->AddAssetDirectory(files.All / "");
  survey->AddPart(loader, "plane.obj");
  survey->SetPartAttribute(0, "id", "floor");
  survey->SetSceneAttribute("id", "s");
  for (int leg = 0; leg < 2; ++leg)
  {
    survey->AddLeg();
    survey->SetLegAttribute(leg, "maxDuration_s", "9");
    survey->SetLegAttribute(leg, "verticalResolution_deg", "0.5");
    survey->SetLegAttribute(leg, "headRotateStop_deg", "40");
  }
  return survey;
}

std::string Get(vtkHeliosSurvey* survey, const std::string& kind, const std::string& name)
{
  return kind == "survey" ? survey->GetSurveyAttribute(name)
    : kind == "scene"     ? survey->GetSceneAttribute(name)
    : kind == "part"      ? survey->GetPartAttribute(0, name)
    : kind == "scanner"   ? survey->GetScannerAttribute(0, name)
    : kind == "platform"  ? survey->GetPlatformAttribute(0, name)
                          : survey->GetLegAttribute(1, name);
}

bool Set(vtkHeliosSurvey* survey, const std::string& kind, const std::string& name,
  const std::string& value)
{
  return kind == "survey" ? survey->SetSurveyAttribute(name, value)
    : kind == "scene"     ? survey->SetSceneAttribute(name, value)
    : kind == "part"      ? survey->SetPartAttribute(0, name, value)
    : kind == "scanner"   ? survey->SetScannerAttribute(0, name, value)
    : kind == "platform"
    ? survey->SetPlatformAttribute(0, name, value)
    : survey->SetLegAttribute(1, name, value) && survey->SetLegAttribute(0, name, value);
}

/// Names that follow from an id in files.
bool IsOfFile(const std::string& kind, const std::string& name)
{
  return name == "name" && (kind == "scene" || kind == "platform");
}

void CheckSame(vtkHeliosSurvey* made, vtkHeliosSurvey* read)
{
  for (const auto& [kind, elements] : Elements)
  {
    for (int i = 0; i < vtkHeliosSurvey::GetNumberOfAttributes(kind); ++i)
    {
      const std::string name = vtkHeliosSurvey::GetAttributeName(kind, i);
      INFO(kind << " " << name);
      CHECK((IsOfFile(kind, name) || Get(made, kind, name) == Get(read, kind, name)));
    }
  }
  for (std::size_t leg = 0; leg < made->GetData().Legs.size(); ++leg)
  {
    const ScanData& a = made->GetData().Legs[leg].Scans.at(0);
    const ScanData& b = read->GetData().Legs[leg].Scans.at(0);
    CHECK(a.PulseFrequency == b.PulseFrequency);
    CHECK(a.ScanFrequency == b.ScanFrequency);
    CHECK(a.ScanAngle == b.ScanAngle);
    CHECK(a.VerticalAngleMin == b.VerticalAngleMin);
    CHECK(a.VerticalAngleMax == b.VerticalAngleMax);
    CHECK(a.HeadRotateSpeed == b.HeadRotateSpeed);
    CHECK(a.HeadRotateStart == b.HeadRotateStart);
    CHECK(a.HeadRotateStop == b.HeadRotateStop);
    CHECK(a.BeamDivergence == b.BeamDivergence);
  }
}

} // namespace

TEST_CASE("SurveyAttributes: a file and a method give the same", "[SurveyAttributes]")
{
  int count = 0;
  for (const auto& [kind, elements] : Elements)
  {
    for (int i = 0; i < vtkHeliosSurvey::GetNumberOfAttributes(kind); ++i)
    {
      const std::string name = vtkHeliosSurvey::GetAttributeName(kind, i);
      const auto [element, attribute] = FindPlace(kind, name);
      const std::string value = MakeValue(element, attribute);
      CAPTURE(kind, name, value);
      if (name == "headError/zeroSinThreshold_deg" || name == "channel/id" || name == "mount" ||
        element == "filter:frames")
      {
        continue; // need expr, a channel, another part or more files, too
      }
      const AttributeFiles files(kind, element, attribute + "=\"" + value + "\"");
      const Reading reading(files.All);
      INFO(reading.Log->Errors);
      REQUIRE(reading.Good);
      vtkHeliosSurvey* read = reading.Reader->GetSurvey();
      const bool isLoader =
        element.find("loader") != std::string::npos || element == "filter:detailedvoxels";
      const auto made = Make(files, isLoader ? element.substr(7) : "objloader");
      made->SetName("test");
      CHECK(Get(made, kind, name) != value);
      CHECK(Set(made, kind, name, value));
      CHECK(Get(made, kind, name) == value);
      CHECK(made->Check());
      CheckSame(made, read);
      CHECK(Set(made, kind, name, "")); // the default
      CHECK(Get(made, kind, name) != value);
      ++count;
    }
  }
  CHECK(count > 130);
}

TEST_CASE("SurveyAttributes: every row is whole", "[SurveyAttributes]")
{
  int stored = 0;
  for (const XmlElementRule& rule : GetXmlRules())
  {
    for (const XmlValueRule& value : rule.Values)
    {
      CAPTURE(rule.Name, value.Name);
      CHECK(*value.Note != '\0');
      if (value.Store.Owner)
      {
        ++stored;
        CHECK(value.Use == XmlUse::Used);
        const XmlPlace place = value.Store.FindDefault();
        const bool isWord = *value.Choices != '\0';
        CHECK(std::holds_alternative<double*>(place) == (value.Kind == XmlKind::Real));
        CHECK(std::holds_alternative<Vec3*>(place) == (value.Kind == XmlKind::Vector));
        CHECK(
          std::holds_alternative<std::vector<double>*>(place) == (value.Kind == XmlKind::RealList));
        CHECK((std::holds_alternative<XmlEnumeration>(place) ? isWord : true));
        CHECK((value.Kind == XmlKind::Boolean ? std::holds_alternative<bool*>(place) : true));
      }
    }
  }
  CHECK(stored > 200);
}
