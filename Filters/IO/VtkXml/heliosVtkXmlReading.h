// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads a file with a VTK XML reader, after validation and without exceptions.

#ifndef heliosVtkXmlReading_h
#define heliosVtkXmlReading_h

#include "heliosStatus.h"
#include "heliosVtkXmlFile.h"

#include <vtkCommand.h>
#include <vtkDataCompressor.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataParser.h>

namespace helios
{

/// Collects the messages of VTK readers, to report a single error.
class FaultListener : public vtkCommand
{
public:
  static FaultListener* New() { return new FaultListener; }
  void Execute(vtkObject*, unsigned long, void*) override { this->HasFault = true; }
  void Listen(vtkObject* object)
  {
    object->AddObserver(vtkCommand::ErrorEvent, this);
    object->AddObserver(vtkCommand::WarningEvent, this);
  }
  bool HasFault = false;
};

/// Reads the data of a file with a VTK reader; null: see the problem, which gives a remedy.
template <typename ReaderT, typename DataT>
vtkSmartPointer<DataT> ReadVtkXml(
  const std::string& path, const std::string& type, std::string& problem)
{
  VtkXmlFile file;
  if (!file.Open(path, type) || file.GetKind() != VtkXmlFile::Kind::Single)
  {
    problem = file.GetProblem().empty() ? "is an index of pieces; give a file with data"
                                        : file.GetProblem();
    return nullptr;
  }
  const auto faults = vtkSmartPointer<FaultListener>::Take(FaultListener::New());
  vtkNew<ReaderT> reader;
  faults->Listen(reader);
  faults->Listen(reader->GetExecutive());
  reader->SetFileName(path.c_str());
  Status status = CatchExceptions(
    [&reader, &faults]()
    {
      reader->UpdateInformation();
      vtkXMLDataParser* parser = reader->GetXMLParser();
      vtkDataCompressor* compressor = parser ? parser->GetCompressor() : nullptr;
      for (vtkObject* each :
        { static_cast<vtkObject*>(parser), static_cast<vtkObject*>(compressor) })
      {
        if (each)
        {
          faults->Listen(each);
        }
      }
      if (!faults->HasFault)
      {
        reader->Update();
      }
    });
  status = status.IsOk() && faults->HasFault ? Status::Error("VTK's reader fails") : status;
  if (!status.IsOk())
  {
    problem = "cannot be read: " + status.Message() + "; copy or write the file again";
    return nullptr;
  }
  return reader->GetOutput();
}

} // namespace helios

#endif
