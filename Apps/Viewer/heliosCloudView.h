// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws a cloud: all that is to be seen of it when still, a sample while the camera moves.

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

class vtkLookupTable;
class vtkPlaneCollection;
class vtkRenderer;
class vtkScalarBarActor;

namespace helios
{

class PointActor;

/**
 * Points without cells; the renderer's coordinates are the cloud's less its origin. Call Update()
 * once the cloud has grown, before anything is drawn.
 *
 * A cloud of up to GetWholeLimit() points is drawn as it is, for 4 bytes a point beside its own. Of
 * a larger one each picture draws the points that are closest to the camera at some pixel, found
 * among all in parallel: the same picture, and quick where a processor draws it.
 */
class CloudView
{
public:
  /// Points drawn while moving, at most.
  static constexpr std::size_t MaximumSample = 120000;

  ///@{
  /// Clouds of up to so many points are drawn as they are. Default: 2 million.
  void SetWholeLimit(vtkIdType points);
  vtkIdType GetWholeLimit() const { return this->WholeLimit; }
  ///@}

  /// The cloud and the renderer must outlive the view.
  CloudView(const Cloud& cloud, vtkRenderer* renderer);
  ~CloudView();
  CloudView(const CloudView&) = delete;
  void operator=(const CloudView&) = delete;

  /// Takes up what the cloud has become.
  void Update();

  /// What colours show. Default: Height.
  void SetColorBy(ColorBy by);
  ColorBy GetColorBy() const { return this->Colors.By; }
  /// The colour of ColorBy::One.
  void SetColor(const Rgb& color);

  ///@{
  /**
   * The numbers at the ends of the ramp: set, or from the points so that 2 % lie beyond either.
   * Default: from the points; they follow a growing cloud in steps. False, and nothing is changed,
   * where low is not below high.
   */
  bool SetRange(double low, double high);
  void SetAutomaticRange();
  double GetLow() const { return this->Colors.Low; }
  double GetHigh() const { return this->Colors.High; }
  const CloudColors& GetColors() const { return this->Colors; }
  ///@}

  /// Side of a point [pixels], in [1, 50]. Default: 2.
  void SetPointSize(double size);
  double GetPointSize() const { return this->PointSize; }

  /// Shades edges by depth; for everything solid in the renderer. Default: off.
  void SetEyeDomeLighting(bool on);
  bool GetEyeDomeLighting() const { return this->EyeDomeLighting; }

  ///@{
  /**
   * A box, x0 x1 y0 y1 z0 z1 [m] in the world, that points must lie in to be drawn. Default: off. A
   * box with low above high is refused.
   */
  bool SetClipBox(const double bounds[6]);
  void SetClipping(bool on);
  bool GetClipping() const { return this->Window.HasBox; }
  ///@}

  /// Points later than this [s] are not drawn. Default: infinity.
  void SetTimeLimit(double time);
  double GetTimeLimit() const { return this->Window.TimeLimit; }

  /// True while the camera moves: draws the sample only.
  void SetInteracting(bool on);
  bool IsInteracting() const { return this->Interacting; }

  /**
   * How long the last picture took [s], if the view is to keep 10 frames a second while moving: one
   * that took above 80 ms makes the next do without eye-dome lighting, then with half the points
   * (down to 20,000); below 25 ms points come back.
   */
  void ReportFrame(double seconds);
  void SetVisible(bool on);

  /// The legend; hidden where there is one colour or SetScalarBarVisible(false).
  vtkScalarBarActor* GetScalarBar() const { return this->Bar; }
  void SetScalarBarVisible(bool on);

  /// The echo drawn at a pixel of the window, or within a radius [pixels] of it.
  std::optional<Echo> Pick(double x, double y, double radius) const;

  /// Points that are drawn; those outside the clip box of a chunk that reaches in, too. Of a cloud
  /// above GetWholeLimit(): in the last picture.
  vtkIdType GetNumberOfDrawnPoints() const;

  /// Bytes beside the cloud's own.
  std::size_t GetMemorySize() const;

private:
  void UpdateSample();
  bool FitRange();
  std::vector<double> GetSampleValues() const;
  void UpdateBar();
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
  bool AutomaticRange = true;
  bool EyeDomeLighting = false;
  bool Interacting = false;
  bool Shaded = false;   // eye-dome lighting is at work
  bool Unshaded = false; // it is too slow while moving
  bool Stale = true;     // what is visible has to be found again
  vtkIdType WholeLimit = 2000000;
  std::uint32_t MovingMask = 0; // of the sample's rows that are drawn
  std::unique_ptr<PixelMap> VisibleFrom;
  unsigned long Observer = 0;
  bool Visible = true;
  bool BarVisible = true;
  double PointSize = 2.0;
  std::vector<std::unique_ptr<PointActor>> Chunks;
  std::unique_ptr<PointActor> Sample;
  std::vector<std::uint32_t> SampleRows;
  std::vector<float> SampleXyz;
  std::uint32_t SampleMask = 0;
  vtkIdType Sampled = 0; // points of the cloud that were asked
  vtkIdType FittedTo = 0;
  vtkNew<BoundsProp> Room;
  vtkNew<vtkPlaneCollection> Planes;
  vtkNew<vtkScalarBarActor> Bar;
  vtkNew<vtkLookupTable> Table;
};

} // namespace helios

#endif
