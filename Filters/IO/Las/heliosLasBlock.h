// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Echoes as the points of a LAS file, format 6, 7 or 8, with waveforms 9 or 10, and the options for
// writing them.

#ifndef heliosLasBlock_h
#define heliosLasBlock_h

#include "heliosColumn.h"
#include "heliosLasFormat.h"
#include "heliosStatus.h"

#include <vtkSmartPointer.h>

#include <atomic>
#include <string>
#include <vector>

class vtkPolyData;

namespace helios
{

class LasWaves;

/// Conversion of values to values of LAS.
struct LasScaling
{
  std::array<double, 3> Scale{ 1.0, 1.0, 1.0 };
  std::array<double, 3> Offset{};
  double FullIntensity = 0.0; ///< [W]; 0: 0.01 dB relative to 1 fW
  double TimeShift = 0.0;     ///< [s], added
};

class LasBlock
{
public:
  /// Reads the arrays of echoes with double points. Returns an error: "the array ... holds".
  Status Set(vtkPolyData* echoes, bool hasExtras);

  /// Sets the waveforms of the points, before Set(); their packets are built before Encode().
  void SetWaves(const LasWaves* waves) { this->Waves = waves; }

  /// Returns the waveform ids of the points; not set if points have none.
  const Column& GetWaveformIds() const { return this->WaveformIds; }

  int GetFormat() const
  {
    const bool hasInfrared = this->Infrared.IsSet();
    return this->Waves ? (this->Color.IsSet() || hasInfrared ? 10 : 9)
                       : (hasInfrared ? 8 : (this->Color.IsSet() ? 7 : 6));
  }
  int GetPointLength() const { return this->Length; }
  const std::vector<LasExtra>& GetExtras() const { return this->Extras; }

  /// Encodes points begin to end; false if a point cannot be encoded: see CheckRange().
  bool Encode(const LasScaling& scaling, vtkIdType begin, vtkIdType end, char* records);

  /// Returns an error about the first point from begin on that cannot be encoded.
  Status CheckRange(const LasScaling& scaling, vtkIdType begin, vtkIdType end) const;

  ///@{
  /// Values out of range: returns above 15, classes outside 0 to 255. Summed over all Encode().
  vtkIdType GetNumberOfLateReturns() const { return this->LateReturns; }
  vtkIdType GetNumberOfOddClasses() const { return this->OddClasses; }
  ///@}

private:
  /// An array outside the LAS fields: its bytes, as written to the file.
  struct Extra
  {
    const char* Values;
    int Size;   // size of a tuple [bytes]
    int Number; // size of one number
    int Place;  // in the point record
  };

  Status ReadColumn(vtkPolyData* echoes, const char* name, bool isInteger, Column& column);
  Status ReadFields(vtkPolyData* echoes);
  Status ReadExtras(vtkPolyData* echoes);
  Status AddExtra(vtkDataArray* array, bool hasDecibels);
  bool EncodeFields(const LasScaling& scaling, vtkIdType row, char* record);
  void EncodeColor(vtkIdType row, char* record) const;
  std::uint16_t GetIntensity(const LasScaling& scaling, vtkIdType row) const;
  std::string ExplainRow(const LasScaling& scaling, vtkIdType row) const;

  Column Points, Amplitude, Intensity, ReturnNumber, NumberOfReturns, Flags, Channel, Direction,
    Edge, Class, UserData, ScanAngle, Leg, Time, Color, Infrared, WaveformIds;
  const LasWaves* Waves = nullptr;
  int WavePlace = -1;
  int InfraredPlace = -1;
  bool HasColors = false;
  double FullColor = 1.0;
  int Length = 30;
  vtkIdType NumberOfPoints = 0;
  std::vector<LasExtra> Extras;
  std::vector<Extra> ExtraValues;
  std::vector<vtkSmartPointer<vtkDataArray>> Copies; // copies of arrays with another layout
  std::atomic<vtkIdType> LateReturns{ 0 };
  std::atomic<vtkIdType> OddClasses{ 0 };
};

} // namespace helios

#endif
