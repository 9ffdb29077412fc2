// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosInstrument
 * @brief   the data sheet of a laser scanner: pulse, receiver, accuracy
 *
 * The properties of an instrument that do not depend on its position or the
 * scene; used by vtkHeliosScanner. Sub-ray k of the beam, with the weight W,
 * that hits a surface at range R and incidence angle theta returns
 * - P = AveragePower W f(theta) D^2 / (4 R^2) eta exp(-2 alpha R)
 *
 * with the ReceiverDiameter D, the OpticalEfficiency eta, the extinction alpha
 * and, for a surface of reflectance rho, specularity s and exponent n,
 * - f = rho ((1 - s) cos(theta) + s (n + 2) / 2 max(0, cos(2 theta))^n cos(theta))
 *
 * that is pi times the bidirectional reflectance times cos(theta): Lambert and a
 * Phong lobe that conserves energy (Wagner et al. 2006, ISPRS J. 60, 100-112;
 * Lewis 1994). P returns after 2 R / c as a pulse with the peak P.
 *
 * Values outside their range are rejected at execution, with an error that
 * states the range.
 *
 * @sa
 * vtkHeliosScanner vtkHeliosEchoDetector vtkHeliosErrorModel
 */

#ifndef vtkHeliosInstrument_h
#define vtkHeliosInstrument_h

#include "vtkHeliosEchoAlgorithm.h"
#include "vtkHeliosInstrumentData.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro
#include "vtkSmartPointer.h"            // For the samples of a pulse

#include <string> // For error messages

namespace helios
{
class PulseShape;
class Status;
struct Air;
}
class vtkDataArray;

// The values are members, for the macros of VTK; its wrappers know one superclass.
#ifndef __VTK_WRAP__
#define vtkHeliosInstrumentValues , protected vtkHeliosInstrumentData
#else
#define vtkHeliosInstrumentValues
#endif

// The properties ReturnSelection and MaximumNumberOfReturns of a class with these members; VTK's
// wrappers need each macro in one line.
// clang-format off
#define vtkHeliosReturnsMacro()                                                                    \
  vtkSetClampMacro(ReturnSelection, int, vtkHeliosInstrument::ALL, vtkHeliosInstrument::FIRST_AND_LAST); \
  vtkGetMacro(ReturnSelection, int);                                                               \
  void SetReturnSelectionToAll() { this->SetReturnSelection(vtkHeliosInstrument::ALL); }           \
  void SetReturnSelectionToFirst() { this->SetReturnSelection(vtkHeliosInstrument::FIRST); }       \
  void SetReturnSelectionToLast() { this->SetReturnSelection(vtkHeliosInstrument::LAST); }         \
  void SetReturnSelectionToStrongest() { this->SetReturnSelection(vtkHeliosInstrument::STRONGEST); } \
  void SetReturnSelectionToFirstAndLast() { this->SetReturnSelection(vtkHeliosInstrument::FIRST_AND_LAST); } \
  vtkSetClampMacro(MaximumNumberOfReturns, int, 0, vtkHeliosInstrumentRanges::LargestNumberOfReturns); \
  vtkGetMacro(MaximumNumberOfReturns, int)
// clang-format on

class VTKHELIOSSCANNERCORE_EXPORT vtkHeliosInstrument
  : public vtkHeliosEchoAlgorithm vtkHeliosInstrumentValues
{
public:
  vtkTypeMacro(vtkHeliosInstrument, vtkHeliosEchoAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The shape of the transmitted pulse.
  enum PulseShapes
  {
    GAUSSIAN = 0, ///< exp(-t^2 / (2 sigma^2))
    HELIOS = 1,   ///< (t / tau)^2 exp(-t / tau), tau = PulseLength / 3.3947
    SAMPLED = 2   ///< the samples of PulseFileName or PulseSamples
  };

  /// Which echoes of a pulse are kept.
  enum ReturnSelections
  {
    ALL = 0,
    FIRST = 1,
    LAST = 2,
    STRONGEST = 3,
    FIRST_AND_LAST = 4
  };

  /// How a turbid voxel scatters light that is scattered more than once.
  enum ScatteringPhases
  {
    LEAF = 0,     ///< by Lambertian leaves of all orientations
    ISOTROPIC = 1 ///< alike into all directions, with an albedo of 4 times the reflectance
  };

  ///@{
  /**
   * Set/Get the full width at half maximum of the transmitted pulse [ns]; not
   * used with a sampled pulse. Valid range: [1e-3, 1e6]. Default: 4.
   */
  vtkSetMacro(PulseLength, double);
  vtkGetMacro(PulseLength, double);
  ///@}

  ///@{
  /**
   * Set/Get the shape of the transmitted pulse; its peak is 1, at the time of
   * the pulse. Default: GAUSSIAN.
   */
  vtkSetClampMacro(PulseShape, int, GAUSSIAN, SAMPLED);
  vtkGetMacro(PulseShape, int);
  void SetPulseShapeToGaussian() { this->SetPulseShape(GAUSSIAN); }
  void SetPulseShapeToHelios() { this->SetPulseShape(HELIOS); }
  void SetPulseShapeToSampled() { this->SetPulseShape(SAMPLED); }
  ///@}

  ///@{
  /**
   * Set/Get the text file of a sampled pulse: a time [ns] and a power in any unit
   * per line, with a blank, a comma or a semicolon between them, times increasing,
   * # for comments; linear between samples. Powers may be negative, their integral
   * is positive; only the shape counts, it is scaled to a peak of 1. The times of
   * the detector are corrected, so that a plane across the beam is at its range.
   * Default: not set.
   */
  void SetPulseFileName(VTK_FILEPATH const char* fileName);
  VTK_FILEPATH const char* GetPulseFileName() const
  {
    return this->PulseFile.empty() ? nullptr : this->PulseFile.c_str();
  }
  ///@}

  ///@{
  /**
   * Set/Get the same as an array, n rows of a time [ns] and a power; used without
   * a PulseFileName. Default: not set.
   */
  void SetPulseSamples(vtkDataArray* samples);
  vtkDataArray* GetPulseSamples() const;
  ///@}

  ///@{
  /**
   * Set/Get the bin size of the waveform [ns]. Valid range: [1e-4, half the
   * pulse]. Default: 0.25.
   */
  vtkSetMacro(BinSize, double);
  vtkGetMacro(BinSize, double);
  ///@}

  ///@{
  /**
   * Set/Get the maximum length of a waveform [ns], or its maximum number of bins,
   * from its first bin; 0: as long as the target. Later bins are cut off, with a
   * warning that counts the pulses. Valid range: 0 or at least a pulse. Default: 0.
   */
  vtkSetMacro(MaximumWaveformLength, double);
  vtkGetMacro(MaximumWaveformLength, double);
  vtkSetMacro(NumberOfBins, int);
  vtkGetMacro(NumberOfBins, int);
  ///@}

  ///@{
  /**
   * Set/Get the transmitted power in the lidar equation [W]. Valid range:
   * [0, 1e12]. Default: 4.
   */
  vtkSetMacro(AveragePower, double);
  vtkGetMacro(AveragePower, double);
  ///@}

  ///@{
  /**
   * Set/Get the wavelength [nm]. Valid range: [200, 20000]. Default: 1064.
   */
  vtkSetMacro(Wavelength, double);
  vtkGetMacro(Wavelength, double);
  ///@}

  ///@{
  /**
   * Set/Get the efficiency of the optics. Valid range: (0, 1]. Default: 0.99.
   */
  vtkSetMacro(OpticalEfficiency, double);
  vtkGetMacro(OpticalEfficiency, double);
  ///@}

  ///@{
  /**
   * Set/Get the diameter of the receiver [m]. Valid range: (0, 100].
   * Default: 0.15.
   */
  vtkSetMacro(ReceiverDiameter, double);
  vtkGetMacro(ReceiverDiameter, double);
  ///@}

  ///@{
  /**
   * Set/Get the meteorological visibility [km]; the extinction follows by Kruse;
   * infinite: no extinction. Valid range: [1e-3, infinity]. Default: 23.
   */
  vtkSetMacro(AtmosphericVisibility, double);
  vtkGetMacro(AtmosphericVisibility, double);
  ///@}

  ///@{
  /**
   * Set/Get the extinction of the air [1/m], one way; negative: from
   * AtmosphericVisibility. Valid range: [-1, 1e3]. Default: -1.
   */
  vtkSetMacro(AtmosphericExtinction, double);
  vtkGetMacro(AtmosphericExtinction, double);
  ///@}

  ///@{
  /**
   * Set/Get the lidar ratio of the air [sr]: its extinction over its backscatter,
   * 18.8 for fog. The air then scatters light back, which makes echoes near the
   * scanner; 0: none. Valid range: [0, 1e6]. Default: 0.
   */
  vtkSetMacro(AtmosphericLidarRatio, double);
  vtkGetMacro(AtmosphericLidarRatio, double);
  ///@}

  ///@{
  /**
   * Set/Get the diameter of the drops that cause the extinction of the air, such as rain [m]: with
   * a lidar ratio, single ones return light at random places, in beams with a divergence. 0: so
   * many that the air is homogeneous. Valid range: [0, 0.05]. Default: 0.
   */
  vtkSetMacro(DropletDiameter, double);
  vtkGetMacro(DropletDiameter, double);
  ///@}

  ///@{
  /**
   * Set/Get a kind of weather and its amount, such as "fog 0.2": fog, smoke or
   * dust with the visibility [km], rain, snow or sleet [mm/h]. It replaces the
   * extinction, the lidar ratio and the drops (Docs/instrument.md, Weather). clear or empty:
   * none. Default: none.
   */
  vtkSetMacro(Weather, const std::string&);
  vtkGetMacro(Weather, std::string);
  ///@}

  ///@{
  /**
   * Set/Get the most scatterings of the light on its way from the scanner over surfaces and leaves
   * to the receiver; the number of paths that are drawn at random for each pulse, on which their
   * standard error depends; and how turbid voxels scatter. Light whose last scatterer lies within
   * FieldOfView, or in the cone of the beam if that is wider, returns half the length of its path
   * as range (Docs/scattering.md). Valid range: [1, 64] and [8, 65536], rounded up to a multiple of
   * 8. Default: 1, only the first, 128 and LEAF.
   */
  vtkSetMacro(ScatteringOrders, int);
  vtkGetMacro(ScatteringOrders, int);
  vtkSetMacro(ScatteringPaths, int);
  vtkGetMacro(ScatteringPaths, int);
  vtkSetClampMacro(ScatteringPhase, int, LEAF, ISOTROPIC);
  vtkGetMacro(ScatteringPhase, int);
  void SetScatteringPhaseToLeaf() { this->SetScatteringPhase(LEAF); }
  void SetScatteringPhaseToIsotropic() { this->SetScatteringPhase(ISOTROPIC); }
  ///@}

  ///@{
  /**
   * Set/Get the standard deviation of the detector noise, drawn per bin [W].
   * With noise or sunlight every pulse is binned. Valid range: [0, 1e6].
   * Default: 0.
   */
  vtkSetMacro(DetectorNoise, double);
  vtkGetMacro(DetectorNoise, double);
  ///@}

  ///@{
  /**
   * Set/Get the power at which the receiver saturates [W]: larger samples of a
   * waveform are clipped to it, after noise and sunlight; 0: never. Then every
   * pulse is binned. Valid range: [0, 1e6]. Default: 0.
   */
  vtkSetMacro(SaturationPower, double);
  vtkGetMacro(SaturationPower, double);
  ///@}

  ///@{
  /**
   * Set/Get the solar irradiance on the scene [W/m^2/nm] (0.6 at 1064 nm on a
   * clear day), the bandwidth of the receiver's filter [nm] and its field of
   * view, a full angle [rad]. A surface of reflectance rho that fills the field
   * of view adds
   * - E rho / pi (pi FieldOfView^2 / 4) (pi D^2 / 4) FilterBandwidth eta exp(-alpha R)
   *
   * to every bin. Valid range: [0, 1e6]. Default: 0 (off), 1 and 0.001.
   */
  vtkSetMacro(SolarIrradiance, double);
  vtkGetMacro(SolarIrradiance, double);
  vtkSetMacro(FilterBandwidth, double);
  vtkGetMacro(FilterBandwidth, double);
  vtkSetMacro(FieldOfView, double);
  vtkGetMacro(FieldOfView, double);
  ///@}

  ///@{
  /**
   * Set/Get the standard deviation of the range noise, drawn per echo: constant
   * [m], proportional to the range [m/m], and for an echo at the detection
   * threshold [m] (inversely proportional to the amplitude, the Cramer-Rao bound);
   * contributions add in quadrature. Valid range: [0, 1e3]. Default: 0, no noise.
   */
  vtkSetMacro(RangeAccuracy, double);
  vtkGetMacro(RangeAccuracy, double);
  vtkSetMacro(RangeAccuracyPerMeter, double);
  vtkGetMacro(RangeAccuracyPerMeter, double);
  vtkSetMacro(RangeAccuracyAtThreshold, double);
  vtkGetMacro(RangeAccuracyAtThreshold, double);
  ///@}

  ///@{
  /**
   * Set/Get the standard deviation of the direction, on each of two axes across
   * the beam [rad]: the pulse is emitted along the direction with the error,
   * and its points are placed along the one without. Valid range: [0, 0.1].
   * Default: 0.
   */
  vtkSetMacro(AngleAccuracy, double);
  vtkGetMacro(AngleAccuracy, double);
  ///@}

  ///@{
  /**
   * Set/Get the range gate of the instrument [m]. A surface outside it blocks a
   * sub-ray and returns nothing. Valid range: [0, infinity]. Default: 0 and
   * infinity.
   */
  vtkSetMacro(RangeMin, double);
  vtkGetMacro(RangeMin, double);
  vtkSetMacro(RangeMax, double);
  vtkGetMacro(RangeMax, double);
  ///@}

  ///@{
  /**
   * Set/Get which echoes of a pulse are kept, which NumberOfReturns counts, and the maximum number of
   * these, in order of range; 0: all. Valid range: [0, 255]. Default: ALL and 0.
   */
  vtkHeliosReturnsMacro();
  ///@}

#ifndef __VTK_WRAP__
  /// Sets or gets all values.
  void SetInstrument(const vtkHeliosInstrumentData& values);
  const vtkHeliosInstrumentData& GetInstrument() const
  {
    return *this;
  }
#endif

protected:
  vtkHeliosInstrument();
  ~vtkHeliosInstrument() override;

  /// Returns whether all values are in range; otherwise reports an error that names the first
  /// invalid one.
  bool CheckInstrument();

  /// Returns the air in use; valid after CheckInstrument().
  helios::Air ComputeAir() const;

  /// Returns the sunlight from a white surface, without extinction, at the receiver [W].
  double ComputeBackground() const;

  /// Returns the maximum number of samples of a waveform.
  vtkIdType CountSamples() const;

  /// Builds the pulse and checks it against the bins.
  helios::Status MakePulseShape(helios::PulseShape& shape) const;

  vtkSmartPointer<vtkDataArray> PulseSamples;

private:
  vtkHeliosInstrument(const vtkHeliosInstrument&) = delete;
  void operator=(const vtkHeliosInstrument&) = delete;
};

#endif
