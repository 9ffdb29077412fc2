// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPoseTextWriter
 * @brief   write a trajectory as TUM or EuRoC text
 *
 * TUM: a row per sample, t x y z qx qy qz qw, separated by blanks: GPS time [s], 9 decimals;
 * position [m], 6 decimals; quaternion from the body (x right, y forward, z up) to the world, 9
 * decimals. EuRoC: a header line, then t,x,y,z,qw,qx,qy,qz with t in whole nanoseconds.
 *
 * Blocks: samples in the layout of vtkHeliosPlatform and vtkHeliosTrajectoryReader: vtkPolyData,
 * double points, point arrays GpsTime [s] and Orientation (quaternion w, x, y, z, of any nonzero
 * length, written normalized). A block without points needs no arrays.
 *
 * Error, besides the errors of vtkHeliosStreamWriter: a time that EuRoC cannot store, beyond 9.2e9
 * s.
 *
 * @sa
 * vtkHeliosTrajectoryReader vtkHeliosSBETWriter vtkHeliosTrajectoryTextWriter
 */

#ifndef vtkHeliosPoseTextWriter_h
#define vtkHeliosPoseTextWriter_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkHeliosStreamWriter.h"

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosPoseTextWriter : public vtkHeliosStreamWriter
{
public:
  static vtkHeliosPoseTextWriter* New();
  vtkTypeMacro(vtkHeliosPoseTextWriter, vtkHeliosStreamWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Formats of files.
  enum FileFormats
  {
    TUM = 0,
    EUROC = 1
  };

  ///@{
  /**
   * Set/Get the format, applied by Open(). Default: TUM.
   */
  vtkSetClampMacro(FileFormat, int, TUM, EUROC);
  vtkGetMacro(FileFormat, int);
  void SetFileFormatToTum() { this->SetFileFormat(TUM); }
  void SetFileFormatToEuroc() { this->SetFileFormat(EUROC); }
  ///@}

  /**
   * Creates the file; with EUROC, write its header line.
   */
  bool Open() override;

  /**
   * Appends the samples of a block.
   */
  bool Write(vtkDataObject* block) override;

protected:
  vtkHeliosPoseTextWriter() = default;
  ~vtkHeliosPoseTextWriter() override = default;

  const char* GetBlockSource() const override;

private:
  vtkHeliosPoseTextWriter(const vtkHeliosPoseTextWriter&) = delete;
  void operator=(const vtkHeliosPoseTextWriter&) = delete;

  int FileFormat = TUM;
};

#endif
