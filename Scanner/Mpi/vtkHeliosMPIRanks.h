// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosMPIRanks
 * @brief   the ranks of MPI share a run
 *
 * Passes messages by VTK's vtkMPIController. Sending does not wait for the receiver unless two
 * messages to it are on the way, so that a rank computes while its last block is sent. All ranks call
 * Initialize() first and Finalize() last.
 *
 * @sa
 * vtkHeliosRanks vtkHeliosSurveyPlayer
 */

#ifndef vtkHeliosMPIRanks_h
#define vtkHeliosMPIRanks_h

#include "vtkHeliosRanks.h"
#include "vtkHeliosScannerMpiModule.h" // For export macro
#include "vtkSmartPointer.h"           // For the controller

#include <memory> // For messages on the way

class vtkMPIController;

class VTKHELIOSSCANNERMPI_EXPORT vtkHeliosMPIRanks : public vtkHeliosRanks
{
public:
  static vtkHeliosMPIRanks* New();
  vtkTypeMacro(vtkHeliosMPIRanks, vtkHeliosRanks);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Starts and ends MPI, once in a process. Finalize() waits until all messages have been received.
   */
  void Initialize();
  void Finalize();
  ///@}

  ///@{
  /**
   * Returns the number of ranks, and which of them this process is. 1 and 0 before Initialize().
   */
  int GetNumberOfRanks() const override;
  int GetRank() const override;
  ///@}

#ifndef __VTK_WRAP__
  std::string Send(int rank, const std::string& message) override;
#endif

protected:
  vtkHeliosMPIRanks();
  ~vtkHeliosMPIRanks() override;

  bool ReceiveNext(int& rank, std::string& message) override;

private:
  vtkHeliosMPIRanks(const vtkHeliosMPIRanks&) = delete;
  void operator=(const vtkHeliosMPIRanks&) = delete;

  bool BeginReceiving();

  struct Internals;
  std::unique_ptr<Internals> Data;
};

#endif
