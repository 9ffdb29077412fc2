// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws nothing but has bounds: camera resets use them, whichever part of a cloud is drawn.

#ifndef heliosBoundsProp_h
#define heliosBoundsProp_h

#include <vtkMath.h>
#include <vtkObjectFactory.h>
#include <vtkProp.h>

#include <algorithm>

namespace helios::viewer
{

class BoundsProp : public vtkProp
{
public:
  static BoundsProp* New() { VTK_STANDARD_NEW_BODY(BoundsProp); }
  vtkTypeMacro(BoundsProp, vtkProp);

  /// Sets x0 x1 y0 y1 z0 z1 in the renderer's coordinates; null: none.
  void SetBounds(const double* bounds)
  {
    vtkMath::UninitializeBounds(this->Bounds);
    if (bounds)
    {
      std::copy(bounds, bounds + 6, this->Bounds);
    }
    this->SetVisibility(bounds != nullptr);
    this->Modified();
  }

  double* GetBounds() override { return this->Bounds; }

protected:
  BoundsProp() { this->SetBounds(nullptr); }

private:
  double Bounds[6];
};

} // namespace helios::viewer

#endif
