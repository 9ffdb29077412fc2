// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPCLNormals
 * @brief   normals of points by their neighbours
 *
 * Input 0: a vtkPolyData with points. Output 0: the same, with the point arrays
 * - Normals (float, 3), the active normals: that of the least squares plane through the
 *   neighbours, the eigenvector of their covariance with the least eigenvalue
 *   (pcl::NormalEstimationOMP), of unit length;
 * - Curvature (float): that eigenvalue over the sum of all three, 0 on a plane, 1/3 where points
 *   lie the same way in all directions.
 *
 * The neighbours are the NumberOfNeighbors nearest points, itself among them, or all within Radius.
 * A point with fewer than 3, or with neighbours on a line, may have no normal: 0 0 0, counted and
 * warned of. Coordinates are float relative to the middle of the cloud: within 1 km of it they are
 * 0.06 mm off, which is 1 mrad where neighbours are 5 cm apart.
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
   * Set/Get how many nearest points the plane is fitted to. Valid range: [3, 1000]. Default: 16.
   */
  vtkSetClampMacro(NumberOfNeighbors, int, 3, 1000);
  vtkGetMacro(NumberOfNeighbors, int);
  ///@}

  ///@{
  /**
   * Set/Get the distance within which all points count instead [m]; 0: the nearest ones. Valid
   * range: [0, 1000]. Default: 0.
   */
  vtkSetClampMacro(Radius, double, 0.0, 1000.0);
  vtkGetMacro(Radius, double);
  ///@}

  /** Where normals point to. */
  enum Sides
  {
    Up = 0,         ///< z is not negative
    ToViewpoint = 1 ///< to the side on which Viewpoint is
  };

  ///@{
  /**
   * Set/Get which of its two directions a normal has. Valid range: Up, ToViewpoint. Default: Up.
   */
  vtkSetClampMacro(Side, int, Up, ToViewpoint);
  vtkGetMacro(Side, int);
  ///@}

  ///@{
  /**
   * Set/Get the place that normals point to, such as the scanner's [m]. Valid range: finite.
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
