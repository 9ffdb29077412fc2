// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosRanks
 * @brief   processes that share a run
 *
 * A rank is one of several processes with the same survey and options. Rank 0 runs the survey
 * (vtkHeliosSurveyPlayer::Run()): it gives blocks of pulses to the other ranks and writes what they
 * send; these serve it (vtkHeliosSurveyPlayer::Serve()). Subclasses pass messages between ranks,
 * such as vtkHeliosMPIRanks; messages from one rank to another arrive in order.
 *
 * @sa
 * vtkHeliosSurveyPlayer
 */

#ifndef vtkHeliosRanks_h
#define vtkHeliosRanks_h

#include "vtkHeliosScannerRunModule.h" // For export macro
#include "vtkObject.h"

#include <string> // For messages

class VTKHELIOSSCANNERRUN_EXPORT vtkHeliosRanks : public vtkObject
{
public:
  vtkTypeMacro(vtkHeliosRanks, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Returns the number of ranks, and which of them this process is, counted from 0.
   */
  virtual int GetNumberOfRanks() const = 0;
  virtual int GetRank() const = 0;
  ///@}

  /**
   * Ends the service of the other ranks; for rank 0, when it needs them no more.
   */
  void Dismiss();

  ///@{
  /**
   * Get the messages received from other ranks so far, and their bytes.
   */
  vtkGetMacro(NumberOfMessages, vtkIdType);
  vtkGetMacro(NumberOfBytes, vtkIdType);
  ///@}

#ifndef __VTK_WRAP__
  /**
   * Sends a message to a rank. Returns the error message; an empty string after success.
   */
  virtual std::string Send(int rank, const std::string& message) = 0;

  /**
   * Returns the next message that has arrived and its rank; false if no message has.
   */
  bool Receive(int& rank, std::string& message);
#endif

protected:
  vtkHeliosRanks() = default;
  ~vtkHeliosRanks() override = default;

  /// Receives like Receive(), without counting.
  virtual bool ReceiveNext(int& rank, std::string& message) = 0;

private:
  vtkHeliosRanks(const vtkHeliosRanks&) = delete;
  void operator=(const vtkHeliosRanks&) = delete;

  vtkIdType NumberOfMessages = 0;
  vtkIdType NumberOfBytes = 0;
};

#endif
