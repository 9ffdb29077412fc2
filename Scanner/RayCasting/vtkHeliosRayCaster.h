// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosRayCaster
 * @brief   intersects batches of rays with the triangles of a scene
 *
 * A strategy: after one Build() from a scene, any number of threads may query
 * it. Every backend takes hit and range from the same double-precision
 * watertight test (Woop et al. 2013) on the scene's own points, so all are
 * byte-identical: no leak through shared edges and vertices; of triangles at
 * equal range the one with the lowest cell id. Triangles without area are never
 * hit. Both sides of a triangle are hit. (vtkHeliosObbTreeRayCaster, for
 * cross-checks, fulfils this only approximately.)
 *
 * @sa
 * vtkHeliosBeamRayCaster vtkHeliosBvhRayCaster vtkHeliosEmbreeRayCaster
 * vtkHeliosCgalRayCaster vtkHeliosObbTreeRayCaster vtkHeliosScanner
 */

#ifndef vtkHeliosRayCaster_h
#define vtkHeliosRayCaster_h

#include "vtkHeliosScannerRayCastingModule.h" // For export macro
#include "vtkObject.h"
#include "vtkWeakPointer.h" // For the scene it was built from

#include <functional> // For the abort check
#include <limits>     // For an unbounded ray
#include <memory>     // For the private mesh

class vtkCellArray;
class vtkDoubleArray;
class vtkIdTypeArray;
class vtkPoints;
class vtkPolyData;

namespace helios
{
class BeamTree;
class StopCheck;
class TriangleMesh;
}

/// A ray: hits count at ranges in (0, MaximumRange]. Range is in units of the direction's length.
struct vtkHeliosRay
{
  double Origin[3];
  double Direction[3];
  double MaximumRange = std::numeric_limits<double>::infinity();
};

/// The first hit of a ray; CellId is -1 where it hits nothing.
struct vtkHeliosHit
{
  double Range;
  vtkIdType CellId;
};

/// The result of a cone probe.
struct vtkHeliosConeHit
{
  enum Kinds
  {
    Empty,    ///< no hit
    OnePlane, ///< one plane over the whole cross-section, and nothing before it
    Mixed     ///< anything else, or unresolved
  };
  int Kind;
  vtkIdType CellId; ///< hit by the axis
  double Range;     ///< of this hit
};

class VTKHELIOSSCANNERRAYCASTING_EXPORT vtkHeliosRayCaster : public vtkObject
{
public:
  vtkTypeMacro(vtkHeliosRayCaster, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Creates a ray caster by the name of its backend, or the default one if the
   * name is null or empty. For an unknown name, null after an error that lists
   * the valid names.
   */
  VTK_NEWINSTANCE static vtkHeliosRayCaster* Create(const char* name);

  ///@{
  /**
   * The names of the backends in this process, the default one first: "beam",
   * "embree", "bvh", "cgal", "obbtree" if all are built. Valid range of an index:
   * [0, number - 1].
   */
  static int GetNumberOfBackends();
  static const char* GetBackendName(int index);
  ///@}

  /**
   * Builds the accelerator for a scene of triangles. Does nothing if it was
   * built from this scene and the scene has not been modified since. Returns
   * false, after an error that gives the reason, for a scene that is empty or
   * has other cells than triangles or points that are not finite.
   */
  bool Build(vtkPolyData* scene);

  ///@{
  /**
   * The first hit of each of count rays. Rays adjacent in the array should be
   * adjacent in space: they are traced together.
   */
  virtual void Intersect(const vtkHeliosRay* rays, vtkHeliosHit* hits, vtkIdType count) const = 0;
  ///@}

  /**
   * The first hits of beams, each of n nearby rays: byte-identical to
   * Intersect(), but faster.
   */
  virtual void IntersectBeams(
    const vtkHeliosRay* rays, vtkHeliosHit* hits, int raysPerBeam, vtkIdType beams) const;

  /**
   * Prepares ProbeCone() for the built scene, once. Not thread-safe.
   */
  virtual void PrepareConeProbe();

  /**
   * Probes a cone with its apex at origin about a unit axis; planeTolerance [m]
   * is the maximum distance of surfaces from one plane, along the axis, inside
   * the cone. Empty and OnePlane are exact for the whole cone, without
   * sampling; cell and range are those of Intersect() for the axis. Mixed
   * before PrepareConeProbe(). Thread-safe.
   */
  virtual vtkHeliosConeHit ProbeCone(
    const double origin[3], const double axis[3], double tanHalfAngle, double planeTolerance) const;

  /**
   * For each of count rays whether anything lies in (0, MaximumRange].
   */
  virtual void Occluded(
    const vtkHeliosRay* rays, unsigned char* occluded, vtkIdType count) const = 0;

  /**
   * The first hits of rays given as arrays of 3 components, for Python: fills
   * ranges [units of the direction's length] (infinite for a miss) and cellIds
   * (-1 for a miss). Returns false, after an error, for arrays of other shape
   * or a caster that is not built.
   */
  bool Intersect(vtkDoubleArray* origins, vtkDoubleArray* directions, vtkDoubleArray* ranges,
    vtkIdTypeArray* cellIds);

  /**
   * The name of the backend: "beam", "embree", "bvh", "cgal", "obbtree".
   */
  virtual const char* GetName() const = 0;

  /**
   * The size of the accelerator in bytes, without the scene.
   */
  virtual std::size_t GetAcceleratorSize() const = 0;

#ifndef __VTK_WRAP__
  using Factory = vtkHeliosRayCaster* (*)();

  /// Registers a backend for Create(); the one with the highest priority is the default.
  static bool Register(const char* name, int priority, Factory create);

  /**
   * A callback polled about ten times/s by Build() and PrepareConeProbe(), in the calling
   * thread; null: none. If it returns true, Build() ends with an error, and both leave the caster
   * unchanged, except that the previous scene is released. vtkHeliosObbTreeRayCaster polls it only
   * at the start.
   */
  void SetShouldStop(const std::function<bool()>& shouldStop);

  /// The triangles of the built scene.
  const helios::TriangleMesh& GetMesh() const
  {
    return *this->Mesh;
  }
#endif

protected:
  vtkHeliosRayCaster();
  ~vtkHeliosRayCaster() override;

  /// Builds the accelerator of the mesh; false after an error.
  virtual bool BuildAccelerator(const helios::TriangleMesh& mesh) = 0;

#ifndef __VTK_WRAP__
  /// To be called while an accelerator is built: it throws out of BuildAccelerator().
  helios::StopCheck& GetStopCheck()
  {
    return *this->Check;
  }

  const std::function<bool()>& GetShouldStop() const
  {
    return this->ShouldStop;
  }
#endif

  /// The accelerator, if it supports ProbeCone().
  virtual const helios::BeamTree* GetBeamTree() const
  {
    return nullptr;
  }

private:
  vtkHeliosRayCaster(const vtkHeliosRayCaster&) = delete;
  void operator=(const vtkHeliosRayCaster&) = delete;

  /// Whether the accelerator was built from a scene, or from another one with the same triangles.
  bool IsBuilt(vtkPolyData* scene) const;

  bool TryToBuild();

  std::function<bool()> ShouldStop;
  std::unique_ptr<helios::StopCheck> Check;
  std::unique_ptr<helios::TriangleMesh> Mesh;
  std::unique_ptr<helios::BeamTree> OwnConeTree;
  const helios::BeamTree* ConeTree = nullptr; ///< once prepared
  vtkWeakPointer<vtkPolyData> BuiltScene;
  vtkPoints* BuiltPoints = nullptr;   ///< of the scene, which holds it
  vtkCellArray* BuiltPolys = nullptr; ///< of the scene, which holds it
  vtkMTimeType BuiltTime = 0;
};

#endif
