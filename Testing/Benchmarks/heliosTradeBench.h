// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A scanner over a scene, whose beams are sampled in one way or another.

#ifndef heliosTradeBench_h
#define heliosTradeBench_h

#include "heliosTradeErrors.h"
#include "heliosTradeScenes.h"

#include "vtkHeliosBeamSampler.h"
#include "vtkHeliosPeakDetector.h"
#include "vtkHeliosScanner.h"
#include "vtkHeliosStaticPlatform.h"
#ifdef HELIOS_HAS_DETECTORS
#include "vtkHeliosGaussianDecomposition.h"
#endif

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace helios::bench
{

constexpr double PulseLength = 4.0;                                          // [ns]
constexpr double Separation = SpeedOfLight * PulseLength / 2.35482004503095; // c sigma [m]

/// A method of beam sampling and echo detection.
struct Way
{
  std::string Pattern; // "GL", "circles", "Vogel", "tolerance"
  int Size = 0;        // rings, circles or sub-rays
  double BinSize = 0.25;
  std::string Detector = "peaks";
  double RangeTolerance = 0.0;

  bool IsByTolerance() const { return this->Pattern == "tolerance"; }
};

inline Way ByTolerance(double range, const char* detector = "peaks")
{
  return { "tolerance", 0, 0.25, detector, range };
}

/// A scanner over one of the scenes.
class Bench
{
public:
  Bench(const TradeScene& scene, int side)
    : Pulses(side * side)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->InsertNextPoint((scene.From + scene.Offset).GetData());
    vtkNew<vtkPolyData> waypoint;
    waypoint->SetPoints(points);
    this->Tripod->SetInputData(waypoint);
    this->Aim->Directions = GetDirections(scene, side);
    this->Scanner->SetInputData(0, scene.Mesh);
    this->Scanner->SetInputConnection(1, this->Tripod->GetOutputPort());
    this->Scanner->SetBeamDeflector(this->Aim);
    this->Scanner->SetPulseLength(PulseLength);
    this->Scanner->SetAtmosphericExtinction(0.0);
    this->Scanner->GetBeamSampler()->SetBeamDivergence(scene.Divergence);
    this->Scanner->GetBeamSampler()->SetTruncation(Truncation);
    const Vec3 middle = scene.Corner + 0.5 * scene.U + 0.5 * scene.V;
    this->Threshold = 0.02 * this->GetFullAmplitude((middle - scene.From).Norm());
  }

  /// Amplitude of a plane across the whole beam [W].
  double GetFullAmplitude(double range)
  {
    const double d = this->Scanner->GetReceiverDiameter();
    return this->Scanner->GetAveragePower() * 0.5 * this->Scanner->GetOpticalEfficiency() * d * d /
      (4.0 * range * range);
  }

  void Set(const Way& way)
  {
    vtkHeliosBeamSampler* sampler = this->Scanner->GetBeamSampler();
    sampler->SetPattern(way.Pattern == "GL" ? vtkHeliosBeamSampler::GAUSS_LEGENDRE
        : way.Pattern == "circles"          ? vtkHeliosBeamSampler::CIRCLES
                                            : vtkHeliosBeamSampler::VOGEL);
    sampler->SetNumberOfRings(way.Size);
    sampler->SetNumberOfCircles(way.Size);
    sampler->SetNumberOfSubRays(way.Size);
    this->Scanner->SetSampling(
      way.IsByTolerance() ? vtkHeliosScanner::TOLERANCE : vtkHeliosScanner::FIXED);
    if (way.IsByTolerance())
    {
      sampler->SetPatternToGaussLegendre();
      this->Scanner->SetRangeTolerance(way.RangeTolerance);
      this->Scanner->SetEnergyTolerance(10.0 * way.RangeTolerance);
    }
    this->Scanner->SetBinSize(way.BinSize);
    vtkSmartPointer<vtkHeliosEchoDetector> detector = vtkSmartPointer<vtkHeliosPeakDetector>::New();
#ifdef HELIOS_HAS_DETECTORS
    if (way.Detector == "gaussians")
    {
      detector = vtkSmartPointer<vtkHeliosGaussianDecomposition>::New();
    }
#endif
    detector->SetDetectionThreshold(this->Threshold);
    this->Scanner->SetEchoDetector(detector);
  }

  void Fire(int pulses)
  {
    this->Scanner->SetDuration((pulses - 0.5) / this->Aim->GetPulseFrequency());
    this->Scanner->Modified();
    this->Scanner->Update();
  }

  vtkSmartPointer<vtkPolyData> Run(const Way& way)
  {
    this->Set(way);
    this->Fire(this->Pulses);
    auto echoes = vtkSmartPointer<vtkPolyData>::New();
    echoes->ShallowCopy(this->Scanner->GetOutput());
    return echoes;
  }

  vtkNew<vtkHeliosScanner> Scanner;
  vtkNew<ListDeflector> Aim;
  vtkNew<vtkHeliosStaticPlatform> Tripod;
  int Pulses;
  double Threshold;
};

} // namespace helios::bench

#endif
