// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBeamTable.h"

#include "heliosMessages.h"
#include "heliosRowTable.h"

namespace helios
{

//------------------------------------------------------------------------------
void ReadBeamTable(const std::string& path, std::vector<BeamData>& beams, Messages& log)
{
  const auto make = [&](const std::string& where) -> void*
  {
    if (beams.size() == MaximumBeams)
    {
      log.Error(where + ": more than " + std::to_string(MaximumBeams) + " beams; remove some");
      return nullptr;
    }
    return &beams.emplace_back();
  };
  RowTable table("beam", log);
  table.AddRequired("elevation_deg", "the angle above the horizon [deg]");
  if (table.ReadFile(path, make) && beams.empty())
  {
    log.Error(path +
      ": has no beams; give a line with the names of columns, such as "
      "elevation_deg,azimuth_deg, and a line per beam");
  }
}

} // namespace helios
