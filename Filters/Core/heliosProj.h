// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// PROJ's objects with owners. Only for the sources of this folder: PROJ shows in no other header.

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

/// A context of PROJ for one thread: without network, its messages kept and not printed.
class ProjContext
{
public:
  ProjContext();
  ~ProjContext();
  ProjContext(const ProjContext&) = delete;
  void operator=(const ProjContext&) = delete;

  PJ_CONTEXT* Get() const { return this->Context; }

  /// What PROJ said last, without the name of the function that said it; empty: nothing.
  std::string TakeMessage();

private:
  PJ_CONTEXT* Context;
  std::string Message;
};

/// The coordinate system that a text means to PROJ; null: none. Texts near a name do not count.
ProjObject MakeProjCRS(const ProjContext& context, const std::string& text);

/// The system without its bound transformation, and of a compound one the horizontal part.
ProjObject GetHorizontalPart(const ProjContext& context, const PJ* crs);

/// The vertical part of a compound system; null: it has none.
ProjObject GetVerticalPart(const ProjContext& context, const PJ* crs);

} // namespace helios

#endif
