// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The dialect as YAML: the same survey as in XML; errors give the line.
#include "heliosSurveyEquality.h"
#include "heliosSurveyFiles.h"
#include "heliosXmlRules.h"
#include "vtkHeliosDialect.h"

#include <catch2/catch.hpp>

#include <set>
#include <string>

using namespace helios;
using namespace helios::test;

namespace
{

/// Reads survey.yaml.
struct YamlReading
{
  vtkNew<vtkHeliosSurveyReader> Reader;
  vtkSmartPointer<ErrorObserver> Log = Observe(Reader);
  bool Good;

  YamlReading(const Files& files, const std::string& text)
  {
    files.Write("survey.yaml", text);
    this->Reader->SetFileName((files / "survey.yaml").c_str());
    this->Good = this->Reader->Read();
  }
};

/// Returns XML as YAML.
std::string MakeYaml(const Files& files, const std::string& xml)
{
  vtkNew<vtkHeliosDialect> dialect;
  const auto log = Observe(dialect);
  const bool isGood = dialect->WriteXml(files / "made.yaml", xml);
  INFO(log->Errors);
  CHECK(isGood);
  return ReadText(files / "made.yaml");
}

/// Returns YAML as XML, without its declaration and line ends.
std::string MakeXml(const Files& files, const std::string& yaml)
{
  files.Write("made.yml", yaml);
  vtkNew<vtkHeliosDialect> dialect;
  const auto log = Observe(dialect);
  std::string text = dialect->ReadXml(files / "made.yml");
  INFO(log->Errors);
  CHECK(!text.empty());
  text.erase(0, text.find("?>") + 3);
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at))
  {
    text.erase(at, text.find_first_not_of("\n ", at) - at);
  }
  return text;
}

const std::string Legs = R"(
  leg:
    - platformSettings: {x: 1, y: 2, z: 3}
      scannerSettings: {scanFreq_hz: 50, headRotatePerSec_deg: 10, headRotateStop_deg: 10}
)";
const std::string Head =
  "survey:\n  name: test\n  scene: scene.xml#s\n  platform: assets.xml#tripod\n"
  "  scanner: assets.xml#tls";

/// A part of a scene in YAML, whose lines begin in line 3.
std::string Part(const std::string& part)
{
  std::string head = Head;
  head.replace(head.find("scene.xml#"), 10, "");
  return "scene:\n  id: s\n  part:\n" + part + head + Legs;
}

} // namespace

TEST_CASE("SurveyYaml: the same survey as in XML", "[SurveyYaml]")
{
  const Files files;
  const Reading xml(files, Tripod, OneLeg);
  YamlReading yaml(files, Head + Legs);
  INFO(yaml.Log->Errors << yaml.Log->Warnings);
  REQUIRE(yaml.Good);
  CHECK(yaml.Log->Warnings.empty());
  CHECK(FindDifferences(xml.Data(), yaml.Reader->GetSurvey()->GetData()) == "");
}

TEST_CASE("SurveyYaml: XML and YAML refer to each other", "[SurveyYaml]")
{
  const Files files;
  vtkNew<vtkHeliosDialect> dialect;
  CHECK(dialect->Convert(files / "scene.xml", files / "scene.YAML"));
  CHECK(dialect->Convert(files / "assets.xml", files / "more/assets.yml"));
  const Reading xml(files, Tripod, OneLeg);
  const SurveyData wanted = xml.Data();
  files.Replace("survey.xml", "scene.xml#s", "scene.YAML#s");
  files.Replace("survey.xml", "assets.xml#tls", "more/assets.yml#tls");
  const Reading mixed(files);
  INFO(mixed.Log->Errors);
  REQUIRE(mixed.Good);
  CHECK(FindDifferences(wanted, mixed.Data()) == "");

  YamlReading yaml(files, Head + Legs);
  REQUIRE(yaml.Good);
  CHECK(FindDifferences(wanted, yaml.Reader->GetSurvey()->GetData()) == "");
  files.Replace("scene.YAML", "filepath: plane.obj", "filepath: no.obj");
  files.Replace("survey.yaml", "scene.xml#s", "scene.YAML#s");
  YamlReading bad(files, ReadText(files / "survey.yaml"));
  CHECK(bad.Log->HasError("scene.YAML:5: filepath=\"no.obj\": no such file"));
}

TEST_CASE("SurveyYaml: elements, filters and lists", "[SurveyYaml]")
{
  const Files files;
  CHECK(MakeXml(files, "scanner: {id: a, pulseFreqs_Hz: [1e3, 0x1F], accuracy_m: 007, x: on}\n") ==
    R"(<document><scanner id="a" pulseFreqs_Hz="1e3,0x1F" accuracy_m="007" x="on" /></document>)");
  CHECK(MakeXml(files, R"(scene:
  part:
    - objloader: {filepath: 'a #1.obj', up: "y"}
      rotate:
        rotation: {rotations: local, rot: [{axis: z, angle_deg: 1}, {axis: x, angle_deg: 2}]}
      repair:
      translate: {offset: [1, 2, 3], onGround: 1}
      dmotion: {loop: 0, motion: [{type: translation, vec: 1;2;3}]}
    - filter:
      - {type: wms, param: {key: a, value: b}}
)") ==
    R"(<document><scene><part><filter type="objloader"><param type="string" key="filepath" )"
    R"(value="a #1.obj" /><param type="string" key="up" value="y" /></filter><filter type="rotate">)"
    R"(<param type="rotation" key="rotation" rotations="local"><rot axis="z" angle_deg="1" />)"
    R"(<rot axis="x" angle_deg="2" /></param></filter><filter type="repair" /><filter )"
    R"(type="translate"><param type="vec3" key="offset" value="1;2;3" /><param type="integer" )"
    R"(key="onGround" value="1" /></filter><dmotion loop="0"><motion type="translation" )"
    R"(vec="1;2;3" /></dmotion></part><part><filter type="wms"><param key="a" value="b" /></filter>)"
    R"(</part></scene></document>)");
  const std::string mixed = R"(survey:
  name: a
  children:
    - leg: {x: 1}
    - origin: {x: 5}
    - leg: {}
)";
  CHECK(MakeXml(files, mixed) ==
    R"(<document><survey name="a"><leg x="1" /><origin x="5" /><leg /></survey></document>)");
  CHECK(
    MakeYaml(files,
      "<document><survey name='a'><leg x='1'/><origin x='5'/><leg/></survey></document>") == mixed);
}

TEST_CASE("SurveyYaml: aliases repeat values", "[SurveyYaml]")
{
  const Files files;
  CHECK(MakeXml(files, "scannerSettings: &s\n  id: a\nFWFSettings: *s\n") ==
    R"(<document><scannerSettings id="a" /><FWFSettings id="a" /></document>)");
}

TEST_CASE("SurveyYaml: texts of XML as other programs read them", "[SurveyYaml]")
{
  const Files files;
  CHECK(MakeYaml(files, R"(<document><survey name="1e3" scene="a.xml#b" seed="2026-01-01 00:00:00"
 gpsStartTime="" id="no" rayCaster="null" numRuns="1" scanner="a: b" platform=" x" simSpeed="0.10"
 note="&quot;\&#9;&#10;Ä&#x85;"><FWFSettings/><note>text</note></survey></document>)") ==
    R"(survey:
  name: "1e3"
  scene: a.xml#b
  seed: "2026-01-01 00:00:00"
  gpsStartTime: ""
  id: "no"
  rayCaster: "null"
  numRuns: 1
  scanner: "a: b"
  platform: " x"
  simSpeed: 0.10
  note: "\"\\\u0009\u000AÄ\u0085"
  children:
    - FWFSettings: {}
    # text
    - note: {}
)");
}

TEST_CASE("SurveyYaml: comments", "[SurveyYaml]")
{
  const Files files;
  const std::string yaml = R"(# The file

# two
#   lines
scene:
  id: s
  # a part
  part:
    - id: "1"
      # its loader
      objloader:
        # not the next
        filepath: a.obj
      # after it
    # another

    # and another
    - {id: "2"}
# the end
)";
  CHECK(MakeXml(files, yaml) ==
    R"(<!-- The file --><document><!--twolines--><scene id="s">)"
    R"(<!-- a part --><part id="1"><!-- its loader --><filter type="objloader"><!-- not the next -->)"
    R"(<param type="string" key="filepath" value="a.obj" /></filter><!-- after it --></part>)"
    R"(<!-- another --><!-- and another --><part id="2" /></scene><!-- the end --></document>)");
  vtkNew<vtkHeliosDialect> dialect;
  CHECK(dialect->WriteXml(files / "again.yaml", dialect->ReadXml(files / "made.yml")));
  CHECK(ReadText(files / "again.yaml") == yaml);
  CHECK(MakeYaml(files, "<!--One\n    two\n      three--><document><survey/></document>") ==
    "# One\n# two\n#   three\n\nsurvey: {}\n");
}

TEST_CASE("SurveyYaml: no name is both an attribute and an element with keys", "[SurveyYaml]")
{
  std::set<std::string> texts; // elements that are an attribute
  for (const XmlElementRule& rule : GetXmlRules())
  {
    std::set<std::string> names;
    for (const XmlValueRule& value : rule.Values)
    {
      names.insert(value.Name);
    }
    for (const XmlChildRule& child : rule.Children)
    {
      names.insert(child.Name).second ? void() : void(texts.insert(child.Name));
    }
    CHECK(names.count("children") == 0);
  }
  for (const XmlElementRule& rule : GetXmlRules())
  {
    CHECK(texts.count(rule.Name) == 0);
  }
  CHECK(texts.count("maxDuration_s") == 1);
}

TEST_CASE("SurveyYaml: errors name the line and the cure", "[SurveyYaml]")
{
  struct Case
  {
    std::string Text;
    std::string Message;
  };
  std::string deep = "a";
  for (int i = 0; i < 70; ++i)
  {
    deep = "{a: " + deep + "}";
  }
  std::string bomb = "scene:\n  a0: &a0 {x: 1}\n";
  for (int i = 1; i < 12; ++i)
  {
    const std::string last = "*a" + std::to_string(i - 1);
    bomb += "  a" + std::to_string(i) + ": &a" + std::to_string(i) + " {a: " + last;
    for (const char* name : { ", b: ", ", c: ", ", d: ", ", e: ", ", f: ", ", g: " })
    {
      bomb += name + last;
    }
    bomb += "}\n";
  }
  std::string anchors = "survey:\n";
  for (int i = 0; i < 1001; ++i)
  {
    anchors += "  a" + std::to_string(i) + ": &a" + std::to_string(i) + " b\n";
  }
  const Case cases[] = {
    { "survey: {name: a\n b: c}", ":2: this is not YAML: did not find expected ',' or '}' while" },
    { "survey:\n  name: a\n scene: b\n", ":3: this is not YAML: did not find expected key" },
    { "survey:\n\tname: a\n", ":2: this is not YAML: found character that cannot start any token" },
    { "survey: [\xFF]",
      ":1: the text is not valid: invalid leading UTF-8 octet; save the file as" },
    { "survey:\n  name: \x01\n", ":2: the text is not valid: control characters are not allowed" },
    { "survey:\n  name: \"\\x01\"\n", ":2: the text has a control character; remove it" },
    { "", ":1: the file is empty" },
    { "# nothing\n", ":1: the file is not a mapping; begin with the name of an element" },
    { "- survey\n", ":1: the file is not a mapping" },
    { Head + Legs + "---\nscene: {}\n", ":10: a second document; put everything into one" },
    { "survey:\n  name: a\n  name: b\n",
      ":3: <survey> has name twice, first in line 2; leave one of them, or make a list of both" },
    { "survey:\n  <<: {name: a}\n", ":2: <<: keys are not merged; repeat a whole element by an" },
    { "survey:\n  a b: c\n", ":2: \"a b\" in <survey> is not a name; names have letters" },
    { "survey:\n  [a]: c\n", ":2: \"\" in <survey> is not a name" },
    { "survey:\n  name: !b a\n", ":2: the tag !b is not read; remove it" },
    { "survey:\n  name: !!int 3\n", ":2: the tag tag:yaml.org,2002:int is not read" },
    { "survey:\n  name: *a\n", ":2: this is not YAML: found undefined alias" },
    { "survey:\n  leg: 5\n", ":2: leg of <survey> is an element, not a value; give its keys" },
    { "survey:\n  name: {a: b}\n", ":2: name of <survey> is one value; give it instead of keys" },
    { "survey:\n  name:\n", ":2: name of <survey> has no value; give one" },
    { "survey:\n  scene: #s\n", ":2: scene of <survey> has no value; give one, in quotes if it" },
    { "survey:\n  seed: ~\n", ":2: seed of <survey> has no value" },
    { "survey:\n  name:\n  - a\n", ":3: name of <survey> is one value, not a list" },
    { "survey:\n  leg:\n  - 5\n", ":3: leg of <survey> is a list of elements; give the keys of" },
    { "survey:\n  leg:\n  - [a]\n", ":3: leg of <survey> is a list of elements" },
    { "scanner:\n  pulseFreqs_Hz: [{}]\n", ":2: pulseFreqs_Hz of <scanner> is a list of numbers" },
    { "survey:\n  children:\n  - leg: {}\n    scan: {}\n",
      ":3: children of <survey> are elements; give the name of each and its keys, as in - leg" },
    { deep, ":1: elements are nested more than 64 times" },
    { "a: " + std::string(300, '[') + std::string(300, ']'),
      ":1: elements are nested more than 64 times; nest fewer" },
    { anchors, ":1002: there are more than 1000 anchors; give elements a template instead" },
    { "survey:\n  children: 5\n",
      ":2: children of <survey> is not a list; give elements in their" },
    { "a: &a {b: *a}",
      ":1: elements are nested more than 64 times, or an alias is inside of what" },
    { bomb, ": aliases repeat more than " },
    { Head + "\n  naxe: b" + Legs,
      ":6: attribute naxe of <survey> is unknown; did you mean name?" },
    { Head + "\n  lge: {x: 1}" + Legs,
      ":6: element <lge> in <survey> is unknown; did you mean <leg>" },
    { Part("    objlaoder: {filepath: plane.obj}\n"),
      ":4: filter type=\"objlaoder\" is unknown; did you mean objloader?" },
    { Part("    swpa: {force_null: true}\n"),
      ":4: element <swpa> in <part> is unknown; did you mean" },
    { Part("    objloader:\n      filepath: plane.obj\n      filepaht: b\n"),
      ":6: parameter \"filepaht\" of filter objloader is unknown; did you mean filepath?" },
    { Part("    objloader: {filepath: plane.obj}\n    scale:\n      scale: yes\n"),
      ":6: scale=\"yes\" is not a number" },
    { Part("    objloader: 5\n"), ":4: objloader of <part> is an element, not a value" },
    { Head + "\n  seed: on" + Legs, ":6: seed=\"on\"" },
    { Head + "\n  legRandomOffset: yes" + Legs, ":6: legRandomOffset=\"yes\"" },
    { Head + "\n  rangeTolerance_m: 0x1F" + Legs, ":6: rangeTolerance_m=\"0x1F\" is not a number" },
    { Head + "\n  leg: {platformSettings: {template: no}}\n", ":6: template=\"no\": " },
    { "survey:\n  name: a\n  scene: scene.xml#t" + Legs, ":3: scene=\"scene.xml#t\": " },
    { "survey:\n  name: a\n  scene: none.xml#s" + Legs, ":3: scene=\"none.xml\": no such file" },
  };
  const Files files;
  for (const Case& each : cases)
  {
    const YamlReading reading(files, each.Text);
    const std::string all = reading.Log->Errors + reading.Log->Warnings;
    INFO(each.Text.substr(0, 300) << "\n" << each.Message << "\n" << all);
    CHECK(
      all.find((each.Message[1] == ' ' ? "" : "survey.yaml") + each.Message) != std::string::npos);
  }
}

TEST_CASE("SurveyYaml: what cannot be written as YAML", "[SurveyYaml]")
{
  const Files files;
  vtkNew<vtkHeliosDialect> dialect;
  const auto log = Observe(dialect);
  CHECK_FALSE(dialect->WriteXml(files / "a.yaml", "<document><survey name=\"\xE4\"/></document>"));
  CHECK(log->HasError("a.yaml: not written: texts are not all UTF-8"));
  std::string deep = "<a/>";
  for (int i = 0; i < 80; ++i)
  {
    deep = "<a>" + deep + "</a>";
  }
  CHECK_FALSE(dialect->WriteXml(files / "a.yaml", "<document>" + deep + "</document>"));
  CHECK(log->HasError("a.yaml:1: elements are nested more than 64 times; nest fewer"));
  CHECK_FALSE(dialect->Convert(files / "none.xml", files / "a.yaml"));
  CHECK(log->HasError("none.xml"));
  CHECK_FALSE(dialect->Convert(files / "scene.xml", files / "plane.obj/a.yaml"));
  CHECK(log->HasError("plane.obj"));
  CHECK_FALSE(std::filesystem::exists(files / "a.yaml"));
}
