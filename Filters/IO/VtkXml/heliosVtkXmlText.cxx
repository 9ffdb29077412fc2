// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosVtkXmlText.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLTableReader.h>

namespace helios
{

namespace
{

template <typename ReaderT>
vtkSmartPointer<vtkDataObject> ReadText(const std::string& text)
{
  vtkNew<ReaderT> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(text);
  reader->Update();
  return reader->GetOutput();
}

} // namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> ReadVtkXmlText(const std::string& text, bool isTable)
{
  return isTable ? ReadText<vtkXMLTableReader>(text) : ReadText<vtkXMLPolyDataReader>(text);
}

} // namespace helios
