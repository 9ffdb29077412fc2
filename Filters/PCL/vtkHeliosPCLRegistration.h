// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPCLRegistration
 * @brief   registers one scan to another
 *
 * Input 0: the fixed points, a vtkPolyData. Input 1: the moving points, a vtkPolyData. Output 0:
 * the points of input 1 after the motion (double points), their arrays passed on and Normals,
 * Normal and Direction rotated, and the field array Registration.Matrix (double, 16, row by row):
 * x' = M x in the coordinates of the points. TruePoint, if present, does not change.
 *
 * The iterative closest point method (P. J. Besl, N. D. McKay 1992), composed of PCL's parts: every
 * point of input 1 is paired with the nearest of input 0 that is at most MaximumDistance away
 * (pcl::registration::CorrespondenceEstimation). The rigid motion minimizes the sum of the pairs'
 * squared distances, or with PointToPlane the sum of the squared distances from the plane at the
 * point of input 0 (Y. Chen, G. Medioni 1992; pcl's linear least squares). This repeats until the
 * motion is below a micrometre, or 1e-7 of the size. The motions are composed in double.
 *
 * Scans from two positions do not hit the same spots: use point to plane, and point to point only
 * for copies. The planes are fitted to NumberOfNeighbors points. Pairs that are not of one plane
 * are left out: if the curvature at one of them is above MaximumCurvature (edges, leaves), their
 * normals are more than 30 degrees apart, or, after convergence, the distance from the plane is
 * above three times the residual; then the iteration repeats until that changes little. A rough
 * alignment is needed: within MaximumDistance, and about ten degrees.
 *
 * Errors: no points, fewer than 6 pairs, pairs that do not determine the motion; a warning if
 * MaximumNumberOfIterations is reached. Points that are not finite are dropped, with a warning.
 *
 * @sa
 * vtkHeliosPCLFilter vtkHeliosPCLNormals
 */

#ifndef vtkHeliosPCLRegistration_h
#define vtkHeliosPCLRegistration_h

#include "vtkHeliosFiltersPCLModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <vtkMatrix4x4.h> // For the motion
#include <vtkNew.h>       // For the motion

namespace helios
{
class PclInput;
}

class VTKHELIOSFILTERSPCL_EXPORT vtkHeliosPCLRegistration : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosPCLRegistration* New();
  vtkTypeMacro(vtkHeliosPCLRegistration, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the maximum distance of pairs [m]. Valid range: [1e-4, 1e4]. Default: 1.
   */
  vtkSetClampMacro(MaximumDistance, double, 1e-4, 1e4);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  ///@{
  /**
   * Set/Get the maximum number of iterations. Valid range: [1, 10000]. Default: 100.
   */
  vtkSetClampMacro(MaximumNumberOfIterations, int, 1, 10000);
  vtkGetMacro(MaximumNumberOfIterations, int);
  ///@}

  ///@{
  /**
   * Set/Get whether distances are from planes instead of points. Default: on.
   */
  vtkSetMacro(PointToPlane, bool);
  vtkGetMacro(PointToPlane, bool);
  vtkBooleanMacro(PointToPlane, bool);
  ///@}

  ///@{
  /**
   * Set/Get the number of points of a plane fit, and the maximum curvature there. Valid range:
   * [3, 1000]; [0, 1]. Default: 16; 0.01.
   */
  vtkSetClampMacro(NumberOfNeighbors, int, 3, 1000);
  vtkGetMacro(NumberOfNeighbors, int);
  vtkSetClampMacro(MaximumCurvature, double, 0.0, 1.0);
  vtkGetMacro(MaximumCurvature, double);
  ///@}

  /**
   * Returns the motion found in the last update: points of input 1 to their new position.
   */
  vtkMatrix4x4* GetMatrix() { return this->Matrix; }

  ///@{
  /**
   * Get the root mean square distance of the pairs of the last update [m], from the planes with
   * PointToPlane; and the number of pairs.
   */
  vtkGetMacro(Residual, double);
  vtkGetMacro(NumberOfPairs, vtkIdType);
  ///@}

protected:
  vtkHeliosPCLRegistration();
  ~vtkHeliosPCLRegistration() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosPCLRegistration(const vtkHeliosPCLRegistration&) = delete;
  void operator=(const vtkHeliosPCLRegistration&) = delete;

  bool ReadInput(int port, vtkPolyData* data, helios::PclInput& input);
  bool Align(vtkPolyData* fixed, vtkPolyData* moving, vtkPolyData* output);

  double MaximumDistance = 1.0;
  int MaximumNumberOfIterations = 100;
  bool PointToPlane = true;
  int NumberOfNeighbors = 16;
  double MaximumCurvature = 0.01;
  vtkNew<vtkMatrix4x4> Matrix;
  double Residual = 0.0;
  vtkIdType NumberOfPairs = 0;
};

#endif
