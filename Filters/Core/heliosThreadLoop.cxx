// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosThreadLoop.h"

namespace helios
{

namespace
{

thread_local int Scopes = 0;

} // namespace

//------------------------------------------------------------------------------
OneThreadScope::OneThreadScope()
{
  ++Scopes;
}

//------------------------------------------------------------------------------
OneThreadScope::~OneThreadScope()
{
  --Scopes;
}

//------------------------------------------------------------------------------
bool OneThreadScope::IsOn()
{
  return Scopes > 0;
}

} // namespace helios
