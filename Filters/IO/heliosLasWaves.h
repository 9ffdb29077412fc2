// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Waveforms as the packets of a LAS file: 32-bit samples, in forms that differ by their number and
// by what full scale is.

#ifndef heliosLasWaves_h
#define heliosLasWaves_h

#include "heliosLasFormat.h"
#include "heliosWaveformTable.h"

#include <string>
#include <vector>

namespace helios
{

class LasWaves
{
public:
  ///@{
  /// A form is a number of samples (16 and up, each a quarter more) and a full scale (2^-46 to 4 W,
  /// each 256 times the one before): of the finest that holds a waveform its samples keep 23 bits.
  static constexpr int NumberOfLengths = 36;
  static constexpr int NumberOfScales = 7;
  static constexpr int NumberOfForms = NumberOfLengths * NumberOfScales;
  ///@}

  ///@{
  /// What descriptor records say of themselves. Earlier versions wrote vectors X(t), Y(t), Z(t) that
  /// lead away from the scanner, and said OldDescription.
  static constexpr const char* Description = "waveform [W], to the scanner";
  static constexpr const char* OldDescription = "waveform [W]";
  ///@}

  /// The descriptor records of all forms; spacing: of samples [ps].
  static std::string EncodeDescriptors(std::uint32_t spacing);
  static constexpr int DescriptorSize = LasRecord::HeadSize + 26;
  static constexpr int FirstDescriptorId = 100;

  /// The head of a file of packets that has a size.
  static std::string EncodeFileHead(std::uint64_t size);

  /// Takes waveforms (null: none), or says what is wrong with them.
  std::string Take(vtkTable* waveforms);

  /// Of samples [ps]; 0: there are none.
  std::uint32_t GetSpacing() const { return this->Spacing; }

  /// Makes a packet of every waveform that a point names, the first at a place of the file of
  /// packets; says what is wrong, or returns an empty text.
  std::string MakePackets(const Column& ids, vtkIdType count, std::uint64_t place);
  const std::vector<char>& GetPackets() const { return this->Packets; }

  /// The fields of a point (29 bytes) at a row: its vector leads to the scanner.
  void EncodePoint(vtkIdType row, const double point[3], char* bytes) const;

private:
  struct Packet
  {
    std::uint64_t Place = 0;
    int Form = 0; // 0: not made
  };

  vtkIdType Find(vtkTypeInt64 pulse) const;
  std::string MakePacket(vtkIdType waveform);
  std::string CheckSpacing();

  WaveformTable Table;
  std::vector<vtkIdType> Order;       // waveforms by pulse
  std::vector<vtkIdType> RowWaveform; // of every point; -1: none
  std::vector<Packet> Made;           // of every waveform
  std::vector<char> Packets;
  std::uint64_t Begin = 0;
  std::uint32_t Spacing = 0;
};

} // namespace helios

#endif
