// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The attributes of points that the viewer shows.

#ifndef heliosCloudColumn_h
#define heliosCloudColumn_h

namespace helios::viewer
{

/// Attributes of a point besides its position.
enum class CloudColumn : int
{
  Height,
  Amplitude,
  ReturnNumber,
  NumberOfReturns,
  Class,
  Time,
  Part,
  Material,
  Leg,
  Incidence,
  Range,
  Pulse,
  Color
};
constexpr int NumberOfCloudColumns = 13;

} // namespace helios::viewer

#endif
