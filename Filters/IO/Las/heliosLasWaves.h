// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Waveforms as LAS packets: 32-bit samples, in forms that differ in sample count and full scale.

#ifndef heliosLasWaves_h
#define heliosLasWaves_h

#include "heliosLasFormat.h"
#include "heliosStatus.h"
#include "heliosWaveformTable.h"

#include <string>
#include <vector>

namespace helios
{

class LasWaves
{
public:
  ///@{
  /// A form is a sample count (from 16, in steps of a quarter) and a full scale (2^-46 to 4 W, in
  /// steps of 256). Samples keep 23 bits in the finest form that holds a waveform.
  static constexpr int NumberOfLengths = 36;
  static constexpr int NumberOfScales = 7;
  static constexpr int NumberOfForms = NumberOfLengths * NumberOfScales;
  ///@}

  ///@{
  /// Text in the descriptor records. Earlier versions wrote vectors X(t), Y(t), Z(t) that lead away
  /// from the scanner, and used OldDescription.
  static constexpr const char* Description = "waveform [W], to the scanner";
  static constexpr const char* OldDescription = "waveform [W]";
  ///@}

  /// Encodes the descriptor records of all forms; spacing: of samples [ps].
  static std::string EncodeDescriptors(std::uint32_t spacing);
  static constexpr int DescriptorSize = LasRecord::HeadSize + 26;
  static constexpr int FirstDescriptorId = 100;

  /// Encodes the head of a packet file of a given size.
  static std::string EncodeFileHead(std::uint64_t size);

  /// Sets the waveforms (null: none).
  Status Set(vtkTable* waveforms);

  /// Returns the sample spacing [ps]; 0: no waveforms.
  std::uint32_t GetSpacing() const { return this->Spacing; }

  /// Builds a packet for every waveform that a point refers to, the first at a given offset of the
  /// packet file.
  Status MakePackets(const Column& ids, vtkIdType count, std::uint64_t place);
  const std::vector<char>& GetPackets() const { return this->Packets; }

  /// Encodes the fields of a point (29 bytes) at a row: its vector leads to the scanner.
  void EncodePoint(vtkIdType row, const double point[3], char* bytes) const;

private:
  struct Packet
  {
    std::uint64_t Place = 0;
    int Form = 0; // 0: not built
  };

  vtkIdType Find(vtkTypeInt64 pulse) const;
  Status MakePacket(vtkIdType waveform);
  Status CheckSpacing();

  WaveformTable Table;
  std::vector<vtkIdType> Order;       // waveforms by pulse
  std::vector<vtkIdType> RowWaveform; // per point; -1: none
  std::vector<Packet> Made;           // per waveform
  std::vector<char> Packets;
  std::uint64_t Begin = 0;
  std::uint32_t Spacing = 0;
};

} // namespace helios

#endif
