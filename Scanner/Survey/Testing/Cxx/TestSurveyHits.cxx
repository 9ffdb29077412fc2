// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The hits of sub-rays that a run writes.
#include "heliosSurveyPlaying.h"
#include "vtkHeliosPointXMLReader.h"
#include "vtkHeliosSurveyPlayer.h"
#include "vtkHeliosSurveySource.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

#include <string>

using namespace helios::test;

TEST_CASE("SurveyHits: they are those of the scanner, in any format", "[SurveyHits]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  Playing playing(files, reading);
  const std::string format = GENERATE("xyz", "las", "vtp");
  playing.Player->SetFormat(format.c_str());
  playing.Player->SetWriteHits(true);
  playing.Player->SetPulsesPerBlock(1000);
  REQUIRE(playing.Player->Run());
  vtkNew<vtkHeliosPointXMLReader> file;
  file->SetFileName((files / "out/test/leg000_hits.pvtp").c_str());
  file->Update();
  vtkPolyData* hits = file->GetOutput();

  vtkNew<vtkHeliosSurveySource> source;
  source->SetSurvey(reading.Reader->GetSurvey());
  source->GenerateSubRaysOn();
  source->SetPulseWindow(0, 40000); // leg 0
  source->Update();
  auto* wanted = vtkPolyData::SafeDownCast(source->GetOutputDataObject(3));
  REQUIRE(wanted->GetNumberOfPoints() >= 40000);
  REQUIRE(hits->GetNumberOfPoints() == wanted->GetNumberOfPoints());
  for (const char* name : { "PulseIds", "Weight", "Range", "CellIds", "IncidenceAngle" })
  {
    INFO(name);
    vtkDataArray* column = hits->GetPointData()->GetArray(name);
    vtkDataArray* other = wanted->GetPointData()->GetArray(name);
    REQUIRE((column && other));
    bool isSame = true;
    for (vtkIdType i = 0; i < column->GetNumberOfTuples(); ++i)
    {
      isSame = isSame && column->GetTuple1(i) == other->GetTuple1(i);
    }
    CHECK(isSame);
  }
}
