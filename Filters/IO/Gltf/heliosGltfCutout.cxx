// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosGltfCutout.h"

#include "heliosGltfDocument.h"
#include "heliosGltfUri.h"

#include <json/json.h>

#include <limits>

namespace helios
{

namespace
{

constexpr std::int64_t ClampToEdge = 33071;
constexpr std::int64_t MirroredRepeat = 33648;

/// The opacity of a material, step by step; an error becomes the fault of its cutout.
class CutoutFinder
{
public:
  CutoutFinder(GltfDocument& document, Cutout& cutout)
    : Document(document)
    , Result(cutout)
  {
  }

  /// Finds image and wrapping of a reference to a texture; returns the set of coordinates.
  int FindTexture(const Json::Value& reference, const std::string& path)
  {
    std::int64_t set = 0;
    std::int64_t texture = 0;
    Status status =
      this->Document.FindIndex("textures", GetMember(reference, "index"), path + ".index", texture);
    status = status.IsOk() ? this->Document.ReadWhole(reference, "texCoord", path, 0, set) : status;
    if (status.IsOk() &&
      !GetMember(GetMember(reference, "extensions"), "KHR_texture_transform").isNull())
    {
      status = this->Document.Fail(
        path + ".extensions", "KHR_texture_transform is not read; apply it before export");
    }
    status = status.IsOk() ? this->ReadTexture(texture) : status;
    this->Result.Fault = status.Message();
    return set < std::numeric_limits<int>::max() ? static_cast<int>(set) : -1;
  }

private:
  Status ReadTexture(std::int64_t texture)
  {
    const Json::Value& given = this->Document.GetElement("textures", texture);
    const std::string path = ElementPath("textures", texture);
    std::int64_t image = 0;
    Status status =
      this->Document.FindIndex("images", GetMember(given, "source"), path + ".source", image);
    status = status.IsOk() ? this->ReadImageBytes(image) : status;
    std::int64_t sampler = 0;
    if (!status.IsOk() || GetMember(given, "sampler").isNull())
    {
      return status;
    }
    status =
      this->Document.FindIndex("samplers", GetMember(given, "sampler"), path + ".sampler", sampler);
    return status.IsOk() ? this->ReadSampler(sampler) : status;
  }

  Status ReadImageBytes(std::int64_t image)
  {
    const Json::Value& given = this->Document.GetElement("images", image);
    const std::string path = ElementPath("images", image);
    this->Result.Path = this->Document.GetPath() + ": " + path;
    const Json::Value& view = GetMember(given, "bufferView");
    if (view.isNull())
    {
      const Status status =
        ReadUri(GetText(given, "uri"), this->Document.GetPath(), this->Result.Bytes);
      return status.IsOk() ? status : this->Document.Fail(path + ".uri", status.Message());
    }
    GltfBytes bytes;
    const Status status = this->Document.ReadView(view, path + ".bufferView", bytes);
    this->Result.Bytes = bytes.Bytes;
    return status;
  }

  Status ReadSampler(std::int64_t sampler)
  {
    const Json::Value& given = this->Document.GetElement("samplers", sampler);
    const std::string path = ElementPath("samplers", sampler);
    const char* const names[2] = { "wrapS", "wrapT" };
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      std::int64_t mode = 0;
      const Status status = this->Document.ReadWhole(given, names[axis], path, 0, mode);
      if (!status.IsOk())
      {
        return status;
      }
      this->Result.Wrap[axis] = mode == ClampToEdge ? TextureWrap::Clamp
        : mode == MirroredRepeat                    ? TextureWrap::Mirror
                                                    : TextureWrap::Repeat;
    }
    return {};
  }

  GltfDocument& Document;
  Cutout& Result;
};

} // namespace

//------------------------------------------------------------------------------
int FindGltfCutout(
  GltfDocument& document, std::int64_t material, const std::string& name, Cutout& cutout)
{
  const Json::Value& given = document.GetElement("materials", material);
  const std::string path = ElementPath("materials", material);
  const std::string mode = GetText(given, "alphaMode");
  const Json::Value& surface = GetMember(given, "pbrMetallicRoughness");
  const Json::Value& texture = GetMember(surface, "baseColorTexture");
  const Json::Value& threshold = GetMember(given, "alphaCutoff");
  double color[4] = { 1, 1, 1, 1 };
  ReadNumbers(GetMember(surface, "baseColorFactor"), color, 4);
  cutout = Cutout();
  if ((mode != "MASK" && mode != "BLEND") || (texture.isNull() && color[3] == 1.0))
  {
    return -1;
  }
  cutout.Row = static_cast<int>(material);
  cutout.Place = document.GetPath() + ": ";
  cutout.What = path + ".alphaMode: " + mode + " of material " + Quote(name);
  cutout.Channel = MaskChannel::Alpha;
  cutout.Factor = color[3];
  cutout.Threshold = mode == "MASK" && threshold.isNumeric() ? threshold.asDouble() : 0.5;
  cutout.IsBlended = mode == "BLEND";
  cutout.IsTopDown = true;
  return texture.isNull()
    ? -1
    : CutoutFinder(document, cutout)
        .FindTexture(texture, path + ".pbrMetallicRoughness.baseColorTexture");
}

} // namespace helios
