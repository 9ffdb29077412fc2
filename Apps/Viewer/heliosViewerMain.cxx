// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosDisplay.h"
#include "heliosStatus.h"
#include "heliosViewer.h"
#include "heliosViewerOptions.h"
#include "heliosVisibleText.h"

#include <vtkObject.h>

#include <exception>
#include <iostream>

int main(int argc, char** argv)
{
  const helios::viewer::VisibleText visible(std::cerr);
  helios::viewer::ViewerOptions options;
  const helios::viewer::OptionsResult result = helios::viewer::ReadOptions(argc, argv, options);
  if (result != helios::viewer::OptionsResult::Go)
  {
    return result == helios::viewer::OptionsResult::Done ? 0 : 2;
  }
  const helios::Status status = helios::viewer::CheckDisplay();
  if (!status.IsOk())
  {
    std::cerr << "error: " << status.Message() << "\n";
    return 1;
  }
  helios::viewer::ExplainLostDisplay();
  try
  {
    helios::viewer::Viewer viewer(options);
    return viewer.Run();
  }
  catch (const std::exception& error) // of libraries, out of memory
  {
    std::cerr << "error: " << error.what() << "\n";
    return 1;
  }
}
