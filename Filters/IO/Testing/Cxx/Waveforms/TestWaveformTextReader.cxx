// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosWaveformReading.h"
#include "vtkHeliosWaveformTextWriter.h"

#include <vtkCallbackCommand.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace names = vtkHeliosArrayNames;
using helios::WaveformReading;

namespace
{

const std::string Head = "7 1 2 3 0.6 0 -0.8 ";

} // namespace

TEST_CASE("WaveformTextReader: columns of a line", "[WaveformTextReader]")
{
  WaveformReading reading("# a run\n\n" + Head + "667.1282 667.6282 0.25 1 2.5e3 -0.125\r\n" +
    "\t8 1 2 3\t0 0 1 10 10.2 1e5 4 5 # behind it\n9 0 0 0 1 0 0 -3 -2 0 6 7 8 9 10\n");
  REQUIRE(reading.Read());
  REQUIRE(reading.CountWaveforms() == 3);
  CHECK(reading.Get(names::PulseIds, 0) == 7);
  CHECK(reading.Get(names::PulseIds, 2) == 9);
  CHECK(reading.Get(names::Origin, 1, 2) == 3);
  CHECK(reading.Get(names::Direction, 0, 0) == Approx(0.6).epsilon(1e-15));
  CHECK(reading.Get(names::Direction, 0, 2) == Approx(-0.8).epsilon(1e-15));
  CHECK(reading.Get(names::GpsTime, 1) == 1e5);
  CHECK(reading.Get(names::StartTime, 0) == 667.1282);
  CHECK(reading.Get(names::StartTime, 2) == -3);
  CHECK(reading.Get(names::BinSize, 0) == 0.25);
  CHECK(reading.Get(names::BinSize, 1) == 0.2);
  CHECK(reading.Get(names::BinSize, 2) == 0.25);
  CHECK(reading.GetCount(0) == 3);
  CHECK(reading.GetCount(1) == 2);
  CHECK(reading.Get(names::Offset, 2) == 5);
  CHECK(reading.GetSample(1) == 2.5e-6F);
  CHECK(reading.GetSample(2) == -1.25e-10F);
  CHECK(reading.GetSample(9) == 1e-8F);
}

TEST_CASE("WaveformTextReader: output of the text writer is read back", "[WaveformTextReader]")
{
  WaveformReading reading;
  const std::string path = reading.Folder / "fullwave.txt";
  constexpr vtkIdType count = 3000;
  const auto table = helios::MakeWaveforms(count);
  vtkDataArray* samples = table->GetFieldData()->GetArray(names::Samples);
  for (vtkIdType i = 0; i < samples->GetNumberOfTuples(); ++i)
  {
    const double x = static_cast<double>(i);
    samples->SetComponent(i, 0, 1e-9 * (1.0 + 1e3 * std::abs(std::sin(x)))); // from 1 nW up
  }
  for (vtkIdType i = 0; i < count; ++i) // one sample does not define its bin
  {
    vtkDataArray* counts = table->GetRowData()->GetArray(names::Count);
    vtkDataArray* offsets = table->GetRowData()->GetArray(names::Offset);
    if (counts->GetComponent(i, 0) == 1)
    {
      counts->SetComponent(i, 0, 2);
      offsets->SetComponent(i, 0, std::max(0.0, offsets->GetComponent(i, 0) - 1));
    }
  }
  vtkNew<vtkHeliosWaveformTextWriter> writer;
  writer->SetFileName(path.c_str());
  REQUIRE((writer->Open() && writer->Write(table) && writer->Close()));
  reading.Reader->SetFileName(path.c_str());

  const int pieces = GENERATE(1, 2, 7);
  vtkIdType row = 0;
  vtkIdType wrong = 0;
  for (int piece = 0; piece < pieces; ++piece)
  {
    REQUIRE(reading.Read(piece, pieces));
    for (vtkIdType i = 0; i < reading.CountWaveforms(); ++i, ++row)
    {
      for (const char* name :
        { names::PulseIds, names::GpsTime, names::StartTime, names::BinSize, names::Count })
      {
        wrong +=
          reading.Get(name, i) == table->GetRowData()->GetArray(name)->GetComponent(row, 0) ? 0 : 1;
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        const double origin = table->GetRowData()->GetArray(names::Origin)->GetComponent(row, axis);
        const double direction =
          table->GetRowData()->GetArray(names::Direction)->GetComponent(row, axis);
        wrong += std::abs(reading.Get(names::Origin, i, axis) - origin) < 5.001e-5 ? 0 : 1;
        wrong += std::abs(reading.Get(names::Direction, i, axis) - direction) < 1e-9 ? 0 : 1;
      }
      const auto first =
        static_cast<vtkIdType>(table->GetRowData()->GetArray(names::Offset)->GetComponent(row, 0));
      for (vtkIdType k = 0; k < reading.GetCount(i); ++k)
      {
        const auto offset = static_cast<vtkIdType>(reading.Get(names::Offset, i));
        wrong += reading.GetSample(offset + k) == samples->GetComponent(first + k, 0) ? 0 : 1;
      }
    }
  }
  CHECK(row == count);
  CHECK(wrong == 0);
}

TEST_CASE(
  "WaveformTextReader: bin sizes are accurate to the rounding of the text", "[WaveformTextReader]")
{
  WaveformReading reading(Head + "100.0000 101.0471 0 1 2 3 4\n"); // 3 bins of 0.34903 ns
  REQUIRE(reading.Read());
  CHECK(reading.Get(names::BinSize, 0) == Approx(1.0471 / 3).epsilon(0).margin(1e-4 / 3));
}

TEST_CASE("WaveformTextReader: directions are normalised", "[WaveformTextReader]")
{
  WaveformReading reading("7 0 0 0 0.5774 -0.5774 0.5774 5 5.25 0 1 2\n"); // 4 decimals
  REQUIRE(reading.Read());
  CHECK(reading.Get(names::Direction, 0, 0) == Approx(std::sqrt(1.0 / 3)).epsilon(1e-15));
  CHECK(reading.Get(names::Direction, 0, 1) == Approx(-std::sqrt(1.0 / 3)).epsilon(1e-15));
}

TEST_CASE("WaveformTextReader: one-way times are doubled", "[WaveformTextReader]")
{
  WaveformReading reading(Head + "333.5641 333.8141 0 1 2\n");
  reading.Reader->OneWayTimesOn();
  REQUIRE(reading.Read());
  CHECK(reading.Get(names::StartTime, 0) == 2 * 333.5641);
  CHECK(reading.Get(names::BinSize, 0) == 0.5);
}

TEST_CASE("WaveformTextReader: a given bin size", "[WaveformTextReader]")
{
  WaveformReading reading(Head + "5 5 0 1\n" + Head + "5 5.7499 0 1 2 3 4\n");
  reading.Reader->SetBinSize(0.25);
  REQUIRE(reading.Read());
  CHECK(reading.Get(names::BinSize, 0) == 0.25);
  CHECK(reading.Get(names::BinSize, 1) == 0.25);
  CHECK(reading.FailsWith(
    Head + "5 5.3 0 1 2\n", "a.txt:1: the bins of 0.300000 ns (two-way) do not match BinSize"));
}

TEST_CASE("WaveformTextReader: errors name the line", "[WaveformTextReader]")
{
  WaveformReading reading;
  const std::string good = Head + "5 5.25 0 1 2\n";
  const auto fails = [&reading, &good](const std::string& line, const std::string& part)
  { return reading.FailsWith(good + "# here\n" + line + "\n" + good, "a.txt:3: " + part); };
  CHECK(fails("x" + Head, "\"x7\" in column 0 from 0 (the pulse index) is not a whole number"));
  CHECK(fails("7.5 1 2", "\"7.5\" in column 0 from 0 (the pulse index) is not a whole number"));
  CHECK(fails("99999999999999999999 1", "\"99999999999999999999\" in column 0 from 0 (the pulse"));
  CHECK(fails("7 1 2 3 0 0", "the line ends before column 6 from 0 (direction z); complete it"));
  CHECK(fails(Head + "5 5.25 0", "the line ends before column 10 from 0 (a sample); complete it"));
  CHECK(fails("7 1 2,5 3", "\"2,5\" in column 2 from 0 (origin y) is not a number"));
  CHECK(fails("7 1 1e999 3", "\"1e999\" in column 2 from 0 (origin y) is not a number"));
  CHECK(fails("7 nan 2 3", "the number in column 1 from 0 (origin x) is not finite"));
  CHECK(fails(Head + "5 5.25 0 1 inf", "the number in column 11 from 0 (a sample) is not finite"));
  CHECK(fails(Head + "5 5.25 0 1 x", "\"x\" in column 11 from 0 (a sample) is not a number"));
  CHECK(fails(Head + "5 5.25 0 1 1e60", "the sample in column 11 from 0 (a sample) is beyond"));
  CHECK(fails("7 1 2 3 0 0 0 5 5.25 0 1 2",
    "the direction in columns 4 5 6 from 0 has the length "
    "0.000000; give a vector of length 1"));
  CHECK(fails(
    "7 1 2 3 0 1 1 5 5.25 0 1 2", "the direction in columns 4 5 6 from 0 has the length 1.4142"));
  CHECK(fails(Head + "5.25 5 0 1 2", "the 2 samples last from 5.250000 to 5.000000 ns"));
  CHECK(fails(Head + "5 5 0 1 2", "the 2 samples last from 5.000000 to 5.000000 ns"));
  CHECK(fails(Head + "5 6 0 1", "the 1 samples last from 5.000000 to 6.000000 ns"));
  CHECK(fails(Head + "5 5 0 1", "the waveform has one sample and no bin size; set BinSize"));
  CHECK(
    reading.FailsWith(good + Head + "5 5.25 0 1 2", "a.txt:2: the line has no end: the file was"));
  CHECK(reading.FailsWith("# nothing\n", "a.txt: has no waveforms; give a file of a run with"));
  CHECK(reading.FailsWith("", "a.txt: has no waveforms"));

  reading.Reader->SetFileName((reading.Folder / "none.txt").c_str());
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError("none.txt: cannot be read: No such file or directory"));
  reading.Reader->SetFileName(nullptr);
  reading.Log->Clear();
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError("FileName is not set; give the file of waveforms with SetFileName"));
}

TEST_CASE("WaveformTextReader: an aborted reader has no output", "[WaveformTextReader]")
{
  WaveformReading reading(Head + "5 5.25 0 1 2\n");
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  reading.Reader->AddObserver(vtkCommand::ProgressEvent, stop);
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError("reading was aborted here; update again to read it"));
  CHECK(reading.CountWaveforms() == 0);
}
