// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosProj.h"

#include <vtksys/SystemTools.hxx>

namespace helios
{

namespace
{

void KeepMessage(void* kept, int, const char* text)
{
  *static_cast<std::string*>(kept) = text;
}

ProjObject Clone(const ProjContext& context, const PJ* object)
{
  return ProjObject(proj_clone(context.Get(), object));
}

/// "EPSG:n", WKT, JSON, a PROJ string: what is not a plain name.
bool IsDefinition(const std::string& text)
{
  return text.find_first_of(":[{+=") != std::string::npos;
}

} // namespace

//------------------------------------------------------------------------------
ProjContext::ProjContext()
  : Context(proj_context_create())
{
  proj_log_func(this->Context, &this->Message, KeepMessage);
  proj_context_set_enable_network(this->Context, 0);
}

//------------------------------------------------------------------------------
ProjContext::~ProjContext()
{
  proj_context_destroy(this->Context);
}

//------------------------------------------------------------------------------
std::string ProjContext::TakeMessage()
{
  std::string message;
  std::swap(message, this->Message);
  const std::size_t colon = message.find(": ");
  return message.compare(0, 5, "proj_") == 0 && colon != std::string::npos
    ? message.substr(colon + 2)
    : message;
}

//------------------------------------------------------------------------------
ProjObject MakeProjCRS(const ProjContext& context, const std::string& text)
{
  const bool isProjString = text.find("+proj=") != std::string::npos ||
    text.find("+init=") != std::string::npos || text.compare(0, 5, "proj=") == 0;
  const bool isWhole = text.find("type=crs") != std::string::npos;
  const std::string whole = text + (isProjString && !isWhole ? " +type=crs" : "");
  const bool isText = text.find('\0') == std::string::npos;
  ProjObject crs(isText ? proj_create(context.Get(), whole.c_str()) : nullptr);
  if (!crs || !proj_is_crs(crs.get()))
  {
    return nullptr;
  }
  // PROJ takes "foo" for Amersfoort.
  const bool isNamed = vtksys::SystemTools::LowerCase(proj_get_name(crs.get())) ==
    vtksys::SystemTools::LowerCase(text);
  return IsDefinition(text) || isNamed ? std::move(crs) : nullptr;
}

//------------------------------------------------------------------------------
ProjObject GetHorizontalPart(const ProjContext& context, const PJ* crs)
{
  switch (proj_get_type(crs))
  {
    case PJ_TYPE_BOUND_CRS:
    {
      const ProjObject base(proj_get_source_crs(context.Get(), crs));
      return GetHorizontalPart(context, base.get());
    }
    case PJ_TYPE_COMPOUND_CRS:
    {
      const ProjObject part(proj_crs_get_sub_crs(context.Get(), crs, 0));
      return GetHorizontalPart(context, part.get());
    }
    default:
      return Clone(context, crs);
  }
}

//------------------------------------------------------------------------------
ProjObject GetVerticalPart(const ProjContext& context, const PJ* crs)
{
  ProjObject part;
  if (proj_get_type(crs) == PJ_TYPE_BOUND_CRS)
  {
    const ProjObject base(proj_get_source_crs(context.Get(), crs));
    return GetVerticalPart(context, base.get());
  }
  if (proj_get_type(crs) == PJ_TYPE_COMPOUND_CRS)
  {
    part.reset(proj_crs_get_sub_crs(context.Get(), crs, 1));
    if (part && proj_get_type(part.get()) == PJ_TYPE_BOUND_CRS)
    {
      part.reset(proj_get_source_crs(context.Get(), part.get()));
    }
  }
  return part;
}

} // namespace helios
