// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosColorMaps.h"

#include <iostream>

int main()
{
  std::cout << "vtkhelios-viewer: nothing to show yet\n";
  return 0;
}
