// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosRayCaster
 * @brief   intersects batches of rays with the triangles of a scene
 *
 * A strategy: after Build(), any number of threads may query it. Every backend takes hit and range
 * from the same double-precision watertight test (Woop et al. 2013) on the scene's own points, so
 * all are byte-identical: no leak through shared edges and vertices; of triangles at equal range the
 * one with the lowest cell id. Triangles without area are never hit, others from both sides.
 * (vtkHeliosObbTreeRayCaster, for cross-checks, fulfils this only approximately.)
 *
 * @sa vtkHeliosRayCasterFactory vtkHeliosBeamRayCaster vtkHeliosBvhRayCaster vtkHeliosScanner
 */

#ifndef vtkHeliosRayCaster_h
#define vtkHeliosRayCaster_h

#include "vtkHeliosRay.h"                     // For rays and hits
#include "vtkHeliosScannerRayCastingModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For casters of moving scenes

#include <functional> // For the abort check
#include <memory>     // For private data

class vtkDoubleArray;
class vtkIdTypeArray;
class vtkPolyData;

namespace helios
{
class ConeProbe;
class InstanceMotions;
class SceneGeometry;
class StopCheck;
class TriangleMesh;
struct SceneMoment;
}

class VTKHELIOSSCANNERRAYCASTING_EXPORT vtkHeliosRayCaster : public vtkObject
{
public:
  vtkTypeMacro(vtkHeliosRayCaster, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Builds the accelerator for a scene of triangles, if it has changed. Returns false, after an
   * error, for a scene that is empty, or has other cells or points that are not finite. Instances
   * of a vtkHeliosScene are copied, unless by vtkHeliosBeamRayCaster.
   */
  bool Build(vtkPolyData* scene);

  /**
   * Finds the first hit of each of count rays; adjacent rays in the array are traced together.
   */
  virtual void Intersect(const vtkHeliosRay* rays, vtkHeliosHit* hits, vtkIdType count) const = 0;

  /**
   * Finds the first hits of beams, each of n nearby rays: byte-identical to Intersect(), but
   * faster.
   */
  virtual void IntersectBeams(
    const vtkHeliosRay* rays, vtkHeliosHit* hits, int raysPerBeam, vtkIdType beams) const;

  /**
   * Finds, for each of count rays, whether anything lies in (0, MaximumRange].
   */
  virtual void Occluded(
    const vtkHeliosRay* rays, unsigned char* occluded, vtkIdType count) const = 0;

  /**
   * Finds the first hits of rays given as arrays of 3 components, for Python: fills ranges [units
   * of the direction's length] and cellIds; of a miss infinite and -1. False after an error.
   */
  bool Intersect(vtkDoubleArray* origins, vtkDoubleArray* directions, vtkDoubleArray* ranges,
    vtkIdTypeArray* cellIds);

  ///@{
  /**
   * Returns the name of the backend, as in vtkHeliosRayCasterFactory; the size of its accelerator
   * [bytes].
   */
  virtual const char* GetName() const = 0;
  virtual std::size_t GetAcceleratorSize() const = 0;
  ///@}

  /**
   * Returns the size of all that was built for a scene in bytes: accelerator, cone probe, copies of
   * points and corners.
   */
  std::size_t GetMemorySize() const;

#ifndef __VTK_WRAP__
  /// Returns the cone probe of the scene, until the next build. The first call makes it, in one
  /// thread. Null without a scene, after an abort request, for too many triangles.
  const helios::ConeProbe* GetConeProbe();

  /// Sets a function that runs about ten times/s in Build() and GetConeProbe()
  /// (vtkHeliosObbTreeRayCaster: at the start), in the calling thread. If it returns true, they
  /// stop, Build() with an error.
  void SetShouldStop(const std::function<bool()>& shouldStop);

  /// Returns a caster of the built scene, which must outlive it, whose instances move; it shares
  /// the trees. One per thread. Null unless this caster supports instances.
  vtkSmartPointer<vtkHeliosRayCaster> MakeMoving(
    const std::shared_ptr<const helios::InstanceMotions>& motions) const;

  /// Moves the instances of a caster by MakeMoving() to where they are at a moment.
  virtual void MoveTo(const helios::SceneMoment& moment);

  /// Returns the triangles of the built scene.
  const helios::SceneGeometry& GetGeometry() const
  {
    return *this->Geometry;
  }
#endif

protected:
  vtkHeliosRayCaster();
  ~vtkHeliosRayCaster() override;

  /// Builds the accelerator of the mesh; false after an error.
  virtual bool BuildAccelerator(const helios::TriangleMesh& mesh) = 0;

  /// Builds over a scene with instances; the default makes one mesh of them.
  virtual bool BuildInstances(const helios::SceneGeometry& scene);

#ifndef __VTK_WRAP__
  /// Shares the accelerator of a caster of the same class, for the geometry of this one, in which
  /// instances move; the default returns false: it cannot.
  virtual bool ShareAccelerator(const vtkHeliosRayCaster& atRest);

  /// Makes the cone probe of the built scene; the default has a tree of its own.
  virtual std::unique_ptr<helios::ConeProbe> MakeConeProbe();

  /// Returns the check to be called while an accelerator is built: it throws out of
  /// BuildAccelerator().
  helios::StopCheck& GetStopCheck();
#endif

private:
  vtkHeliosRayCaster(const vtkHeliosRayCaster&) = delete;
  void operator=(const vtkHeliosRayCaster&) = delete;

  bool TryToBuild();

  struct Internals;
  std::unique_ptr<Internals> Built;
  std::unique_ptr<helios::SceneGeometry> Geometry;
};

#endif
