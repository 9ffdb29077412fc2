// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Captures GDAL messages instead of printing them to the console.

#ifndef heliosGdalMessages_h
#define heliosGdalMessages_h

#include "heliosGdal.h"

#include <string>
#include <vector>

namespace helios
{

/// Collects the GDAL messages of this thread during its lifetime; none goes to the console.
class GdalMessages
{
public:
  GdalMessages() { CPLPushErrorHandlerEx(GdalMessages::Catch, this); }
  ~GdalMessages()
  {
    CPLPopErrorHandler();
    CPLErrorReset();
  }
  GdalMessages(const GdalMessages&) = delete;
  void operator=(const GdalMessages&) = delete;

  std::string Error; ///< first error
  std::vector<std::string> Warnings;

private:
  static void CPL_STDCALL Catch(CPLErr severity, CPLErrorNum, const char* message)
  {
    auto* self = static_cast<GdalMessages*>(CPLGetErrorHandlerUserData());
    if (severity >= CE_Failure && self->Error.empty())
    {
      self->Error = message;
    }
    else if (severity == CE_Warning)
    {
      self->Warnings.emplace_back(message);
    }
  }
};

} // namespace helios

#endif
