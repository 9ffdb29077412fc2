// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Images on surfaces.

#ifndef heliosTexture_h
#define heliosTexture_h

#include "heliosStatus.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkDataObject;

namespace helios
{

struct Image;

/// Red, green, blue, [0..1].
using Rgb = std::array<double, 3>;

/// An image that repeats in both directions.
class VTKHELIOSSCANNERCORE_EXPORT Texture
{
public:
  Texture();
  ~Texture();

  /// Reads an image of any format of ReadImage(). Errors tell what to do about map_Kd.
  Status Read(const std::string& path);

  /// Returns the warning of the image, such as an orientation that is not applied; empty: none.
  const std::string& GetWarning() const;

  /// Returns the colour at texture coordinates, bilinear between the centres of pixels: (0, 0) is
  /// the lower left corner of the image, (1, 1) the upper right one.
  Rgb Get(double u, double v) const;

private:
  std::unique_ptr<Image> Pixels;
};

/// The textures of scenes, each read once.
class VTKHELIOSSCANNERCORE_EXPORT TextureStore
{
public:
  /**
   * Reads the textures of the materials of data that it does not have, once their sizes fit into
   * the memory together. Their warnings are added to a list.
   */
  Status Load(const std::vector<vtkDataObject*>& data, std::vector<std::string>& warnings);

  /// Finds a texture; null: not loaded.
  std::shared_ptr<const Texture> Find(const std::string& path) const;

private:
  std::map<std::string, std::shared_ptr<const Texture>> Known; // by path
};

} // namespace helios

#endif
