// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The table of the dialect: one row per attribute, in one file per group of elements. Only these
// files include it.

#ifndef heliosXmlTables_h
#define heliosXmlTables_h

#include "heliosStatus.h"
#include "heliosTolerances.h"
#include "heliosXmlRule.h"
#include "vtkHeliosInstrumentData.h"

#include <string>
#include <vector>

namespace helios
{

/// @{
/// Returns the elements of a group.
std::vector<XmlElementRule> MakeSurveyRules();
std::vector<XmlElementRule> MakePlannerRules();
std::vector<XmlElementRule> MakeLegRules();
std::vector<XmlElementRule> MakeReceiverRules();
std::vector<XmlElementRule> MakeScannerRules();
std::vector<XmlElementRule> MakePlatformRules();
std::vector<XmlElementRule> MakeSceneRules();
std::vector<XmlElementRule> MakeFilterRules();
///@}

/// Returns the names of the echo detectors, with those that plug-ins have added; the first is the default.
std::vector<std::string> GetEchoDetectorNames();

/// Finds the fault of a text of weather: the end of a message.
Status FindFaultOfWeather(const std::string& text);

namespace rows
{

// Sufficient for any survey; no division or square of values overflows.
namespace instrument = vtkHeliosInstrumentRanges;

/// Returns the range of a value of the instrument, in a unit of which the scale makes the value's.
constexpr XmlRange InUnits(const vtkHeliosValueRange& range, double unitsPerValue = 1.0)
{
  return { unitsPerValue * range.Low, unitsPerValue * range.High };
}

constexpr XmlRange Frequency = { 1e-3, 1e9 };
constexpr XmlRange Distance = { 1e-3, 1e9 };
constexpr XmlRange Seconds = { 1e-3, 1e9 };
constexpr XmlRange Moment = { -1e12, 1e12 };
constexpr XmlRange PulseLength = { 1e-2, 1e3 };
constexpr XmlRange NotNegative = { 0.0, 1e12 };
constexpr XmlRange Fraction = { 0.0, 1.0 };
constexpr XmlRange Share = { 1e-6, 1.0 };
constexpr XmlRange Aperture = { 1e-6, instrument::ReceiverDiameter.High };
constexpr XmlRange Extinction = { 0.0, instrument::AtmosphericExtinction.High };
constexpr XmlRange TimeStep = { 1e-9, 1.0 };
constexpr XmlRange RangeTolerance = { MinimumRangeTolerance, LargestTolerance };
constexpr XmlRange EnergyTolerance = { MinimumEnergyTolerance, LargestTolerance };
constexpr XmlRange Angle = { -360.0, 360.0 };
constexpr XmlRange HalfAngle = { 0.0, 360.0 };
constexpr XmlRange HeadAngle = { -1e6, 1e6 };
constexpr XmlRange Column = { 0.0, 999.0 };
constexpr XmlRange ScanFrequency = { 0.0, 1e6 };
constexpr XmlRange RotorFrequency = { -1e6, 1e6 };
constexpr XmlRange WedgeAngle = { -89.0, 89.0 };
constexpr XmlRange RefractiveIndex = { 1.0, 10.0 };
constexpr XmlRange FacetPitch = { -89.0, 89.0 };
constexpr XmlRange FacetRoll = { -180.0, 180.0 };
constexpr XmlRange BeamOffset = { -10.0, 10.0 };
constexpr XmlRange FiringTime = { -1.0, 1e3 };
constexpr XmlRange Steps = { 1.0, 1e9 };
constexpr XmlRange GridStep = { 1e-3, 1e6 };
constexpr XmlRange RightAngle = { 0.0, 90.0 };
constexpr XmlRange Elevation = { -90.0, 90.0 };

/// Returns whether files are stricter than the instrument.
constexpr bool IsWithin(const XmlRange& range, const vtkHeliosValueRange& all)
{
  return range.Low >= all.Low && range.High <= all.High;
}
static_assert(IsWithin(PulseLength, instrument::PulseLength));
static_assert(IsWithin(Share, instrument::OpticalEfficiency));
static_assert(IsWithin(Aperture, instrument::ReceiverDiameter));
static_assert(IsWithin(Extinction, instrument::AtmosphericExtinction));
static_assert(IsWithin(NotNegative, instrument::Range));

/// Returns a row of a kind: the name of an attribute, and its meaning or the reason why it is not
/// read.
template <XmlKind Kind>
XmlValueRule MakeRow(const char* name, const char* note)
{
  XmlValueRule row;
  row.Name = name;
  row.Note = note;
  row.Kind = Kind;
  return row;
}

constexpr auto Text = MakeRow<XmlKind::Text>;
constexpr auto Number = MakeRow<XmlKind::Real>;
constexpr auto Integer = MakeRow<XmlKind::Integer>;
constexpr auto Flag = MakeRow<XmlKind::Boolean>;
constexpr auto Numbers = MakeRow<XmlKind::RealList>;
constexpr auto Vector = MakeRow<XmlKind::Vector>;
constexpr auto Rotated = MakeRow<XmlKind::Rotation>;
constexpr auto Reference = MakeRow<XmlKind::Reference>;

/// Makes a row for one of some words, with blanks between them, or '|' if they contain blanks; '~'
/// in front: case-insensitive.
inline XmlValueRule Word(const char* name, const char* choices, const char* note)
{
  XmlValueRule row = Text(name, note);
  row.Choices = choices;
  return row;
}

/// @{
/// Make a child that may be given once, or several times. A child without a table of its own has a
/// note.
inline XmlChildRule One(const char* name, const char* note = "")
{
  return { name, false, XmlUse::Used, note };
}

inline XmlChildRule Many(const char* name)
{
  return { name, true, XmlUse::Used, "" };
}
///@}

} // namespace rows
} // namespace helios

#endif
