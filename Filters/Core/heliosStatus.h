// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether a call succeeded, and the error message if not.

#ifndef heliosStatus_h
#define heliosStatus_h

#include <string>
#include <utility>

namespace helios
{

/**
 * Result of a call that can fail:
 *
 *   Status Open(const std::string& path)
 *   {
 *     if (const Status status = CheckInputFile(path); !status.IsOk())
 *     {
 *       return Status::Error(path + ": " + status.Message());
 *     }
 *     return {};
 *   }
 *
 * Success allocates no memory. The compiler refuses calls that ignore the result.
 */
class [[nodiscard]] Status
{
public:
  /// Success.
  Status() = default;

  /// Returns a failure; the message must not be empty.
  static Status Error(std::string message)
  {
    Status status;
    status.Text = std::move(message);
    return status;
  }

  bool IsOk() const { return this->Text.empty(); }

  /// Returns the error message, empty after success.
  const std::string& Message() const { return this->Text; }

private:
  std::string Text;
};

} // namespace helios

#endif
