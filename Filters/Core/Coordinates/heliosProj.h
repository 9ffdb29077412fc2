// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// RAII wrappers of PROJ objects. Internal to this folder: no other header includes PROJ.

#ifndef heliosProj_h
#define heliosProj_h

#include <proj.h>

#include <memory>
#include <string>

namespace helios
{

struct ProjDeleter
{
  void operator()(PJ* object) const { proj_destroy(object); }
  void operator()(PJ_OBJ_LIST* list) const { proj_list_destroy(list); }
  void operator()(PJ_OPERATION_FACTORY_CONTEXT* factory) const
  {
    proj_operation_factory_context_destroy(factory);
  }
};
using ProjObject = std::unique_ptr<PJ, ProjDeleter>;
using ProjList = std::unique_ptr<PJ_OBJ_LIST, ProjDeleter>;
using ProjFactory = std::unique_ptr<PJ_OPERATION_FACTORY_CONTEXT, ProjDeleter>;

/// PROJ context of one thread: no network; messages are stored, not printed.
class ProjContext
{
public:
  ProjContext();
  ~ProjContext();
  ProjContext(const ProjContext&) = delete;
  void operator=(const ProjContext&) = delete;

  PJ_CONTEXT* Get() const { return this->Context; }

  /// Returns and clears the last message of PROJ, without the function name; empty: none.
  std::string ReleaseMessage();

private:
  PJ_CONTEXT* Context;
  std::string Message;
};

/// Parses a coordinate system with PROJ; null on failure. Approximate names are rejected.
ProjObject MakeProjCRS(const ProjContext& context, const std::string& text);

/// Returns the system without its bound transformation; for a compound system its horizontal part.
ProjObject GetHorizontalPart(const ProjContext& context, const PJ* crs);

/// Returns the vertical part of a compound system; null if it has none.
ProjObject GetVerticalPart(const ProjContext& context, const PJ* crs);

} // namespace helios

#endif
