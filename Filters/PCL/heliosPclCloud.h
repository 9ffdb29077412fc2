// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Echoes to and from clouds of PCL: for programs that use PCL themselves. It is the only header of
// vtkHelios that needs PCL's, and no other one includes it.
//
// PCL's coordinates are float, which is half a metre in UTM's northings: so a cloud is relative to
// an origin in double, which the caller keeps. Within 1 km of the origin a coordinate that goes
// there and back is less than 0.1 mm off.

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

/// An echo with what a real scanner gives. Its fields in PCD files have the names of our arrays, so
/// pcl::io::loadPCDFile reads what vtkHeliosPCDWriter has written.
struct EIGEN_ALIGN16 PointEcho
{
  PCL_ADD_POINT4D
  float intensity = 0.0F;             ///< the amplitude [W]
  float width = 0.0F;                 ///< full width at half maximum [ns]
  double gps_time = 0.0;              ///< [s]
  std::int64_t pulse_id = 0;          ///< over the run
  std::int32_t classification = 0;    ///< as LAS has it
  std::uint8_t return_number = 0;     ///< from 1
  std::uint8_t number_of_returns = 0; ///< of the pulse

  PointEcho() { x = y = z = 0.0F, data[3] = 1.0F; }
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

/// An origin for a cloud: the centre of the bounds of its finite points, to whole multiples of a
/// step [m]; 0 0 0 where there are none.
VTKHELIOSFILTERSPCL_EXPORT void ChooseOrigin(
  vtkPolyData* echoes, double origin[3], double step = 1.0);

/**
 * All points of echoes, in their order, as pcl::PointXYZ, pcl::PointXYZI, pcl::PointXYZINormal or
 * PointEcho. Points that are not finite stay and make the cloud not dense. What the echoes have no
 * array for is 0: Amplitude (or else Intensity), Normals (or else Normal), EchoWidth, GpsTime,
 * PulseIds, ClassificationIds, ReturnNumber, NumberOfReturns. Returns what is wrong with an array,
 * or an empty text.
 */
template <typename PointT>
std::string ToPcl(vtkPolyData* echoes, const double origin[3], pcl::PointCloud<PointT>& cloud);

/// The points of a cloud as echoes with double points and the arrays its type has.
template <typename PointT>
void FromPcl(const pcl::PointCloud<PointT>& cloud, const double origin[3], vtkPolyData* echoes);

} // namespace helios

POINT_CLOUD_REGISTER_POINT_STRUCT(helios::PointEcho,
  (float, x, x)(float, y, y)(float, z, z)(float, intensity, intensity)(float, width, EchoWidth)(
    double, gps_time, GpsTime)(std::int64_t, pulse_id, PulseIds)(
    std::int32_t, classification, ClassificationIds)(std::uint8_t, return_number, ReturnNumber)(
    std::uint8_t, number_of_returns, NumberOfReturns))

#endif
