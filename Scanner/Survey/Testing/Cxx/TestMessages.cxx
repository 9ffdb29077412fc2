// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Messages of a thread that writes are reported by the thread of the run.
#include "heliosErrorObserver.h"
#include "heliosMessages.h"

#include <vtkNew.h>
#include <vtkObject.h>

#include <catch2/catch.hpp>

#include <thread>

namespace
{

/// An owner of messages, and an object that it listens to.
struct Listening
{
  vtkNew<vtkObject> Owner;
  vtkNew<vtkObject> Object;
  vtkNew<helios::ErrorObserver> Log;
  helios::Messages Messages{ this->Owner };

  Listening()
  {
    this->Log->Watch(this->Owner);
    this->Messages.Listen(this->Object.Get(), "survey.xml:7");
  }

  void Fail() { vtkErrorWithObjectMacro(this->Object, << "the disk is full"); }
  void Warn() { vtkWarningWithObjectMacro(this->Object, << "2 records are left out"); }
};

} // namespace

TEST_CASE("Messages: those of another thread are deferred", "[Messages]")
{
  Listening listening;
  std::thread writer(
    [&listening]
    {
      const helios::Messages::DeferredMessages deferral;
      listening.Warn();
      listening.Fail();
    });
  writer.join();
  CHECK_FALSE(listening.Messages.HasError());
  CHECK(listening.Log->Errors.empty());
  listening.Messages.ReportDeferred();
  CHECK(listening.Messages.GetLastError() == "survey.xml:7: the disk is full");
  CHECK(listening.Log->HasError("survey.xml:7: the disk is full"));
  CHECK(listening.Log->HasWarning("survey.xml:7: 2 records are left out"));
  listening.Messages.ReportDeferred();
  CHECK(listening.Messages.GetNumberOfErrors() == 1);
}

TEST_CASE("Messages: after a deferral they are reported at once", "[Messages]")
{
  Listening listening;
  {
    const helios::Messages::DeferredMessages deferral;
  }
  listening.Fail();
  CHECK(listening.Messages.GetLastError() == "survey.xml:7: the disk is full");
}
