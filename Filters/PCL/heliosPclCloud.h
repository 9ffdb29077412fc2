// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Conversion of echoes to and from PCL clouds, for programs that use PCL themselves. The only
// header of vtkHelios that includes PCL's; no other header includes it.
//
// PCL's coordinates are float, with errors up to half a metre in UTM northings. A cloud is
// therefore relative to an origin in double, which the caller keeps. Within 1 km of the origin the
// round-trip error of a coordinate is less than 0.1 mm.

#ifndef heliosPclCloud_h
#define heliosPclCloud_h

#include "vtkHeliosFiltersPCLModule.h" // For export macro

#include <pcl/memory.h>
#include <pcl/pcl_macros.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/register_point_struct.h>

#include <cstdint>
#include <string>

class vtkPolyData;

namespace helios
{

/// An echo with the attributes of a real scanner. Its PCD fields have the names that
/// vtkHeliosPCDWriter gives the arrays, so pcl::io::loadPCDFile reads its files.
struct EIGEN_ALIGN16 PointEcho
{
  PCL_ADD_POINT4D
  float intensity = 0.0F;             ///< the amplitude [W]
  float width = 0.0F;                 ///< full width at half maximum [ns]
  double gps_time = 0.0;              ///< [s]
  std::int64_t pulse_id = 0;          ///< over the run
  std::uint32_t classification = 0;   ///< LAS class; the label of PCL
  std::uint8_t return_number = 0;     ///< from 1
  std::uint8_t number_of_returns = 0; ///< number of returns of the pulse

  PointEcho() { x = y = z = 0.0F, data[3] = 1.0F; }
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

/// Chooses an origin for a cloud: the centre of the bounds of its finite points, rounded to
/// multiples of a step [m]; 0 0 0 without finite points.
VTKHELIOSFILTERSPCL_EXPORT void ChooseOrigin(
  vtkPolyData* echoes, double origin[3], double step = 1.0);

/**
 * Returns all points of echoes, in their order, as pcl::PointXYZ, pcl::PointXYZI,
 * pcl::PointXYZINormal or PointEcho. Points that are not finite stay and make the cloud not dense.
 * Fields without an array are 0: Amplitude (or else Intensity), Normals (or else Normal),
 * EchoWidth, GpsTime, PulseIds, ClassificationIds, ReturnNumber, NumberOfReturns. Returns an error
 * message about an array; empty after success.
 */
template <typename PointT>
std::string ToPcl(vtkPolyData* echoes, const double origin[3], pcl::PointCloud<PointT>& cloud);

/// Copies the points of a cloud as echoes with double points and the arrays of its type.
template <typename PointT>
void FromPcl(const pcl::PointCloud<PointT>& cloud, const double origin[3], vtkPolyData* echoes);

} // namespace helios

POINT_CLOUD_REGISTER_POINT_STRUCT(helios::PointEcho,
  (float, x, x)(float, y, y)(float, z, z)(float, intensity, intensity)(float, width, EchoWidth)(
    double, gps_time, GpsTime)(std::int64_t, pulse_id, PulseIds)(
    std::uint32_t, classification, label)(std::uint8_t, return_number, ReturnNumber)(
    std::uint8_t, number_of_returns, NumberOfReturns))

#endif
