// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPCLNormals
 * @brief   normals of points from their neighbours
 *
 * Input 0: a vtkPolyData with points. Output 0: the same, with the point arrays
 * - Normals (float, 3), the active normals: the normal of the least squares plane through the
 *   neighbours, the eigenvector of their covariance with the smallest eigenvalue
 *   (pcl::NormalEstimationOMP), of unit length;
 * - Curvature (float): that eigenvalue over the sum of all three, 0 on a plane, 1/3 for an
 *   isotropic distribution.
 *
 * The neighbours are the NumberOfNeighbors nearest points, including the point itself, or all
 * within Radius. A point with fewer than 3, or with collinear neighbours, may have no normal: 0 0
 * 0, with a warning that counts them. Coordinates are float relative to the centre of the cloud:
 * within 1 km of it their error is 0.06 mm, which is 1 mrad for neighbours 5 cm apart.
 *
 * @sa
 * vtkHeliosPCLFilter
 */

#ifndef vtkHeliosPCLNormals_h
#define vtkHeliosPCLNormals_h

#include "vtkHeliosFiltersPCLModule.h" // For export macro
#include "vtkHeliosPCLFilter.h"

class VTKHELIOSFILTERSPCL_EXPORT vtkHeliosPCLNormals : public vtkHeliosPCLFilter
{
public:
  static vtkHeliosPCLNormals* New();
  vtkTypeMacro(vtkHeliosPCLNormals, vtkHeliosPCLFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the number of nearest points of a plane fit. Valid range: [3, 1000]. Default: 16.
   */
  vtkSetClampMacro(NumberOfNeighbors, int, 3, 1000);
  vtkGetMacro(NumberOfNeighbors, int);
  ///@}

  ///@{
  /**
   * Set/Get the radius of the neighbourhood [m]; 0: the nearest points are used instead. Valid
   * range: [0, 1000]. Default: 0.
   */
  vtkSetClampMacro(Radius, double, 0.0, 1000.0);
  vtkGetMacro(Radius, double);
  ///@}

  /** Orientation of normals. */
  enum Sides
  {
    Up = 0,         ///< z is not negative
    ToViewpoint = 1 ///< towards the side of Viewpoint
  };

  ///@{
  /**
   * Set/Get the orientation of normals. Valid range: Up, ToViewpoint. Default: Up.
   */
  vtkSetClampMacro(Side, int, Up, ToViewpoint);
  vtkGetMacro(Side, int);
  ///@}

  ///@{
  /**
   * Set/Get the position that normals point to, such as the scanner's [m]. Valid range: finite.
   * Default: 0 0 0.
   */
  vtkSetVector3Macro(Viewpoint, double);
  vtkGetVector3Macro(Viewpoint, double);
  ///@}

protected:
  vtkHeliosPCLNormals() = default;
  ~vtkHeliosPCLNormals() override = default;

  bool Process(helios::PclInput& input, vtkPolyData* output) override;
  bool CheckProperties() override;

private:
  vtkHeliosPCLNormals(const vtkHeliosPCLNormals&) = delete;
  void operator=(const vtkHeliosPCLNormals&) = delete;

  double GetTowards(const double point[3], const float normal[3]) const;

  int NumberOfNeighbors = 16;
  double Radius = 0.0;
  int Side = Up;
  double Viewpoint[3] = { 0.0, 0.0, 0.0 };
};

#endif
