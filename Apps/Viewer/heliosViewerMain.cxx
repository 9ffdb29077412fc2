// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosDisplay.h"
#include "heliosViewer.h"
#include "heliosViewerOptions.h"
#include "heliosVisibleText.h"

#include <vtkObject.h>

#include <exception>
#include <iostream>

int main(int argc, char** argv)
{
  const helios::VisibleText visible(std::cerr);
  helios::ViewerOptions options;
  const helios::OptionsResult result = helios::ReadOptions(argc, argv, options);
  if (result != helios::OptionsResult::Go)
  {
    return result == helios::OptionsResult::Done ? 0 : 2;
  }
  const std::string problem = helios::CheckDisplay();
  if (!problem.empty())
  {
    std::cerr << "error: " << problem << "\n";
    return 1;
  }
  helios::ExplainLostDisplay();
  try
  {
    helios::Viewer viewer(options);
    return viewer.Run();
  }
  catch (const std::exception& error) // of libraries, out of memory
  {
    std::cerr << "error: " << error.what() << "\n";
    return 1;
  }
}
