// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosEchoAlgorithm
 * @brief   superclass of algorithms that compute echoes, and the table of their outputs
 *
 * Output 0: the echoes. Output 1, with GenerateWaveforms: the waveforms (vtkTable). Output 2, with
 * GeneratePulses: the pulses. Output 3, with GenerateSubRays: the hits of sub-rays. What is not
 * requested is not computed; vtkHeliosScanner describes the arrays.
 *
 * Everything that a run can make besides the echoes is a row of the table in
 * vtkHeliosEchoAlgorithm.cxx: GetOutputText() returns it for the command line, Python, reports and
 * documents. vtkHeliosSurveyPlayer writes the same outputs to files.
 *
 * @sa
 * vtkHeliosScanner vtkHeliosSurveySource vtkHeliosSurveyPlayer
 */

#ifndef vtkHeliosEchoAlgorithm_h
#define vtkHeliosEchoAlgorithm_h

#include "vtkHeliosScannerCoreModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For names of fields
#include <vector> // For the table

// Set, Get, On and Off of an output, in a class with a member Wanted of type
// vtkHeliosEchoAlgorithm::Outputs.
#define vtkHeliosOutputMacro(name, output)                                                         \
  virtual void Set##name(bool isWanted)                                                            \
  {                                                                                                \
    if (this->Wanted.output != isWanted)                                                           \
    {                                                                                              \
      this->Wanted.output = isWanted;                                                              \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  virtual bool Get##name()                                                                         \
  {                                                                                                \
    return this->Wanted.output;                                                                    \
  }                                                                                                \
  vtkBooleanMacro(name, bool)

// These of all outputs that files can have.
#define vtkHeliosFileOutputsMacro()                                                                \
  vtkHeliosOutputMacro(WriteWaveforms, Waveforms);                                                 \
  vtkHeliosOutputMacro(WaveformsInPoints, WaveformsInPoints);                                      \
  vtkHeliosOutputMacro(WriteScanFlags, ScanFlags);                                                 \
  vtkHeliosOutputMacro(WriteDecibels, Decibels);                                                   \
  vtkHeliosOutputMacro(WriteColors, Colors);                                                       \
  vtkHeliosOutputMacro(WritePulses, Pulses);                                                       \
  vtkHeliosOutputMacro(WriteHits, SubRays);                                                        \
  vtkHeliosOutputMacro(WriteTruth, Truth);                                                         \
  vtkHeliosOutputMacro(WriteVelocities, Velocities);                                               \
  vtkHeliosOutputMacro(WriteMotion, Motion);                                                       \
  vtkHeliosOutputMacro(WriteColumns, Columns);                                                     \
  vtkHeliosOutputMacro(SplitByChannel, SplitByChannel)

class VTKHELIOSSCANNERCORE_EXPORT vtkHeliosEchoAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkHeliosEchoAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the outputs computed in addition to the echoes. Default: off.
   */
  vtkHeliosOutputMacro(GenerateWaveforms, Waveforms);
  vtkHeliosOutputMacro(GeneratePulses, Pulses);
  vtkHeliosOutputMacro(GenerateSubRays, SubRays);
  ///@}

  ///@{
  /**
   * Set/Get whether the echoes have TruePoint, the point hit, without any
   * instrument error, and Normal, of the surface there; in scenes with mirrors or glass also
   * SpecularEvents, how many of them were on the way. Default: off.
   */
  vtkHeliosOutputMacro(GenerateTruth, Truth);
  ///@}

  ///@{
  /**
   * Set/Get whether the echoes have RadialVelocity [m/s], the rate of the distance between the
   * origin of the pulse and the point hit, as instruments with frequency modulation measure it:
   * positive if they move apart. Platform, head and parts of the scene move; noise does not count.
   * NaN behind mirrors and glass, and without a surface. Default: off.
   */
  vtkHeliosOutputMacro(GenerateVelocities, Velocities);
  ///@}

  ///@{
  /**
   * Set/Get whether the echoes have PartPosition [m] and PartOrientation, the shift of the centroid
   * of their part and its rotation (quaternion w x y z) since the start of the survey, and
   * PartVelocity [m/s], the velocity of the point hit; 0 and no rotation for parts at rest. Default:
   * off.
   */
  vtkHeliosOutputMacro(GenerateMotion, Motion);
  ///@}

  ///@{
  /**
   * Set/Get whether the echoes have ScanDirectionFlag and EdgeOfFlightLine, the flags of their
   * pulse by the deflector; 0 for a deflector without lines. Default: off.
   */
  vtkHeliosOutputMacro(GenerateScanFlags, ScanFlags);
  ///@}

  ///@{
  /**
   * Set/Get whether the echoes, and the pulses, have ColumnIds: the column of a
   * pulse in its revolution, from 0, of a deflector that fires in columns. With
   * ChannelIds it is the pixel of an organized cloud. Default: off.
   */
  vtkHeliosOutputMacro(GenerateColumns, Columns);
  ///@}

  ///@{
  /**
   * Set/Get whether the echoes have the amplitudes that instruments of RIEGL report:
   * RelativeAmplitude, 10 log10(P / P0) of their amplitude P above the
   * DetectionThreshold P0 [dB], and Reflectance, 10 log10(P / Pw) above the
   * amplitude Pw that a white diffuse plane across the whole beam has at the same
   * range [dB]. DetectionThreshold and AveragePower must be positive then. Default: off.
   */
  vtkHeliosOutputMacro(GenerateDecibels, Decibels);
  ///@}

  ///@{
  /**
   * Set/Get whether the echoes have RGB (float, [0..1]), the colour of the surface where the echo
   * is: the cell data RGB of the scene, else the point data RGB between the corners, else the base
   * colour of the material (Material.Color) times its texture, bilinear (Material.Texture, and cell
   * data TextureCoordinates); black without. A texture that cannot be read is an error;
   * vtkHeliosImageReader lists the formats. They are read again once the scene changes.
   * vtkHeliosSurveySource reads its meshes with their colours then; see ReadColors of
   * vtkHeliosObjSceneReader and PassColors of vtkHeliosSceneComposer. Default: off.
   */
  vtkHeliosOutputMacro(GenerateColors, Colors);
  ///@}

  ///@{
  /**
   * Get a field of a row of the table of outputs: "name", of options, such as "scan_flags";
   * "source" and "player", the properties of this class and of vtkHeliosSurveyPlayer, the first empty
   * for outputs of files only; "key", in the options of run_summary.json; "arrays" and "formats",
   * names separated by blanks; "title" and "state", of a report, if it is on; "help", of the command
   * line. Null for another row or field.
   */
  static int GetNumberOfOutputs();
  static const char* GetOutputText(int output, const std::string& field);
  ///@}

#ifndef __VTK_WRAP__
  /// Outputs that are computed and written besides the echoes.
  struct Outputs
  {
    static constexpr int NumberOfPorts = 4; // echoes, waveforms, pulses, hits of sub-rays

    // output ports
    bool Waveforms = false;
    bool Pulses = false;
    bool SubRays = false; ///< their hits

    // arrays of the echoes
    bool Truth = false;
    bool Velocities = false; ///< radial ones
    bool Motion = false;     ///< motion of parts
    bool ScanFlags = false;
    bool Columns = false; ///< also of the pulses
    bool Decibels = false;
    bool Colors = false;

    // files
    bool WaveformsInPoints = false; ///< LAS: in one file with the points
    bool SplitByChannel = false;

    /// Returns whether an output port of the scanner has data.
    bool HasPort(int port) const
    {
      const bool ports[NumberOfPorts] = { true, this->Waveforms, this->Pulses, this->SubRays };
      return ports[port];
    }
  };

  /// A row of the table of outputs, with the fields of GetOutputText().
  struct OutputRow
  {
    bool Outputs::*Flag;
    const char* Name;
    const char* Property;
    const char* FileProperty;
    const char* Key;
    bool IsListedIfOff; ///< in run_summary.json
    const char* Arrays;
    const char* Formats;
    const char* Title;
    const char* State;
    const char* Help;
  };
  static const std::vector<OutputRow>& GetOutputRows();

  /// Sets or gets all properties of outputs.
  void SetWantedOutputs(const Outputs& wanted);
  const Outputs& GetWantedOutputs() const
  {
    return this->Wanted;
  }
#endif

protected:
  vtkHeliosEchoAlgorithm();
  ~vtkHeliosEchoAlgorithm() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

#ifndef __VTK_WRAP__
  Outputs Wanted;
#endif

private:
  vtkHeliosEchoAlgorithm(const vtkHeliosEchoAlgorithm&) = delete;
  void operator=(const vtkHeliosEchoAlgorithm&) = delete;
};

#endif
