// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws a cloud: all visible points when still, a sample while the camera moves.

#ifndef heliosCloudView_h
#define heliosCloudView_h

#include "heliosBoundsProp.h"
#include "heliosCloud.h"
#include "heliosCloudColors.h"
#include "heliosCloudPicker.h"

#include <vtkNew.h>

#include <memory>
#include <optional>
#include <vector>

class vtkPlaneCollection;
class vtkRenderer;

namespace helios::viewer
{

class PointActor;

/**
 * Points without cells; renderer coordinates are the cloud's relative to its origin. Call Update()
 * after the cloud has grown, before drawing.
 *
 * A cloud of up to SetWholeLimit() points is drawn whole, for 4 extra bytes/point. Of a larger one
 * each frame draws the point closest to the camera at each pixel, found among all points in
 * parallel: the same picture, and fast with software rendering.
 */
class CloudView
{
public:
  /// Maximum number of moving points.
  static constexpr std::size_t MaximumSample = 120000;

  /// Clouds of up to this many points are drawn whole. Default: 2 million.
  void SetWholeLimit(vtkIdType points);

  /// The cloud and the renderer must outlive the view.
  CloudView(const Cloud& cloud, vtkRenderer* renderer);
  ~CloudView();
  CloudView(const CloudView&) = delete;
  void operator=(const CloudView&) = delete;

  /// Updates from the changed cloud.
  void Update();

  /// Sets the coloured quantity. Default: Height.
  void SetColorBy(ColorBy by);
  ColorBy GetColorBy() const { return this->Colors.By; }
  /// Sets the colour of ColorBy::One.
  void SetColor(const Rgb& color);

  ///@{
  /**
   * Ends of the ramp: set, or from the points with 2 % beyond either end. Default: from the points;
   * they follow a growing cloud in steps. Returns false and changes nothing if low is not below
   * high.
   */
  bool SetRange(double low, double high);
  void SetAutomaticRange();
  double GetLow() const { return this->Colors.Low; }
  double GetHigh() const { return this->Colors.High; }
  const CloudColors& GetColors() const { return this->Colors; }
  ///@}

  /// Sets the size of a point [pixels], in [1, 50]. Default: 2.
  void SetPointSize(double size);
  double GetPointSize() const { return this->PointSize; }

  /// Sets eye-dome lighting (EDL) of all solid props of the renderer. Default: off.
  void SetEyeDomeLighting(bool on);
  bool GetEyeDomeLighting() const { return this->EyeDomeLighting; }

  ///@{
  /**
   * Draws only the points in a box, x0 x1 y0 y1 z0 z1 [m] in world coordinates. Default: off. A box
   * with low above high is rejected.
   */
  bool SetClipBox(const double bounds[6]);
  void SetClipping(bool on);
  bool GetClipping() const { return this->Window.HasBox; }
  ///@}

  /// Draws only the points in a slab [m], in world coordinates; none: all. Default: none.
  void SetSection(const std::optional<Slab>& slab);

  /// Sets the time [s] after which points are not drawn. Default: infinity.
  void SetTimeLimit(double time);
  double GetTimeLimit() const { return this->Window.TimeLimit; }

  /// Sets whether the camera moves: then only the sample is drawn.
  void SetInteracting(bool on);
  bool IsInteracting() const { return this->Interacting; }

  /**
   * Reports the duration of the last frame [s], to keep 10 frames/s while moving: above 80 ms the
   * next one omits eye-dome lighting, then half of the points (down to 20,000); below 25 ms points
   * are restored.
   */
  void ReportFrame(double seconds);
  void SetVisible(bool on);

  /// Returns the legend of the colours; without colours if there are no points, or one colour only.
  const Legend& GetLegend() const { return this->Scale; }

  /// Sets the part of the colour map for quantities. Default: all.
  void SetRampPart(const RampPart& part);

  /// Returns the echo drawn at a window pixel, or within a radius [pixels].
  std::optional<Echo> Pick(double x, double y, double radius) const;

  /// Returns the number of points drawn, including points outside the clip box in chunks that
  /// intersect it; for a cloud above SetWholeLimit(), in the last frame.
  vtkIdType GetNumberOfDrawnPoints() const;

  /// Bytes besides the cloud's own.
  std::size_t GetMemorySize() const;

private:
  void UpdateSample();
  bool FitRange();
  std::vector<double> GetSampleValues() const;
  void UpdateLegend();
  void Recolor();
  void Refresh();
  void Colorize();
  void ShowChunk(std::size_t c);
  void ShowSample();
  void ShowVisible();
  void ShowRows(const std::vector<std::uint32_t>& rows);
  bool IsWhole() const { return this->Points.GetNumberOfPoints() <= this->WholeLimit; }
  void UpdatePass();
  void UpdateRoom();
  void SetUpPlanes();

  const Cloud& Points;
  vtkRenderer* Renderer;
  CloudColors Colors;
  CloudWindow Window;
  double Box[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 }; // world
  std::optional<Slab> Section;                         // world
  bool AutomaticRange = true;
  bool EyeDomeLighting = false;
  bool Interacting = false;
  bool Shaded = false;   // eye-dome lighting is active
  bool Unshaded = false; // EDL is too slow while moving
  bool Stale = true;     // visible points are out of date
  vtkIdType WholeLimit = 2000000;
  std::uint32_t MovingMask = 0; // mask of the sample's drawn rows
  std::unique_ptr<PixelMap> VisibleFrom;
  unsigned long Observer = 0;
  bool Visible = true;
  double PointSize = 2.0;
  std::vector<std::unique_ptr<PointActor>> Chunks;
  std::unique_ptr<PointActor> Sample;
  std::vector<std::uint32_t> SampleRows;
  std::vector<float> SampleXyz;
  std::uint32_t SampleMask = 0;
  vtkIdType Sampled = 0; // points of the cloud considered
  vtkIdType FittedTo = 0;
  vtkNew<BoundsProp> Room;
  vtkNew<vtkPlaneCollection> Planes;
  Legend Scale;
};

} // namespace helios::viewer

#endif
