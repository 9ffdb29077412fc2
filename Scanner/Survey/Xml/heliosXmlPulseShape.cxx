// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlPulseShape.h"

#include "heliosMessages.h"
#include "vtkHeliosGpsTime.h"
#include "vtkHeliosInstrument.h"

#include <filesystem>
#include <system_error>

namespace helios
{
namespace fs = std::filesystem;

//------------------------------------------------------------------------------
bool SetPulseShape(ReceiverData& receiver, const XmlValue& value, Messages& log)
{
  const std::string& shape = value.Text;
  if (shape.empty() || shape == "gaussian" || shape == "helios")
  {
    receiver.PulseShape =
      shape == "helios" ? vtkHeliosInstrument::HELIOS : vtkHeliosInstrument::GAUSSIAN;
    receiver.PulseFile.clear();
    return true;
  }
  std::error_code ignored;
  for (const fs::path& path : { fs::path(value.Folder) / shape, fs::path(shape) })
  {
    if (fs::is_regular_file(path, ignored))
    {
      receiver.PulseShape = vtkHeliosInstrument::SAMPLED;
      receiver.PulseFile = path.string();
      return true;
    }
  }
  log.Error(value.Where + ": " + value.Name + "=\"" + shape +
    "\" is neither a pulse shape nor a file: expected gaussian, helios, or a text file of times "
    "[ns] and powers");
  return false;
}

//------------------------------------------------------------------------------
std::string GetPulseShape(const ReceiverData& receiver)
{
  return receiver.PulseShape == vtkHeliosInstrument::HELIOS ? "helios" : receiver.PulseFile;
}

//------------------------------------------------------------------------------
bool SetGpsStart(std::string& start, const XmlValue& value, Messages& log)
{
  const std::string fault =
    value.Text.empty() ? std::string() : vtkHeliosGpsTime::GetFault(value.Text);
  if (!fault.empty())
  {
    log.Error(value.Where + ": " + value.Name + "=\"" + value.Text + "\" " + fault);
    return false;
  }
  start = value.Text;
  return true;
}

//------------------------------------------------------------------------------
std::string GetGpsStart(const std::string& start)
{
  return start;
}

} // namespace helios
