// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosScanner
 * @brief   fires the pulses of one leg through a scene and detects the echoes
 *
 * Port 0: the scene (vtkPolyData, triangles; cell arrays MaterialIds, PartIds
 * and Normals, which incidence is then measured from, and the material columns
 * in its field data are optional). Port 1: the trajectory (vtkPolyData with
 * GpsTime and Orientation, as platforms make it). Port 2, optional and repeatable:
 * turbid voxels (vtkImageData with the cell array PAD [m2/m3]; cell array
 * MaterialIds, field arrays LeafProjection and Part.Name and the material columns
 * are optional), as vtkHeliosVoxelReader makes them.
 *
 * Output 0: the echoes, points with GpsTime, PulseIds, ReturnNumber,
 * NumberOfReturns, Range, Amplitude, EchoWidth, ScanAngle, ClassificationIds,
 * MaterialIds, PartIds, CellIds, IncidenceAngle, WaveformIds, LegIds,
 * ChannelIds; Deviation where the detector gives it; TruePoint and Normal with
 * GenerateTruth. Output 1, with GenerateWaveforms: the waveforms (vtkTable, one row
 * a pulse with an echo: PulseIds, LegIds, ChannelIds, Origin, Direction,
 * GpsTime, StartTime [ns], BinSize [ns], Offset, Count; Samples [W] in the field
 * data, with one PulseLength [ns]). Output 2, with GeneratePulses: every pulse, an
 * origin with Direction, GpsTime, PulseIds, ScanAngle, LegIds, ChannelIds, Hit.
 * Output 3, with GenerateSubRays: every hit of a sub-ray with PulseIds, Weight,
 * Range, CellIds, IncidenceAngle.
 *
 * Pulse i leaves at StartTime + i / PulseFrequency, where the deflector lets it
 * out; its id is FirstPulseId + i PulseIdStride. What a sub-ray returns is the lidar equation
 * of vtkHeliosInstrument, and it returns after 2 R / c. An echo lies on the axis of
 * the beam at its own range; surface ids are those of the sub-ray nearest in
 * range.
 *
 * With FIXED sampling every pulse is all the sub-rays of the BeamSampler, its
 * waveform is summed in bins of BinSize, and the EchoDetector finds the echoes in
 * the float samples: what GenerateWaveforms stores, so that the same detector
 * finds the same echoes there again. With TOLERANCE a pulse takes the cheapest of
 * the ways that are exact enough:
 * - its beam meets nothing, or one plane alone: no sub-ray; a plane's echo is
 *   known in closed form (not asked in scans where it is rarely so)
 * - a few sub-rays, 21 unless tolerances are narrow, find no edge: they are its
 *   returns
 * - else it is sampled by Vogel's spiral, with as many sub-rays as an edge needs;
 *   4 or 16 times as many (more where tolerances are wide) along a surface so
 *   steep that these would be echoes; where the spiral is no more than those few,
 *   it is cast at once
 * - returns within c sigma of each other have one maximum, found by Newton's
 *   method; others are binned as finely as needed
 *
 * In turbid voxels a sub-ray is stopped in ds with the probability PAD G ds, by a
 * random number keyed by Seed, pulse and sub-ray; G is 0.5, or of the rows x y z G
 * of LeafProjection that of its direction. It then returns what a surface of the
 * cell's material returns that faces the beam (incidence 0, no normal). So a
 * dense medium is a plane to it. Cell ids of voxels follow those of the triangles,
 * grid by grid, materials and parts likewise. A beam that may meet voxels takes the
 * spiral at once. The scene may then have no triangles.
 *
 * Detectors that find more than maxima, pulses that are no Gaussians, and noise
 * or sunlight need bins for every pulse; BeamDivergence 0 is one ideal ray.
 * DescribeSampling() says what the tolerances come to.
 *
 * The pulses of a piece are a contiguous range; pieces and threads do not
 * change a byte.
 *
 * @sa
 * vtkHeliosBeamDeflector vtkHeliosBeamSampler vtkHeliosEchoDetector
 * vtkHeliosRayCaster vtkHeliosPlatform
 */

#ifndef vtkHeliosScanner_h
#define vtkHeliosScanner_h

#include "vtkHeliosInstrument.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro
#include "vtkSmartPointer.h"            // For the strategies

#include <string> // For what is said in words

class vtkHeliosBeamDeflector;
class vtkHeliosBeamSampler;
class vtkHeliosEchoDetector;
class vtkHeliosErrorModel;
class vtkHeliosPlatformNoise;
class vtkHeliosRayCaster;

namespace helios
{
struct ScanCounts;
}

class VTKHELIOSSCANNERCORE_EXPORT vtkHeliosScanner : public vtkHeliosInstrument
{
public:
  static vtkHeliosScanner* New();
  vtkTypeMacro(vtkHeliosScanner, vtkHeliosInstrument);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get how the scene is searched. Default: Embree where it is built, else
   * the own hierarchy.
   */
  void SetRayCaster(vtkHeliosRayCaster* caster);
  vtkHeliosRayCaster* GetRayCaster() const;
  ///@}

  ///@{
  /**
   * Set/Get where pulses leave, and how often. No default: an error without.
   */
  void SetBeamDeflector(vtkHeliosBeamDeflector* deflector);
  vtkHeliosBeamDeflector* GetBeamDeflector() const;
  ///@}

  ///@{
  /**
   * Set/Get the sub-rays of a pulse. Default: a vtkHeliosBeamSampler, 16
   * sub-rays over a divergence of 0.3 mrad.
   */
  void SetBeamSampler(vtkHeliosBeamSampler* sampler);
  vtkHeliosBeamSampler* GetBeamSampler() const;
  ///@}

  ///@{
  /**
   * Set/Get what makes echoes of waveforms. Default: a vtkHeliosPeakDetector.
   */
  void SetEchoDetector(vtkHeliosEchoDetector* detector);
  vtkHeliosEchoDetector* GetEchoDetector() const;
  ///@}

  ///@{
  /**
   * Set/Get what the instrument gets wrong in a way that can be written down.
   * Default: none, no error.
   */
  void SetErrorModel(vtkHeliosErrorModel* model);
  vtkHeliosErrorModel* GetErrorModel() const;
  ///@}

  ///@{
  /**
   * Set/Get how the platform shakes about its trajectory. Default: none.
   */
  void SetPlatformNoise(vtkHeliosPlatformNoise* noise);
  vtkHeliosPlatformNoise* GetPlatformNoise() const;
  ///@}

  /// How the beam is sampled.
  enum Samplings
  {
    FIXED = 0,    ///< always all sub-rays of the BeamSampler, always bins
    TOLERANCE = 1 ///< as few as RangeTolerance and EnergyTolerance allow
  };

  ///@{
  /**
   * Set/Get how the beam is sampled. Default: TOLERANCE.
   */
  vtkSetClampMacro(Sampling, int, FIXED, TOLERANCE);
  vtkGetMacro(Sampling, int);
  void SetSamplingToFixed() { this->SetSampling(FIXED); }
  void SetSamplingToTolerance() { this->SetSampling(TOLERANCE); }
  ///@}

  ///@{
  /**
   * Set/Get the errors that the sampling may make, as root mean squares over the
   * echoes of a scene: in range [m], and in amplitude as a share of what the pulse
   * returns in all. Valid range:
   * [1e-6, 1] and [1e-4, 1]. Default: 0.001 and 0.01.
   */
  vtkSetMacro(RangeTolerance, double);
  vtkGetMacro(RangeTolerance, double);
  vtkSetMacro(EnergyTolerance, double);
  vtkGetMacro(EnergyTolerance, double);
  ///@}

  ///@{
  /**
   * Set/Get the scanner on its platform: position [m] and attitude (unit
   * quaternion w, x, y, z) in the body frame. Default: at the origin, upright.
   */
  vtkSetVector3Macro(MountPosition, double);
  vtkGetVector3Macro(MountPosition, double);
  vtkSetVector4Macro(MountOrientation, double);
  vtkGetVector4Macro(MountOrientation, double);
  ///@}

  ///@{
  /**
   * Set/Get where the beam leaves, in the frame of the rotating head: position
   * [m] and attitude (unit quaternion w, x, y, z). Default: at the origin,
   * upright.
   */
  vtkSetVector3Macro(BeamOrigin, double);
  vtkGetVector3Macro(BeamOrigin, double);
  vtkSetVector4Macro(BeamOrientation, double);
  vtkGetVector4Macro(BeamOrientation, double);
  ///@}

  ///@{
  /**
   * Set/Get the axis that the head turns about, in the frame of the mount.
   * Default: 0, 0, 1.
   */
  vtkSetVector3Macro(HeadRotateAxis, double);
  vtkGetVector3Macro(HeadRotateAxis, double);
  ///@}

  ///@{
  /**
   * Set/Get the turn of the head: from HeadRotateStart to HeadRotateStop [deg]
   * at HeadRotateSpeed [deg/s] (negative: the other way round). On a platform
   * that stands, the scan ends with it. Valid range: [-1e6, 1e6]. Default: 0.
   */
  vtkSetClampMacro(HeadRotateStart, double, -1e6, 1e6);
  vtkGetMacro(HeadRotateStart, double);
  vtkSetClampMacro(HeadRotateStop, double, -1e6, 1e6);
  vtkGetMacro(HeadRotateStop, double);
  vtkSetClampMacro(HeadRotateSpeed, double, -1e6, 1e6);
  vtkGetMacro(HeadRotateSpeed, double);
  ///@}

  ///@{
  /**
   * Set/Get the time of pulse 0 [s]; negative: the trajectory's first. Valid
   * range: [-1, 1e12]. Default: -1.
   */
  vtkSetClampMacro(StartTime, double, -1.0, 1e12);
  vtkGetMacro(StartTime, double);
  ///@}

  ///@{
  /**
   * Set/Get how long pulses are fired [s]; negative: on a platform that stands
   * until the head has turned, else until the trajectory ends. Valid range:
   * [-1, 1e12]. Default: -1.
   */
  vtkSetClampMacro(Duration, double, -1.0, 1e12);
  vtkGetMacro(Duration, double);
  ///@}

  ///@{
  /**
   * Set/Get the part [t0, t1) of the scan that is computed [s]. Default: all of
   * it.
   */
  vtkSetVector2Macro(TimeWindow, double);
  vtkGetVector2Macro(TimeWindow, double);
  ///@}

  ///@{
  /**
   * Set/Get the part [i0, i1) of the scan's pulse indices that is computed, of those in TimeWindow. Valid
   * range: 0 <= i0 <= i1. Default: all of them.
   */
  vtkSetVector2Macro(PulseWindow, vtkIdType);
  vtkGetVector2Macro(PulseWindow, vtkIdType);
  ///@}

  ///@{
  /**
   * Set/Get the key of all random numbers. Valid range: [0, 2^62]. Default: 0.
   */
  vtkSetClampMacro(Seed, vtkIdType, 0, 4611686018427387904LL);
  vtkGetMacro(Seed, vtkIdType);
  ///@}

  ///@{
  /**
   * Set/Get the id of pulse 0, and the ids of leg and channel that the outputs
   * carry. Default: 0.
   */
  vtkSetMacro(FirstPulseId, vtkIdType);
  vtkGetMacro(FirstPulseId, vtkIdType);
  vtkSetMacro(LegId, int);
  vtkGetMacro(LegId, int);
  vtkSetMacro(ChannelId, int);
  vtkGetMacro(ChannelId, int);
  ///@}

  ///@{
  /**
   * Set/Get by how much the ids of two pulses in a row differ: the number of
   * scanners that fire at once and share their ids, each with a FirstPulseId of
   * its own. Valid range: [1, 65536]. Default: 1.
   */
  vtkSetClampMacro(PulseIdStride, vtkIdType, 1, 65536);
  vtkGetMacro(PulseIdStride, vtkIdType);
  ///@}

  ///@{
  /**
   * Set/Get which outputs are computed beside the echoes. Default: off.
   */
  vtkSetMacro(GenerateWaveforms, bool);
  vtkGetMacro(GenerateWaveforms, bool);
  vtkBooleanMacro(GenerateWaveforms, bool);
  vtkSetMacro(GeneratePulses, bool);
  vtkGetMacro(GeneratePulses, bool);
  vtkBooleanMacro(GeneratePulses, bool);
  vtkSetMacro(GenerateSubRays, bool);
  vtkGetMacro(GenerateSubRays, bool);
  vtkBooleanMacro(GenerateSubRays, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether the echoes carry TruePoint, where the light came from without
   * any error of the instrument, and Normal, of the surface there. Default: off.
   */
  vtkSetMacro(GenerateTruth, bool);
  vtkGetMacro(GenerateTruth, bool);
  vtkBooleanMacro(GenerateTruth, bool);
  ///@}

  /**
   * What Sampling and the tolerances come to, in words.
   */
  std::string DescribeSampling();

  /**
   * The number of pulse indices of the scan (of the windows, where any is
   * set), for the inputs as they are; -1 after an error. Updates the
   * trajectory.
   */
  vtkIdType GetNumberOfPulses();

  ///@{
  /**
   * Get the counts of the last update: pulses that left the scanner; pulses with
   * a surface in the measured ranges; of these and others those whose beam met
   * one plane, in closed form, those whose maxima were found by Newton's method,
   * and those that were binned (the rest met nothing); sub-rays traced, and those
   * that met a surface outside the measured ranges; and the largest signal of a
   * pulse [W], detected or not.
   */
  vtkGetMacro(NumberOfPulsesFired, vtkIdType);
  vtkGetMacro(NumberOfPulsesHit, vtkIdType);
  vtkGetMacro(NumberOfPulsesOnPlane, vtkIdType);
  vtkGetMacro(NumberOfPulsesWithoutBins, vtkIdType);
  vtkGetMacro(NumberOfPulsesBinned, vtkIdType);
  vtkGetMacro(NumberOfSubRays, vtkIdType);
  vtkGetMacro(NumberOfHitsOutOfRange, vtkIdType);
  vtkGetMacro(LargestAmplitude, double);
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkHeliosScanner();
  ~vtkHeliosScanner() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  struct Scan; // what a run needs to know

  bool CheckSettings();
  bool PrepareSources(vtkPolyData* trajectory, Scan& scan);
  bool PrepareScene(vtkInformationVector** inputs, Scan& scan);
  bool PrepareSearch(vtkInformationVector** inputs, Scan& scan);
  bool PreparePulses(Scan& scan);
  bool PrepareReceiver(Scan& scan);
  void PrepareBeam(Scan& scan);
  bool RunPulses(const Scan& scan, vtkIdType first, vtkIdType last, vtkInformationVector* outputs);
  void TakeCounts(const helios::ScanCounts& counts, bool isWholeScan);
  bool CheckErrorTerms(const helios::ScanCounts& counts);

  vtkHeliosScanner(const vtkHeliosScanner&) = delete;
  void operator=(const vtkHeliosScanner&) = delete;

  vtkSmartPointer<vtkHeliosRayCaster> RayCaster;
  vtkSmartPointer<vtkHeliosBeamDeflector> BeamDeflector;
  vtkSmartPointer<vtkHeliosBeamSampler> BeamSampler;
  vtkSmartPointer<vtkHeliosEchoDetector> EchoDetector;

  vtkSmartPointer<vtkHeliosErrorModel> ErrorModel;
  vtkSmartPointer<vtkHeliosPlatformNoise> PlatformNoise;

  int Sampling = TOLERANCE;
  double RangeTolerance = 1e-3;
  double EnergyTolerance = 1e-2;
  double MountPosition[3] = { 0.0, 0.0, 0.0 };
  double MountOrientation[4] = { 1.0, 0.0, 0.0, 0.0 };
  double BeamOrigin[3] = { 0.0, 0.0, 0.0 };
  double BeamOrientation[4] = { 1.0, 0.0, 0.0, 0.0 };
  double HeadRotateAxis[3] = { 0.0, 0.0, 1.0 };
  double HeadRotateStart = 0.0;
  double HeadRotateStop = 0.0;
  double HeadRotateSpeed = 0.0;
  double StartTime = -1.0;
  double Duration = -1.0;
  double TimeWindow[2] = { -VTK_DOUBLE_MAX, VTK_DOUBLE_MAX };
  vtkIdType PulseWindow[2] = { 0, VTK_ID_MAX };
  vtkIdType Seed = 0;
  vtkIdType FirstPulseId = 0;
  vtkIdType PulseIdStride = 1;
  int LegId = 0;
  int ChannelId = 0;
  bool GenerateWaveforms = false;
  bool GeneratePulses = false;
  bool GenerateSubRays = false;
  bool GenerateTruth = false;

  vtkIdType NumberOfPulsesFired = 0;
  vtkIdType NumberOfPulsesHit = 0;
  vtkIdType NumberOfPulsesOnPlane = 0;
  vtkIdType NumberOfPulsesWithoutBins = 0;
  vtkIdType NumberOfPulsesBinned = 0;
  vtkIdType NumberOfSubRays = 0;
  vtkIdType NumberOfHitsOutOfRange = 0;
  double LargestAmplitude = 0.0;
};

#endif
