// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosScanPositionPlanner.h"

#include "heliosPlanScenes.h"

#include <catch2/catch.hpp>
#include <cstdio>
#include <ctime>

TEST_CASE("probe", "[probe]")
{
  for (const auto& s : helios::MakePlanScenes())
  {
    vtkNew<vtkHeliosScanPositionPlanner> p;
    p->SetInputData(0, s.GetCandidates());
    p->SetInputData(1, s.GetTestPoints());
    printf("%s: %lld %lld\n", s.Name.c_str(), (long long)s.GetCandidates()->GetNumberOfPoints(),
      (long long)s.GetTestPoints()->GetNumberOfPoints());
    for (int m = 0; m < 6; ++m)
    {
      p->SetMethod(m == 5 ? 1 : m);
      p->SetRemovalOrder(m == 5);
      const clock_t t = clock();
      p->Update();
      printf("  m%d n=%lld cov=%.2f lb=%.3f bb=%lld proved=%d worst=%.4f%c mean=%.4f%c  %.2fs\n", m,
        (long long)p->GetNumberOfSelected(), p->GetCoverage(), p->GetLowerBound(),
        (long long)p->GetBestBound(), p->GetIsProvedOptimal(), p->GetWorstIncidenceAngle(),
        p->GetIsWorstProvedOptimal() ? '*' : ' ', p->GetMeanBestIncidenceAngle(),
        p->GetIsMeanProvedOptimal() ? '*' : ' ', double(clock() - t) / CLOCKS_PER_SEC);
      fflush(stdout);
    }
  }
}
