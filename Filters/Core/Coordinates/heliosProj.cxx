// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosProj.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cctype>
#include <cstring>

namespace helios
{

namespace
{

void StoreMessage(void* kept, int, const char* text)
{
  *static_cast<std::string*>(kept) = text;
}

ProjObject Clone(const ProjContext& context, const PJ* object)
{
  return ProjObject(proj_clone(context.Get(), object));
}

bool IsProjString(const std::string& text)
{
  return text.find("proj=") != std::string::npos || text.find("+init=") != std::string::npos;
}

/// Returns whether a text is WKT, JSON, a PROJ string, "EPSG:n", "urn:ogc:def:crs:EPSG::n" or
/// "http://...".
bool IsDefinition(const std::string& text)
{
  const auto isOfCode = [](unsigned char c) { return std::isalnum(c) || std::strchr("_:+.-/", c); };
  const bool isCode =
    text.find(':') != std::string::npos && std::all_of(text.begin(), text.end(), isOfCode);
  return isCode || IsProjString(text) || text.find_first_of("[{") != std::string::npos;
}

/// Returns whether a text is the exact name of a system, or several joined by plus signs. PROJ
/// itself accepts approximate names: "foo" for Amersfoort.
bool IsName(const ProjContext& context, const std::string& text)
{
  const PJ_TYPE types[] = { PJ_TYPE_CRS };
  const ProjList exact(
    proj_create_from_name(context.Get(), nullptr, text.c_str(), types, 1, false, 1, nullptr));
  return (exact && proj_list_get_count(exact.get()) > 0) || text.find(" + ") != std::string::npos;
}

} // namespace

//------------------------------------------------------------------------------
ProjContext::ProjContext()
  : Context(proj_context_create())
{
  proj_log_func(this->Context, &this->Message, StoreMessage);
  proj_context_set_enable_network(this->Context, 0);
}

//------------------------------------------------------------------------------
ProjContext::~ProjContext()
{
  proj_context_destroy(this->Context);
}

//------------------------------------------------------------------------------
std::string ProjContext::ReleaseMessage()
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
  const bool isDefinition = IsDefinition(text);
  if (text.find('\0') != std::string::npos || (!isDefinition && !IsName(context, text)))
  {
    return nullptr;
  }
  const bool isWhole = !IsProjString(text) || text.find("type=crs") != std::string::npos;
  ProjObject crs(proj_create(context.Get(), (text + (isWhole ? "" : " +type=crs")).c_str()));
  if (!crs || !proj_is_crs(crs.get()))
  {
    return nullptr;
  }
  const bool isNamed = vtksys::SystemTools::LowerCase(proj_get_name(crs.get())) ==
    vtksys::SystemTools::LowerCase(text);
  return isDefinition || isNamed ? std::move(crs) : nullptr;
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
