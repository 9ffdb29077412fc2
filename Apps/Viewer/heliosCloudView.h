// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws a cloud: all of it when still, a sample while the camera moves.

#ifndef heliosCloudView_h
#define heliosCloudView_h

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
 * Points without cells, 4 bytes a point beside the cloud's own; the renderer's coordinates are the
 * cloud's less its origin. Call Update() once the cloud has grown, before anything is drawn.
 */
class CloudView
{
public:
  /// Points drawn while moving, at most.
  static constexpr std::size_t MaximumSample = 200000;

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
  void SetVisible(bool on);

  /// The legend; hidden where there is one colour or SetScalarBarVisible(false).
  vtkScalarBarActor* GetScalarBar() const { return this->Bar; }
  void SetScalarBarVisible(bool on);

  /// The echo drawn at a pixel of the window, or within a radius [pixels] of it.
  std::optional<Echo> Pick(double x, double y, double radius) const;

  /// Points that the next picture draws, those outside the clip box of a chunk that reaches in, too.
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
  void ShowChunk(std::size_t c);
  void ShowSample();
  void SetUpPlanes();

  const Cloud& Points;
  vtkRenderer* Renderer;
  CloudColors Colors;
  CloudWindow Window;
  double Box[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 }; // world
  bool AutomaticRange = true;
  bool EyeDomeLighting = false;
  bool Interacting = false;
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
  vtkNew<vtkPlaneCollection> Planes;
  vtkNew<vtkScalarBarActor> Bar;
  vtkNew<vtkLookupTable> Table;
};

} // namespace helios

#endif
