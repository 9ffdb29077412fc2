// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosScanner
 * @brief   emits the pulses of one leg into a scene and detects the echoes
 *
 * Port 0: the scene (vtkPolyData, triangles; optional: the cell arrays MaterialIds, PartIds and
 * Normals, from which incidence is then measured, and the material columns in its field data). Port
 * 1: the trajectory (vtkPolyData with GpsTime and Orientation, as written by platforms). Port 2,
 * optional and repeatable: turbid voxels (vtkImageData with the cell array PAD [m2/m3]; cell array
 * MaterialIds, field arrays LeafProjection and Part.Name and the material columns are optional), as
 * written by vtkHeliosVoxelReader.
 *
 * Output 0: the echoes, points with GpsTime, PulseIds, ReturnNumber, NumberOfReturns, Range,
 * Amplitude, EchoWidth, ScanAngle, ClassificationIds, MaterialIds, PartIds, CellIds,
 * IncidenceAngle, WaveformIds, LegIds, ChannelIds; Deviation if the detector computes it; TruePoint
 * and Normal with GenerateTruth, and SpecularEvents if surfaces have optics; ScanDirectionFlag and
 * EdgeOfFlightLine with GenerateScanFlags; ScatteredAmplitude and ScatteredDeviation with
 * ScatteringOrders above 1; ColumnIds with GenerateColumns; RelativeAmplitude and
 * Reflectance with GenerateDecibels; RGB with GenerateColors. Output 1, with GenerateWaveforms: the
 * waveforms (vtkTable, one row per pulse with an echo: PulseIds, LegIds, ChannelIds, Origin,
 * Direction, GpsTime, StartTime [ns], BinSize [ns], Offset, Count; Samples [W] in the field data,
 * with one PulseLength [ns]). Output 2, with GeneratePulses: every pulse, an origin with Direction,
 * GpsTime, PulseIds, ScanAngle, LegIds, ChannelIds, Hit. Output 3, with GenerateSubRays: every hit
 * of a sub-ray with PulseIds, Weight, Range, CellIds, IncidenceAngle.
 *
 * Pulse i is emitted at StartTime + i / PulseFrequency, if the deflector emits it; its id is
 * FirstPulseId + i PulseIdStride. The signal of a sub-ray follows the lidar equation of
 * vtkHeliosInstrument and returns after 2 R / c. An echo lies on the axis of the beam at its own
 * range; surface ids belong to the sub-ray nearest in range.
 *
 * With FIXED sampling every pulse has all sub-rays of the BeamSampler, its waveform is summed in
 * bins of BinSize, and the EchoDetector finds the echoes in the float samples; GenerateWaveforms
 * stores these, so the same detector finds the same echoes in them. With TOLERANCE (adaptive
 * sampling) a pulse takes the cheapest method that is exact enough:
 * - its beam hits nothing, or has a planar footprint of one response: no sub-ray; the echo of a
 *   plane has a closed form (not tested in scans where this is rare)
 * - one continuous surface of a few triangles fills it: 16 to 64 sub-rays
 * - otherwise it is divided into the visible parts of the triangles in it; each is two returns,
 *   whose energy, mean range and its spread are exact
 * - full of leaves, it is drawn in as many cells of equal energy as the tolerances require, where
 *   that is faster than the division
 * - with more surfaces than twice the square root of MaximumNumberOfSubRays, the cells are more and
 *   more until two successive answers agree
 * - returns within c sigma of each other have one maximum, found by Newton's method; others are
 *   binned as finely as needed
 *
 * In turbid voxels a sub-ray is stopped in ds with the probability PAD G ds, by a random number
 * keyed by Seed, pulse and sub-ray; G is 0.5, or from the rows x y z G of LeafProjection for its
 * direction. It then returns the signal of a surface of the cell's material at normal incidence (0,
 * no normal). A dense medium thus acts as a plane. Cell ids of voxels follow the ids of the
 * triangles, grid by grid, likewise materials and parts. A beam that may hit voxels takes the
 * spiral at once. The scene may then have no triangles.
 *
 * Detectors that find more than maxima, non-Gaussian pulses, and noise or sunlight need bins for
 * every pulse; BeamDivergence 0 is one ideal ray. DescribeSampling() gives the resulting sub-rays
 * and bins.
 *
 * The pulses of a piece are a contiguous range; outputs are byte-identical for any number of pieces
 * and threads.
 *
 * @sa
 * vtkHeliosBeamDeflector vtkHeliosBeamSampler vtkHeliosEchoDetector vtkHeliosRayCaster
 * vtkHeliosPlatform
 */

#ifndef vtkHeliosScanner_h
#define vtkHeliosScanner_h

#include "vtkHeliosInstrument.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro
#include "vtkSmartPointer.h"            // For the strategies

#include <memory> // For the counts
#include <string> // For descriptions
#include <vector> // For voxel grids

class vtkHeliosBeamDeflector;
class vtkHeliosBeamSampler;
class vtkHeliosEchoDetector;
class vtkHeliosErrorModel;
class vtkHeliosPlatformNoise;
class vtkHeliosRayCaster;
class vtkImageData;

namespace helios
{
class BatchSize;
class InstanceMotions;
class PulseShape;
class TextureStore;
struct SamplingPlan;
struct ScanCounts;
struct ScanTraits;
}

class VTKHELIOSSCANNERCORE_EXPORT vtkHeliosScanner : public vtkHeliosInstrument
{
public:
  static vtkHeliosScanner* New();
  vtkTypeMacro(vtkHeliosScanner, vtkHeliosInstrument);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the ray caster. Default: a vtkHeliosBeamRayCaster.
   */
  void SetRayCaster(vtkHeliosRayCaster* caster);
  vtkHeliosRayCaster* GetRayCaster() const;
  ///@}

  ///@{
  /**
   * Set/Get the deflector: pulse directions and frequency. No default: an error
   * if not set.
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
   * Set/Get the echo detector. Default: a vtkHeliosPeakDetector.
   */
  void SetEchoDetector(vtkHeliosEchoDetector* detector);
  vtkHeliosEchoDetector* GetEchoDetector() const;
  ///@}

  ///@{
  /**
   * Set/Get the systematic errors of the instrument. Default: not set, no
   * error.
   */
  void SetErrorModel(vtkHeliosErrorModel* model);
  vtkHeliosErrorModel* GetErrorModel() const;
  ///@}

  ///@{
  /**
   * Set/Get the noise of the platform about its trajectory. Default: not set.
   */
  void SetPlatformNoise(vtkHeliosPlatformNoise* noise);
  vtkHeliosPlatformNoise* GetPlatformNoise() const;
  ///@}

  /// How the beam is sampled.
  enum Samplings
  {
    FIXED = 0,    ///< always all sub-rays of the BeamSampler, always bins
    TOLERANCE = 1 ///< so few that RangeTolerance and EnergyTolerance hold
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
   * Set/Get the sampling errors allowed, for echoes of at least 2 % of the
   * amplitude of a full footprint: the 95th percentile of the range error [m]; and
   * the fraction of missed and invented echoes, which is also the root mean square
   * of the amplitude error, as a fraction of a full footprint. Valid range: [1e-6, 1] and [1e-4, 1]. Default: 0.001 and 0.01.
   */
  vtkSetMacro(RangeTolerance, double);
  vtkGetMacro(RangeTolerance, double);
  vtkSetMacro(EnergyTolerance, double);
  vtkGetMacro(EnergyTolerance, double);
  ///@}

  ///@{
  /**
   * Set/Get the most sub-rays of a beam with so many surfaces that it must be sampled: with more than
   * twice the square root of this number, 512 by default. Their number, or that of cells, of which
   * there are at most 16 times as many, grows until successive answers agree within the tolerances;
   * GetCount("pulsesUnresolved") counts the pulses for which
   * this limit is too low. Valid range: [1024, 2^24]. Default: 65536.
   */
  vtkSetMacro(MaximumNumberOfSubRays, int);
  vtkGetMacro(MaximumNumberOfSubRays, int);
  ///@}

  ///@{
  /**
   * Set/Get the limits of paths behind mirrors and glass (the optics of materials): the most
   * reflections and refractions, and the least share of the energy of a sub-ray that is followed,
   * out and back. Valid range: [0, 64] and [0, 1]. Default: 8 and 1e-4.
   */
  vtkSetClampMacro(MaximumSpecularEvents, int, vtkHeliosInstrumentRanges::MaximumSpecularEvents.Low,
    vtkHeliosInstrumentRanges::MaximumSpecularEvents.High);
  vtkGetMacro(MaximumSpecularEvents, int);
  vtkSetClampMacro(LeastSpecularShare, double, vtkHeliosInstrumentRanges::LeastSpecularShare.Low,
    vtkHeliosInstrumentRanges::LeastSpecularShare.High);
  vtkGetMacro(LeastSpecularShare, double);
  ///@}

  ///@{
  /**
   * Set/Get the mount of the scanner on its platform: position [m] and attitude
   * (unit quaternion w, x, y, z) in the body frame. Default: at the origin, not
   * rotated.
   */
  vtkSetVector3Macro(MountPosition, double);
  vtkGetVector3Macro(MountPosition, double);
  vtkSetVector4Macro(MountOrientation, double);
  vtkGetVector4Macro(MountOrientation, double);
  ///@}

  ///@{
  /**
   * Set/Get the beam origin, in the frame of the rotating head: position [m]
   * and attitude (unit quaternion w, x, y, z). Default: at the origin, not
   * rotated.
   */
  vtkSetVector3Macro(BeamOrigin, double);
  vtkGetVector3Macro(BeamOrigin, double);
  vtkSetVector4Macro(BeamOrientation, double);
  vtkGetVector4Macro(BeamOrientation, double);
  ///@}

  ///@{
  /**
   * Set/Get the axis of the head rotation, in the frame of the mount. Default:
   * 0, 0, 1.
   */
  vtkSetVector3Macro(HeadRotateAxis, double);
  vtkGetVector3Macro(HeadRotateAxis, double);
  ///@}

  ///@{
  /**
   * Set/Get the head rotation: from HeadRotateStart to HeadRotateStop [deg] at
   * HeadRotateSpeed [deg/s] (negative: reversed). On a static platform the scan
   * ends with it. Valid range: [-1e6, 1e6]. Default: 0.
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
   * Set/Get for how long the platform stands still [s], in steps from StartTime: a pulse has the
   * pose at the beginning of its step. 0: each pulse has its own pose. A scan line as a step shows
   * what the motion within a line changes. Valid range: [0, 1e6]. Default: 0.
   */
  vtkSetClampMacro(PoseInterval, double, 0.0, 1e6);
  vtkGetMacro(PoseInterval, double);
  ///@}

  ///@{
  /**
   * Set/Get whether the orientation of the platform rotates at a constant rate between two samples
   * of its trajectory; else the earlier one holds. Default: on.
   */
  vtkSetMacro(InterpolateOrientation, bool);
  vtkGetMacro(InterpolateOrientation, bool);
  vtkBooleanMacro(InterpolateOrientation, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether a pulse has one echo, the sum of its returns at their mean range weighted by
   * power: the limit of a pulse too long to tell them apart. Of the EchoDetector only the threshold
   * counts. Default: off.
   */
  vtkSetMacro(MergeReturns, bool);
  vtkGetMacro(MergeReturns, bool);
  vtkBooleanMacro(MergeReturns, bool);
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
   * Set/Get the duration of the scan [s]; negative: on a static platform until
   * the head rotation ends, else until the trajectory ends. Valid range:
   * [-1, 1e12]. Default: -1.
   */
  vtkSetClampMacro(Duration, double, -1.0, 1e12);
  vtkGetMacro(Duration, double);
  ///@}

  ///@{
  /**
   * Set/Get the part [t0, t1) of the scan that is computed [s]. Default: all.
   */
  vtkSetVector2Macro(TimeWindow, double);
  vtkGetVector2Macro(TimeWindow, double);
  ///@}

  ///@{
  /**
   * Set/Get the range [i0, i1) of pulse indices that is computed, within TimeWindow. Valid range:
   * 0 <= i0 <= i1. Default: all.
   */
  vtkSetVector2Macro(PulseWindow, vtkIdType);
  vtkGetVector2Macro(PulseWindow, vtkIdType);
  ///@}

  ///@{
  /**
   * Set/Get how many pulses have one that is fired: a sample of the scan, of one pulse anywhere in
   * each PulseStep consecutive ones, chosen by its index and FirstPulseId alone. Valid range: [1, 2^53]. Default:
   * 1, all.
   */
  vtkSetClampMacro(PulseStep, vtkIdType, 1, 9007199254740992LL);
  vtkGetMacro(PulseStep, vtkIdType);
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
   * Set/Get the difference between the ids of consecutive pulses: the number of
   * scanners that fire at once and share their ids, each with its own
   * FirstPulseId. Valid range: [1, 65536]. Default: 1.
   */
  vtkSetClampMacro(PulseIdStride, vtkIdType, 1, 65536);
  vtkGetMacro(PulseIdStride, vtkIdType);
  ///@}

  /**
   * Returns the sampling that results from Sampling and the tolerances, as text.
   */
  std::string DescribeSampling();

  /**
   * Returns the number of pulse indices of the scan (within the windows, if set; in the sample or
   * not), for the current inputs; -1 after an error. Updates the trajectory.
   */
  vtkIdType GetNumberOfPulses();

  /**
   * Returns a count of the last update by its name: "pulsesFired", emitted; "pulsesHit", with a
   * surface in the range gate; "pulsesOnPlane", with a planar footprint, in closed form;
   * "pulsesWithoutBins", with maxima found by Newton's method; "pulsesBinned" (the others hit
   * nothing); "pulsesSampled", by rays, with too many triangles in the beam; "subRays", traced, or
   * visible parts; "hitsOutOfRange", sub-rays that hit a surface outside the range gate; "points",
   * echoes. -1 for any other name.
   */
  vtkIdType GetCount(const std::string& name) const;

  /**
   * Returns the names of the counts of a scan or of a run of vtkHeliosSurveyPlayer, separated by
   * blanks.
   */
  static std::string GetCountNames();

  /**
   * Returns the largest signal of a pulse of the last update [W], detected or not.
   */
  double GetLargestAmplitude() const;

#ifndef __VTK_WRAP__
  /// Sets the motions of the instances of the scene, by MotionIds; null: all are at rest. The ray
  /// caster must be one that supports instances. Pulses are numbered, and timed, as by this scanner.
  void SetMotions(std::shared_ptr<const helios::InstanceMotions> motions);

  /// Sets the textures that the scanners of a scene share; null: the scanner reads them itself.
  void SetTextures(std::shared_ptr<helios::TextureStore> textures);

  /// Returns all counts of the last update.
  const helios::ScanCounts& GetCounts() const
  {
    return *this->Counts;
  }
#endif

  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * Set/Get the zone of multiple-time-around (MTA) ranges that the instrument assigns echoes to, if
   * pulses follow each other before their echoes arrive. 0: it knows the pulse of each echo. Zone
   * z: it takes the pulse of the same channel that is z - 1 before the last one emitted when the
   * echo arrives. Of a pulse frequency f of the channel, zone z are the ranges from (z - 1) c / 2 f
   * to z c / 2 f: its echoes are right, and others differ in range by multiples of c / 2 f, along
   * the beam of the pulse they are assigned to, with its time, id and angles. An echo is lost if
   * there is no such pulse: before the scan, after it, or while a mirror is turned away.
   * ReturnNumber and NumberOfReturns count the echoes of the true pulse, TruePoint is on the
   * target; RangeMin and RangeMax gate true ranges. Not together with GenerateWaveforms. Valid
   * range: [0, 1000]. Default: 0.
   */
  vtkSetClampMacro(
    MTAZone, int, vtkHeliosInstrumentRanges::MTAZone.Low, vtkHeliosInstrumentRanges::MTAZone.High);
  vtkGetMacro(MTAZone, int);
  ///@}

protected:
  vtkHeliosScanner();
  ~vtkHeliosScanner() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  struct Scan;          // input and state of a run
  struct ProbedMotions; // answer of a probe of the beams of a leg

  bool CheckSettings();
  bool PrepareSources(vtkPolyData* trajectory, Scan& scan);
  bool PrepareColors(vtkPolyData* scene, const std::vector<vtkImageData*>& grids, Scan& scan);
  bool PrepareScene(vtkInformationVector** inputs, Scan& scan);
  bool PrepareSearch(vtkInformationVector** inputs, Scan& scan);
  bool PreparePulses(Scan& scan);
  bool PrepareReceiver(Scan& scan);
  void PrepareAir(Scan& scan) const;
  void PrepareBeam(Scan& scan);
  bool FindsPlanes(const Scan& scan);
  helios::ScanTraits GetTraits();
  helios::SamplingPlan PlanSampling(const helios::PulseShape& shape) const;
  bool RunPulses(const Scan& scan, vtkIdType first, vtkIdType last, vtkInformationVector* outputs);
  void WarnOfCounts(bool isWholeScan);
  bool CheckErrorTerms();

  vtkHeliosScanner(const vtkHeliosScanner&) = delete;
  void operator=(const vtkHeliosScanner&) = delete;

  vtkSmartPointer<vtkHeliosRayCaster> RayCaster;
  vtkSmartPointer<vtkHeliosBeamDeflector> BeamDeflector;
  vtkSmartPointer<vtkHeliosBeamSampler> BeamSampler;
  vtkSmartPointer<vtkHeliosEchoDetector> EchoDetector;

  vtkSmartPointer<vtkHeliosErrorModel> ErrorModel;
  vtkSmartPointer<vtkHeliosPlatformNoise> PlatformNoise;

  int Sampling = TOLERANCE;
  double RangeTolerance;
  double EnergyTolerance;
  int MaximumNumberOfSubRays;
  double MountPosition[3] = { 0.0, 0.0, 0.0 };
  double MountOrientation[4] = { 1.0, 0.0, 0.0, 0.0 };
  double BeamOrigin[3] = { 0.0, 0.0, 0.0 };
  double BeamOrientation[4] = { 1.0, 0.0, 0.0, 0.0 };
  double HeadRotateAxis[3] = { 0.0, 0.0, 1.0 };
  double HeadRotateStart = 0.0;
  double HeadRotateStop = 0.0;
  double HeadRotateSpeed = 0.0;
  double PoseInterval = 0.0;
  bool InterpolateOrientation = true;
  bool MergeReturns = false;
  double StartTime = -1.0;
  double Duration = -1.0;
  double TimeWindow[2] = { -VTK_DOUBLE_MAX, VTK_DOUBLE_MAX };
  vtkIdType PulseWindow[2] = { 0, VTK_ID_MAX };
  vtkIdType PulseStep = 1;
  vtkIdType Seed = 0;
  vtkIdType FirstPulseId = 0;
  vtkIdType PulseIdStride = 1;
  int LegId = 0;
  int ChannelId = 0;

  std::unique_ptr<helios::ScanCounts> Counts;
  std::unique_ptr<helios::BatchSize> Batch; // batch size of the last scan
  std::shared_ptr<const helios::InstanceMotions> Motions;
  std::unique_ptr<ProbedMotions> Probed; // answer for the last leg with motions
  std::shared_ptr<helios::TextureStore> SharedTextures;
  std::shared_ptr<helios::TextureStore> Textures; // textures of the scene
  vtkMTimeType ColorTime = 0;                     // the scene's, when its colours were prepared
};

#endif
