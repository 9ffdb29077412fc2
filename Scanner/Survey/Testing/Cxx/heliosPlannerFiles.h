// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Planner documents in a separate folder, and their readers.

#ifndef heliosPlannerFiles_h
#define heliosPlannerFiles_h

#include "heliosSurveyFiles.h"
#include "vtkHeliosPlannerReader.h"

namespace helios
{
namespace test
{

/// A reader of a file of a folder.
struct PlannerReading
{
  vtkNew<vtkHeliosPlannerReader> Reader;
  vtkSmartPointer<ErrorObserver> Log = Observe(Reader);
  bool Good = false;

  explicit PlannerReading(
    const Files& files, const std::string& name = "plan.xml", bool asksForAssets = false)
  {
    this->Reader->SetFileName((files / name).c_str());
    if (asksForAssets)
    {
      this->Reader->SetPlatform("assets.xml#tripod");
      this->Reader->SetScanner("assets.xml#tls");
    }
    this->Good = this->Reader->Read();
  }
};

/// Writes a <surveyPlanner> with more attributes and children.
inline const Files& WritePlanner(
  const Files& files, const std::string& more, const std::string& children = "")
{
  files.Write("plan.xml",
    "<document>\n<surveyPlanner id=\"yard\" scene=\"scene.xml#s\" platform=\"assets.xml#tripod\"\n "
    "scanner=\"assets.xml#tls\" " +
      more + ">" + children + "</surveyPlanner>\n</document>");
  return files;
}

} // namespace test
} // namespace helios

#endif
