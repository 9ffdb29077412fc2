// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosScanBatch
 * @brief   many scans of small scenes by one sensor
 *
 * The sensor is the scanner of leg 0 of a survey, set up once; its scene, platform and mount do not
 * count. Each scan has the pulses of the leg, at one pose. Scans are divided among threads, each of
 * which has a scanner and a tree of its own, and makes consecutive scans of a scene; fewer scans
 * than threads are made one after the other, each by all threads. The echoes do not depend on that:
 * scan i has the pulse ids from i times the pulses of a scan, and their random numbers.
 *
 * Input 0, repeatable: the scenes (vtkPolyData, triangles), as for vtkHeliosScanner; reflectances
 * are those of their materials, spectra are not read. The tree of a scene is kept until another one
 * is scanned, or it changes.
 *
 * Input 1: the poses (vtkPolyData): points [m], Orientation (unit quaternion w, x, y, z, of the
 * scanner to the world; x right, y forward, z up), and SceneIds, the scene of each; without it, that
 * of the same number, or the only one.
 *
 * Output: the echoes (vtkPolyData) of all scans in their order, with the point arrays of Arrays, and
 * the field array Offsets: echoes Offsets[i] to Offsets[i + 1] are of scan i.
 *
 * Events: ProgressEvent.
 *
 * @sa
 * vtkHeliosScanner vtkHeliosSurveySource
 */

#ifndef vtkHeliosScanBatch_h
#define vtkHeliosScanBatch_h

#include "vtkHeliosScannerRunModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For the source

#include <memory> // For the workers
#include <string> // For Arrays
#include <vector> // For the workers

class vtkHeliosSurveySource;

namespace helios
{
class BatchWorker;
}

class VTKHELIOSSCANNERRUN_EXPORT vtkHeliosScanBatch : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosScanBatch* New();
  vtkTypeMacro(vtkHeliosScanBatch, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the survey whose leg 0 has the sensor. Default: none.
   */
  void SetSource(vtkHeliosSurveySource* source);
  vtkHeliosSurveySource* GetSource() const;
  ///@}

  ///@{
  /**
   * Set/Get the point arrays of the output, separated by blanks. Default: empty, all.
   */
  vtkSetMacro(Arrays, std::string);
  vtkGetMacro(Arrays, std::string);
  ///@}

  /**
   * Returns the pulses of a scan, after an update; 0 before.
   */
  vtkIdType GetPulsesPerScan() const;

protected:
  vtkHeliosScanBatch();
  ~vtkHeliosScanBatch() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosScanBatch(const vtkHeliosScanBatch&) = delete;
  void operator=(const vtkHeliosScanBatch&) = delete;

  struct Scans;

  bool Prepare(std::size_t workers);
  bool ReadScans(vtkInformationVector** inputs, Scans& scans);
  bool CheckPose(vtkIdType scan, const Scans& scans);
  void Run(Scans& scans, std::size_t workers);
  void RunItems(Scans& scans, helios::BatchWorker& worker, bool reports);

  vtkSmartPointer<vtkHeliosSurveySource> Source;
  std::string Arrays;
  std::vector<std::unique_ptr<helios::BatchWorker>> Workers;
  vtkMTimeType WorkersTime = 0;
};

#endif
