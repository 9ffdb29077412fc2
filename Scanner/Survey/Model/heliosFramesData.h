// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How the mesh of a part deforms during a survey.

#ifndef heliosFramesData_h
#define heliosFramesData_h

#include <string>

namespace helios
{

/// The ways of a mesh before its first frame and after its last one.
enum class FramesEnd
{
  Error, ///< a survey that lasts longer is an error
  Hold,  ///< it stays as in that frame
  Loop   ///< the frames are repeated
};

struct FramesData
{
  std::string Where;  ///< place of the filter; empty: the mesh does not deform
  double Rate = 0.0;  ///< frames per second; 0: not given
  double Start = 0.0; ///< [s], time of the frames at time 0 of the survey
  FramesEnd End = FramesEnd::Error;
  std::string Animation; ///< name or number of an animation of glTF; empty: the first

  bool IsGiven() const { return !this->Where.empty(); }
};

} // namespace helios

#endif
