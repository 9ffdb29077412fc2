// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The waveforms referenced by the points of a LAS file, as a table.

#ifndef heliosLasPackets_h
#define heliosLasPackets_h

#include "heliosLasFile.h"
#include "heliosStatus.h"

#include <vtkType.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <string>
#include <unordered_set>
#include <vector>

class vtkPolyData;
class vtkTable;

namespace helios
{

class LasPackets
{
public:
  /// Opens the packets of a file whose points have waveforms.
  Status Open(const LasFile& file);

  /// Returns a warning for the user about the file; empty: none.
  const std::string& GetWarning() const { return this->Warning; }

  /// Collects the packets of points from their bytes; first is the row of the first one.
  void Add(const char* records, vtkIdType first, vtkIdType count);

  /// Reads the collected packets into a table; cloud has the points.
  Status Read(vtkPolyData* cloud, vtkTable* table);

private:
  struct Descriptor
  {
    int Bits = 0;
    std::uint32_t Count = 0;
    std::uint32_t Spacing = 0; // [ps]
    double Gain = 1.0;
    double Offset = 0.0;
  };

  /// First point that refers to a packet.
  struct Packet
  {
    vtkIdType Row = 0;
    int Index = 0;
    std::uint64_t Place = 0;
    std::uint32_t Size = 0;
    float Location = 0.0F;       // [ps]
    float Step[3] = { 0, 0, 0 }; // [m/ps], away from the scanner
  };

  Status AddDescriptor(const LasRecord& record);
  Status CheckPacket(const Packet& packet) const;
  Status CheckPackets() const;
  Status ReadSamples(const Packet& packet, std::vector<float>& samples);

  /// Returns the total size of the packets [bytes].
  std::uint64_t GetRoom() const { return this->End - std::min(this->End, this->Begin); }

  std::string Path;
  std::string Warning;
  float StepSign = -1.0F; // vectors of points lead to the scanner
  std::ifstream File;
  std::uint64_t Begin = 0; // first byte of the packets in the file
  std::uint64_t End = 0;
  LasPointForm Form;
  int PointLength = 0;
  std::map<int, Descriptor> Descriptors;
  std::unordered_set<std::uint64_t> Places;
  std::vector<Packet> Packets;
  std::vector<char> Bytes;
};

} // namespace helios

#endif
