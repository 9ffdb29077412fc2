// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Materials whose textures cut shapes out of triangles.

#ifndef heliosCutouts_h
#define heliosCutouts_h

#include "heliosCutoutClipper.h"
#include "heliosSceneMesh.h"
#include "heliosStatus.h"

#include <array>
#include <string>
#include <vector>

namespace helios
{

/// The values of an image that tell how opaque it is.
enum class MaskChannel
{
  AlphaOrLuminance, ///< luminance if the image has no transparency
  Alpha,
  Luminance,
  Red,
  Green,
  Blue
};

/// A material that an image cuts.
struct Cutout
{
  int Row = 0;       ///< row of the material
  std::string Place; ///< where it says so: "path:line: "
  std::string What;  ///< such as `map_d mask.png of material "leaf"`
  std::string Fault; ///< why it cannot be applied; empty: it can
  std::string Path;  ///< path of the image; empty: opacity Factor everywhere
  std::string Bytes; ///< the image, if it is not a file; Path names it in messages
  MaskChannel Channel = MaskChannel::AlphaOrLuminance;
  double Factor = 1.0;    ///< scale of the image's values, [0..1]
  double Threshold = 0.5; ///< least value that is opaque, (0..1]
  bool IsBlended = false; ///< values are opacities: there is no threshold
  bool IsTopDown = false; ///< v of texture coordinates is downward
  std::array<TextureWrap, 2> Wrap{ TextureWrap::Repeat, TextureWrap::Repeat };
};

/// Reads the opacity of a cutout's image. Errors begin with the path.
VTKHELIOSFILTERSIO_EXPORT Status ReadMask(const Cutout& cutout, MaskImage& mask);

/**
 * Replaces the triangles of cut materials by what their images leave, after all others; a triangle
 * that is whole is as it was. The triangles of partly opaque places have a material of their own: a
 * leaf that transmits the rest. Notes of the mesh say what was cut; a warning tells what is scanned
 * as opaque, and why. The mesh needs texture coordinates. False after an error, which is in the
 * report: there are too many triangles.
 */
VTKHELIOSFILTERSIO_EXPORT bool ApplyCutouts(
  SceneMesh& mesh, const std::vector<Cutout>& cutouts, TextReport& report);

/// Returns whether a triangle of the mesh has a material that is cut.
VTKHELIOSFILTERSIO_EXPORT bool HasCutouts(SceneMesh& mesh, const std::vector<Cutout>& cutouts);

} // namespace helios

#endif
