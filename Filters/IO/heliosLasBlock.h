// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Echoes as the points of a LAS file, format 6 or 7, with waveforms 9 or 10, and what is written
// beside them.

#ifndef heliosLasBlock_h
#define heliosLasBlock_h

#include "heliosColumn.h"
#include "heliosLasFormat.h"

#include <vtkSmartPointer.h>

#include <atomic>
#include <string>
#include <vector>

class vtkPolyData;

namespace helios
{

class LasWaves;

/// How numbers become those of LAS.
struct LasScaling
{
  std::array<double, 3> Scale{ 1.0, 1.0, 1.0 };
  std::array<double, 3> Offset{};
  double FullIntensity = 0.0; ///< [W]; 0: hundredths of a decibel over 1 fW
  double TimeShift = 0.0;     ///< [s], added
};

class LasBlock
{
public:
  /// Takes the arrays of echoes with double points, or says what is wrong: "the array ... holds".
  std::string Take(vtkPolyData* echoes, bool hasExtras);

  /// Before Take(): points have waveforms, whose packets are made before Encode().
  void SetWaves(const LasWaves* waves) { this->Waves = waves; }

  /// The waveforms that the points name; not set: they name none.
  const Column& GetWaveformIds() const { return this->WaveformIds; }

  int GetFormat() const
  {
    return this->Waves ? (this->Color.IsSet() ? 10 : 9) : (this->Color.IsSet() ? 7 : 6);
  }
  int GetPointLength() const { return this->Length; }
  const std::vector<LasExtra>& GetExtras() const { return this->Extras; }

  /// Scale 0 becomes a power of ten that fits the points; the offset is the first of them in whole
  /// units, which is the same for blocks of any size.
  void ChooseScaling(LasScaling& scaling, double scale) const;

  /// Writes points begin to end; false where one of them cannot be: see Explain().
  bool Encode(const LasScaling& scaling, vtkIdType begin, vtkIdType end, char* records);

  /// What is wrong with the first point from begin on that cannot be written, or empty.
  std::string Explain(const LasScaling& scaling, vtkIdType begin, vtkIdType end) const;

  ///@{
  /// What did not fit: returns beyond the 15th, classes beyond 0 to 255. Counted over all Encode().
  vtkIdType GetNumberOfLateReturns() const { return this->LateReturns; }
  vtkIdType GetNumberOfOddClasses() const { return this->OddClasses; }
  ///@}

private:
  /// An array beside the fields of LAS: its bytes, as they go to the file.
  struct Extra
  {
    const char* Values;
    int Size;   // of a tuple [bytes]
    int Number; // of one number
    int Place;  // in the point
  };

  std::string TakeColumn(vtkPolyData* echoes, const char* name, bool isInteger, Column& column);
  std::string TakeFields(vtkPolyData* echoes);
  std::string TakeExtras(vtkPolyData* echoes);
  std::string AddExtra(vtkDataArray* array);
  bool EncodeFields(const LasScaling& scaling, vtkIdType row, char* record);
  void EncodeColor(vtkIdType row, char* record) const;
  std::uint16_t GetIntensity(const LasScaling& scaling, vtkIdType row) const;
  std::string ExplainRow(const LasScaling& scaling, vtkIdType row) const;

  Column Points, Amplitude, Intensity, ReturnNumber, NumberOfReturns, Flags, Channel, Direction,
    Edge, Class, UserData, ScanAngle, Leg, Time, Color, WaveformIds;
  const LasWaves* Waves = nullptr;
  int WavePlace = -1;
  double FullColor = 1.0;
  int Length = 30;
  vtkIdType NumberOfPoints = 0;
  std::vector<LasExtra> Extras;
  std::vector<Extra> ExtraValues;
  std::vector<vtkSmartPointer<vtkDataArray>> Copies; // of arrays in another layout
  std::atomic<vtkIdType> LateReturns{ 0 };
  std::atomic<vtkIdType> OddClasses{ 0 };
};

} // namespace helios

#endif
