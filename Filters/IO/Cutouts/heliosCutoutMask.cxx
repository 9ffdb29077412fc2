// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCutouts.h"

#include "heliosImage.h"

#include <array>
#include <cmath>

namespace helios
{

namespace
{

using Weights = std::array<double, 3>; // weights of red, green and blue

Weights GetWeights(MaskChannel channel)
{
  switch (channel)
  {
    case MaskChannel::Red:
    case MaskChannel::Alpha: // all three have it
      return { 1.0, 0.0, 0.0 };
    case MaskChannel::Green:
      return { 0.0, 1.0, 0.0 };
    case MaskChannel::Blue:
      return { 0.0, 0.0, 1.0 };
    default:
      return { 0.2126, 0.7152, 0.0722 }; // Rec. 709
  }
}

} // namespace

//------------------------------------------------------------------------------
Status ReadMask(const Cutout& cutout, MaskImage& mask)
{
  mask = { 1, 1, { 255 } };
  Image image;
  MaskChannel channel = cutout.Channel;
  if (!cutout.Path.empty())
  {
    const ImageSource source{ cutout.Path, cutout.Bytes };
    const Status status = ReadImageHeader(source, image.Header);
    const bool hasAlpha = image.Header.HasAlpha;
    channel = channel == MaskChannel::AlphaOrLuminance
      ? (hasAlpha ? MaskChannel::Alpha : MaskChannel::Luminance)
      : channel;
    if (!status.IsOk())
    {
      return status;
    }
    if (channel == MaskChannel::Alpha && !hasAlpha)
    {
      return {}; // it is opaque
    }
    const Status read = ReadImage(
      source, image, channel == MaskChannel::Alpha ? ImageContent::Opacity : ImageContent::Colors);
    if (!read.IsOk())
    {
      return read;
    }
    mask.Width = image.Header.Width;
    mask.Height = image.Header.Height;
    mask.Values.resize(static_cast<std::size_t>(image.Header.CountPixels()));
  }
  const Weights weights = GetWeights(channel);
  const unsigned char* pixel = image.Pixels.get();
  for (std::size_t i = 0; i < mask.Values.size(); ++i)
  {
    const double value = pixel
      ? weights[0] * pixel[3 * i] + weights[1] * pixel[3 * i + 1] + weights[2] * pixel[3 * i + 2]
      : 255.0;
    mask.Values[i] = static_cast<unsigned char>(std::lround(cutout.Factor * value));
  }
  return {};
}

} // namespace helios
