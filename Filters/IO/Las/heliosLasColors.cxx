// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLasColors.h"

#include "heliosLasFile.h"
#include "heliosStatus.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace helios
{

namespace
{

constexpr const char* OwnSoftware = "vtkHelios ";

int FindLargest(const char* record, int place, int count)
{
  int largest = 0;
  for (int k = 0; k < count; ++k)
  {
    largest = std::max<int>(largest, LoadLas<std::uint16_t>(record + place + 2 * k));
  }
  return largest;
}

bool IsOf8(int largest)
{
  return largest > 0 && largest <= LasColorBits::LargestOf8;
}

} // namespace

//------------------------------------------------------------------------------
Status FindColorBits(LasFile& file, LasColorBits& bits)
{
  bits = LasColorBits();
  const LasHeader& header = file.GetHeader();
  const LasPointForm form = GetLasPointForm(header.Format);
  if (form.Color < 0 || header.Software.rfind(OwnSoftware, 0) == 0)
  {
    return {};
  }
  const auto length = static_cast<std::uint64_t>(header.PointLength);
  const std::uint64_t round = file.GetPointsPerRound();
  std::vector<char> bytes(std::min(round, header.Points.Count) * length);
  int colors = 0;
  int infrared = 0;
  for (std::uint64_t first = 0; first < header.Points.Count; first += round)
  {
    const std::uint64_t count = std::min(round, header.Points.Count - first);
    if (const Status status = file.Read(first, count, bytes.data()); !status.IsOk())
    {
      return status;
    }
    for (std::uint64_t i = 0; i < count; ++i)
    {
      const char* record = bytes.data() + i * length;
      colors = std::max(colors, FindLargest(record, form.Color, 3));
      infrared = form.Infrared < 0 ? 0 : std::max(infrared, FindLargest(record, form.Infrared, 1));
    }
    if (colors > LasColorBits::LargestOf8)
    {
      return {};
    }
  }
  bits.AreColors8 = IsOf8(colors);
  bits.IsInfrared8 = bits.AreColors8 && IsOf8(infrared);
  return {};
}

} // namespace helios
