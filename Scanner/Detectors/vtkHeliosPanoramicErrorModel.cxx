// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPanoramicErrorModel.h"

#include "heliosPose.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <cmath>

vtkStandardNewMacro(vtkHeliosPanoramicErrorModel);

namespace
{

using helios::Vec3;

/// Mirrors a vector at the plane with a unit normal.
Vec3 Reflect(const Vec3& vector, const Vec3& normal)
{
  return vector - 2.0 * vector.Dot(normal) * normal;
}

Vec3 RotateAbout(const Vec3& axis, double degrees, const Vec3& vector)
{
  return helios::Rotate(helios::AxisAngle(axis, degrees), vector);
}

} // namespace

//------------------------------------------------------------------------------
bool vtkHeliosPanoramicErrorModel::IsAligned() const
{
  return this->HorizontalBeamOffset == 0.0 && this->VerticalBeamOffset == 0.0 &&
    this->TransitOffset == 0.0 && this->MirrorOffset == 0.0 && this->VerticalIndexOffset == 0.0 &&
    this->HorizontalBeamTilt == 0.0 && this->VerticalBeamTilt == 0.0 && this->MirrorTilt == 0.0 &&
    this->TransitTilt == 0.0;
}

//------------------------------------------------------------------------------
double vtkHeliosPanoramicErrorModel::GetRangeError(double theta) const
{
  return this->Superclass::GetRangeError(theta) - this->RangeOffset;
}

//------------------------------------------------------------------------------
bool vtkHeliosPanoramicErrorModel::MoveRay(double origin[3], double direction[3]) const
{
  const Vec3 shaft(1.0, 0.0, 0.0);
  const Vec3 along(0.0, 1.0, 0.0);
  Vec3 aim(direction);
  const Vec3 side = shaft.Cross(aim); // normal of the plane of shaft and beam
  if (this->IsAligned() || side.SquaredNorm() < 1e-12)
  {
    return false; // a beam along the shaft meets no mirror
  }
  // the mirror that reflects a beam along the shaft to the nominal direction, and its errors
  Vec3 normal = aim - shaft;
  normal.Normalize();
  normal = RotateAbout(
    shaft, -this->VerticalIndexOffset, RotateAbout(side.Normalized(), -this->MirrorTilt, normal));

  Vec3 beam(1.0, std::tan(vtkMath::RadiansFromDegrees(this->HorizontalBeamTilt)),
    std::tan(vtkMath::RadiansFromDegrees(this->VerticalBeamTilt)));
  beam.Normalize();
  const Vec3 offset(0.0, this->HorizontalBeamOffset, this->VerticalBeamOffset);
  aim = Reflect(beam, normal);
  const Vec3 start = Reflect(offset, normal) + this->MirrorOffset * shaft;

  aim = RotateAbout(along, -this->TransitTilt, aim);
  const Vec3 moved = RotateAbout(along, -this->TransitTilt, start) + this->TransitOffset * along;
  for (int k = 0; k < 3; ++k)
  {
    origin[k] += moved[k];
    direction[k] = aim[k];
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosPanoramicErrorModel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "HorizontalBeamOffset: " << this->HorizontalBeamOffset << " m\n"
     << indent << "VerticalBeamOffset: " << this->VerticalBeamOffset << " m\n"
     << indent << "TransitOffset: " << this->TransitOffset << " m\n"
     << indent << "MirrorOffset: " << this->MirrorOffset << " m\n"
     << indent << "VerticalIndexOffset: " << this->VerticalIndexOffset << " deg\n"
     << indent << "HorizontalBeamTilt: " << this->HorizontalBeamTilt << " deg\n"
     << indent << "VerticalBeamTilt: " << this->VerticalBeamTilt << " deg\n"
     << indent << "MirrorTilt: " << this->MirrorTilt << " deg\n"
     << indent << "TransitTilt: " << this->TransitTilt << " deg\n"
     << indent << "RangeOffset: " << this->RangeOffset << " m\n";
}
