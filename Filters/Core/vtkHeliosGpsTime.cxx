// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosGpsTime.h"

#include "heliosGpsTime.h"

#include <vtkObjectFactory.h>

#include <limits>

vtkStandardNewMacro(vtkHeliosGpsTime);

//------------------------------------------------------------------------------
double vtkHeliosGpsTime::FromUnixTime(double unixTime)
{
  return helios::UnixToGpsTime(unixTime);
}

//------------------------------------------------------------------------------
double vtkHeliosGpsTime::ToUnixTime(double gpsTime)
{
  return helios::GpsToUnixTime(gpsTime);
}

//------------------------------------------------------------------------------
double vtkHeliosGpsTime::Parse(const std::string& text)
{
  double time = 0.0;
  return helios::ParseGpsTime(text, time).IsOk() ? time : std::numeric_limits<double>::quiet_NaN();
}

//------------------------------------------------------------------------------
std::string vtkHeliosGpsTime::GetFault(const std::string& text)
{
  double time = 0.0;
  return helios::ParseGpsTime(text, time).Message();
}
