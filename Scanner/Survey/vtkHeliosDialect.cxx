// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosDialect.h"

#include "heliosXmlNotes.h"
#include "heliosXmlRules.h"
#include "heliosXmlSchema.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkHeliosDialect);

namespace
{

/// " <element name>" if it has no note.
std::string Miss(const std::string& element, const std::string& name)
{
  const bool isKnown = *helios::FindXmlNote(element, name).Text != '\0';
  return isKnown ? std::string() : " <" + element + (name.empty() ? "" : " " + name) + ">";
}

} // namespace

//------------------------------------------------------------------------------
std::string vtkHeliosDialect::GetSchema()
{
  return helios::MakeXmlSchema();
}

//------------------------------------------------------------------------------
std::string vtkHeliosDialect::GetTables()
{
  return helios::MakeXmlTables();
}

//------------------------------------------------------------------------------
std::string vtkHeliosDialect::FindUndescribed()
{
  std::string missed;
  for (const helios::XmlElementRule& rule : helios::GetXmlRules())
  {
    missed += Miss(rule.Name, "");
    for (const helios::XmlValueRule& value : rule.Values)
    {
      missed += Miss(rule.Name, value.Name);
    }
    for (const helios::XmlChildRule& child : rule.Children)
    {
      missed += Miss(child.Name, "");
    }
  }
  return missed;
}
