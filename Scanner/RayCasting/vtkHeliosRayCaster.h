// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosRayCaster
 * @brief   rays against the triangles of a scene, in batches
 *
 * A strategy: Build() it once from a scene, then any number of threads may ask
 * it. Every backend takes hit and range from the same double-precision
 * watertight test (Woop et al. 2013) on the scene's own points, so all give the
 * same bytes: no leak through shared edges and vertices; of triangles at
 * equal range the one with the lowest cell id. Triangles without area are
 * never hit. Both sides of a triangle are hit. (Of vtkHeliosObbTreeRayCaster,
 * which is there for cross-checks, this holds only nearly.)
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

#include <functional> // For the question whether to stop
#include <limits>     // For an endless ray
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

/// What a cone meets.
struct vtkHeliosConeHit
{
  enum Kinds
  {
    Empty,    ///< nothing
    OnePlane, ///< one plane all over its cross-section, and nothing before it
    Mixed     ///< anything else, or not known
  };
  int Kind;
  vtkIdType CellId; ///< of the plane, where the axis meets it
  double Range;     ///< at which it does
};

class VTKHELIOSSCANNERRAYCASTING_EXPORT vtkHeliosRayCaster : public vtkObject
{
public:
  vtkTypeMacro(vtkHeliosRayCaster, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * A new ray caster by the name of its backend, or of the default backend where
   * the name is null or empty. Null, after an error that lists the names there
   * are, for another name.
   */
  VTK_NEWINSTANCE static vtkHeliosRayCaster* Create(const char* name);

  ///@{
  /**
   * The names of the backends in this process, the default one first: "beam",
   * "embree", "bvh", "cgal", "obbtree" where all are built. Valid range of an index:
   * [0, number - 1].
   */
  static int GetNumberOfBackends();
  static const char* GetBackendName(int index);
  ///@}

  /**
   * Builds the accelerator for a scene of triangles. Does nothing when it was
   * built from this scene and the scene has not been modified since. Returns
   * false, after an error that names the reason, for a scene that is empty or
   * has other cells than triangles or points that are not finite.
   */
  bool Build(vtkPolyData* scene);

  ///@{
  /**
   * The first hit of each of count rays. Neighbours in the array should be
   * neighbours in space: they are traced together.
   */
  virtual void Intersect(const vtkHeliosRay* rays, vtkHeliosHit* hits, vtkIdType count) const = 0;
  ///@}

  /**
   * The first hits of beams, each of so many rays that lie close together: the
   * same bytes as Intersect() gives, only faster.
   */
  virtual void IntersectBeams(
    const vtkHeliosRay* rays, vtkHeliosHit* hits, int raysPerBeam, vtkIdType beams) const;

  /**
   * Prepares ProbeCone() for the scene it was built from, once. Not thread-safe.
   */
  virtual void PrepareConeProbe();

  /**
   * What a cone meets that opens from origin about a unit axis; planeTolerance
   * [m] is how far surfaces may lie off one plane, along the axis, inside the
   * cone. Empty and OnePlane are certain, whatever is between any samples; cell
   * and range are those that Intersect() gives for the axis. Mixed before
   * PrepareConeProbe(). Thread-safe.
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
   * Bytes of the accelerator beyond the scene itself.
   */
  virtual std::size_t GetAcceleratorSize() const = 0;

#ifndef __VTK_WRAP__
  using Factory = vtkHeliosRayCaster* (*)();

  /// Adds a backend to those that Create() knows; the one with the highest priority is the default.
  static bool Register(const char* name, int priority, Factory create);

  /**
   * What Build() and PrepareConeProbe() ask some ten times a second, in the thread that called
   * them; null: nothing. Where it says true, Build() ends with an error, and both leave the caster
   * as if they had not been called, but for the scene before. vtkHeliosObbTreeRayCaster asks at its
   * start only.
   */
  void SetShouldStop(const std::function<bool()>& shouldStop);

  /// The triangles it was built from.
  const helios::TriangleMesh& GetMesh() const
  {
    return *this->Mesh;
  }
#endif

protected:
  vtkHeliosRayCaster();
  ~vtkHeliosRayCaster() override;

  /// Makes the accelerator of the mesh; false after an error.
  virtual bool BuildAccelerator(const helios::TriangleMesh& mesh) = 0;

#ifndef __VTK_WRAP__
  /// To be asked while an accelerator is built: it throws out of BuildAccelerator().
  helios::StopCheck& GetStopCheck()
  {
    return *this->Check;
  }

  const std::function<bool()>& GetShouldStop() const
  {
    return this->ShouldStop;
  }
#endif

  /// The accelerator, if it is what ProbeCone() needs.
  virtual const helios::BeamTree* GetBeamTree() const
  {
    return nullptr;
  }

private:
  vtkHeliosRayCaster(const vtkHeliosRayCaster&) = delete;
  void operator=(const vtkHeliosRayCaster&) = delete;

  /// Whether the accelerator is that of a scene, or of another one with the same triangles.
  bool IsBuilt(vtkPolyData* scene) const;

  bool TryToBuild();

  std::function<bool()> ShouldStop;
  std::unique_ptr<helios::StopCheck> Check;
  std::unique_ptr<helios::TriangleMesh> Mesh;
  std::unique_ptr<helios::BeamTree> OwnConeTree;
  const helios::BeamTree* ConeTree = nullptr; ///< once it is prepared
  vtkWeakPointer<vtkPolyData> BuiltScene;
  vtkPoints* BuiltPoints = nullptr;   ///< of the scene, held by it
  vtkCellArray* BuiltPolys = nullptr; ///< of the scene, held by it
  vtkMTimeType BuiltTime = 0;
};

#endif
