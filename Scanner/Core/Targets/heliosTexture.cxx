// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTexture.h"

#include "heliosCounted.h"
#include "heliosImage.h"
#include "heliosMaterialTable.h"
#include "heliosMemoryCheck.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace helios
{

namespace
{

/// Returns a number of pixels, repeated: [0, count).
int Repeat(double position, int count)
{
  const double turns = std::floor(position / count);
  return std::min(count - 1, static_cast<int>(position - turns * count));
}

/// Returns the paths of the textures of data.
std::set<std::string> ListTextures(const std::vector<vtkDataObject*>& data)
{
  std::set<std::string> paths;
  for (vtkDataObject* each : data)
  {
    for (const Material& material : GetMaterials(each))
    {
      paths.insert(material.Color.Texture);
    }
  }
  paths.erase(std::string());
  return paths;
}

/// Checks that images fit into the memory together; the pixels of all remain.
Status CheckMemoryOf(const std::vector<ImageHeader>& images)
{
  constexpr double kept = 3.0; // [bytes per pixel]
  double pixels = 0.0;
  double extra = 0.0; // while one of them is read
  for (const ImageHeader& image : images)
  {
    pixels += image.CountPixels();
    extra = std::max(extra, (image.BytesPerPixel - kept) * image.CountPixels());
  }
  const std::string textures = Counted(static_cast<std::int64_t>(images.size()), "texture");
  return CheckMemory("pixels of " + textures, pixels, kept + extra / std::max(1.0, pixels));
}

} // namespace

//------------------------------------------------------------------------------
Texture::Texture() = default;

//------------------------------------------------------------------------------
Texture::~Texture() = default;

//------------------------------------------------------------------------------
Status Texture::Read(const std::string& path)
{
  auto image = std::make_unique<Image>();
  const Status status = ReadImage({ path }, *image);
  if (!status.IsOk())
  {
    return MakeTextureError(status);
  }
  this->Pixels = std::move(image);
  return {};
}

//------------------------------------------------------------------------------
const std::string& Texture::GetWarning() const
{
  return this->Pixels->Header.Warning;
}

//------------------------------------------------------------------------------
Rgb Texture::Get(double u, double v) const
{
  const int width = this->Pixels->Header.Width;
  const int height = this->Pixels->Header.Height;
  const double x = u * width - 0.5;
  const double y = v * height - 0.5;
  const double fx = x - std::floor(x);
  const double fy = y - std::floor(y);
  const int columns[2] = { Repeat(std::floor(x), width), Repeat(std::floor(x) + 1.0, width) };
  const int rows[2] = { Repeat(std::floor(y), height), Repeat(std::floor(y) + 1.0, height) };
  Rgb color{};
  for (int j = 0; j < 2; ++j)
  {
    for (int i = 0; i < 2; ++i)
    {
      const auto place = static_cast<std::size_t>(rows[j]) * static_cast<std::size_t>(width) +
        static_cast<std::size_t>(columns[i]);
      const unsigned char* pixel = this->Pixels->Pixels.get() + 3 * place;
      const double weight = (i == 0 ? 1.0 - fx : fx) * (j == 0 ? 1.0 - fy : fy);
      for (std::size_t c = 0; c < 3; ++c)
      {
        color[c] += weight * pixel[c] / 255.0;
      }
    }
  }
  return color;
}

//------------------------------------------------------------------------------
Status TextureStore::Load(
  const std::vector<vtkDataObject*>& data, std::vector<std::string>& warnings)
{
  std::vector<std::string> paths;
  std::vector<ImageHeader> headers;
  for (const std::string& path : ListTextures(data))
  {
    if (this->Known.count(path) == 0)
    {
      paths.push_back(path);
      headers.emplace_back();
      if (const Status status = ReadImageHeader({ path }, headers.back()); !status.IsOk())
      {
        return MakeTextureError(status);
      }
    }
  }
  if (paths.empty())
  {
    return {};
  }
  if (const Status status = CheckMemoryOf(headers); !status.IsOk())
  {
    return Status::Error(
      paths.front() + (paths.size() > 1 ? " and others: " : ": ") + status.Message());
  }
  for (const std::string& path : paths)
  {
    const auto texture = std::make_shared<Texture>();
    if (const Status status = texture->Read(path); !status.IsOk())
    {
      return status;
    }
    if (!texture->GetWarning().empty())
    {
      warnings.push_back(texture->GetWarning());
    }
    this->Known.emplace(path, texture);
  }
  return {};
}

//------------------------------------------------------------------------------
std::shared_ptr<const Texture> TextureStore::Find(const std::string& path) const
{
  const auto place = this->Known.find(path);
  return place == this->Known.end() ? nullptr : place->second;
}

} // namespace helios
