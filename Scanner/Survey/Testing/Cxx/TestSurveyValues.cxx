// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Every number of the dialect has a range, and a value outside is an error that names it.
#include "heliosXmlRules.h"

#include "heliosSurveyFiles.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

using namespace helios;
using namespace helios::test;

namespace
{

bool IsNumber(const XmlValueRule& value)
{
  return value.Kind == XmlKind::Real || value.Kind == XmlKind::Integer ||
    value.Kind == XmlKind::RealList || value.Kind == XmlKind::Vector;
}

/// A survey of a tripod with attributes at two places.
Reading ReadWith(const Files& files, const std::string& scanner, const std::string& leg)
{
  return Reading(files, Tripod,
    "<leg><platformSettings " + leg + "/>\n<scannerSettings scanFreq_hz=\"50\" " + scanner +
      " headRotatePerSec_deg=\"10\" headRotateStop_deg=\"10\"/></leg>");
}

void CheckOutOfRange(const std::string& scanner, const std::string& leg, const std::string& value)
{
  const Files files;
  const Reading reading = ReadWith(files, scanner, leg);
  CAPTURE(reading.Log->Errors, value);
  CHECK_FALSE(reading.Good);
  CHECK(reading.Log->HasError("survey.xml:"));
  CHECK(reading.Log->HasError(value));
}

} // namespace

TEST_CASE("SurveyValues: every rule refuses meaningless numbers", "[SurveyValues]")
{
  int count = 0;
  for (const XmlElementRule& rule : GetXmlRules())
  {
    for (const XmlValueRule& value : rule.Values)
    {
      CAPTURE(rule.Name, value.Name);
      if (!IsNumber(value))
      {
        continue;
      }
      ++count;
      const bool isVisibility = std::string(value.Name).rfind("atmosphericVisibility", 0) == 0;
      CHECK((value.Range.High <= 1e15 || isVisibility)); // kilometres without limit: clear air
      CHECK(value.Range.Low >= -1e12);
      for (const double tiny : { 5e-324, 1e-320, 1e-300, 1e-31 })
      {
        CHECK(value.Range.Contains(tiny) == (value.Range.Low < 0.0)); // a coordinate, an angle
      }
      CHECK_FALSE(value.Range.Contains(1.7e308));
      CHECK_FALSE(value.Range.Contains(-1e300));
      CHECK_FALSE(value.Range.Contains(std::nan("")));
    }
  }
  CHECK(count > 100);
}

TEST_CASE("SurveyValues: values out of range name file:line, value and range", "[SurveyValues]")
{
  CheckOutOfRange("pulseFreq_hz=\"1e-300\"", "",
    "pulseFreq_hz=\"1e-300\" is out of range; give a number from 0.001 to 1000000000 [Hz]");
  CheckOutOfRange("pulseFreq_hz=\"1e-320\"", "", "pulseFreq_hz=\"1e-320\"");
  CheckOutOfRange("trajectoryTimeInterval_s=\"1e-200\"", "",
    "trajectoryTimeInterval_s=\"1e-200\" is out of range; give a number from 0 to 1000000000000 "
    "[s], 0 or at least 1e-30 in size");
  CheckOutOfRange(
    "", "x=\"1e13\"", "x=\"1e13\" is out of range; give a number from -1000000000000");
  CheckOutOfRange("headRotateStart_deg=\"1e300\"", "", "headRotateStart_deg=\"1e300\"");
  CheckOutOfRange("", "movePerSec_m=\"-1e300\"", "movePerSec_m=\"-1e300\" is out of range");
}

TEST_CASE("SurveyValues: negative zero is read as zero", "[SurveyValues]")
{
  const Files files;
  const Reading reading = ReadWith(files, "verticalAngleMin_deg=\"-0\"", "x=\"-0.0\"");
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  CHECK_FALSE(std::signbit(reading.Data().Legs.at(0).Position[0]));
  CHECK_FALSE(std::signbit(reading.Data().Legs.at(0).Scans.at(0).VerticalAngleMin));
}

TEST_CASE("SurveyValues: a long value is truncated in messages", "[SurveyValues]")
{
  const std::string digits(100000, '9');
  CheckOutOfRange(
    "pulseFreq_hz=\"" + digits + "\"", "", std::string(200, '9') + "... (100000 characters)\"");
}

TEST_CASE("SurveyValues: deeply nested elements do not crash a reader", "[SurveyValues]")
{
  const Files files;
  REQUIRE(Reading(files, Tripod, OneLeg).Good);
  std::string deep;
  for (int i = 0; i < 1000000; ++i)
  {
    deep += "<a>";
  }
  files.Write("survey.xml", "<document>" + deep);
  CHECK_FALSE(Reading(files).Good);
  for (int i = 0; i < 1000000; ++i)
  {
    deep += "</a>";
  }
  files.Write("survey.xml", "<document>" + deep + "</document>");
  const Reading reading(files);
  CHECK_FALSE(reading.Good);
  CHECK(reading.Log->HasError("survey.xml"));
}
