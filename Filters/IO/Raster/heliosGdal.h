// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The C interface of GDAL, linked or (VTKHELIOS_LOAD_GDAL) loaded.

#ifndef heliosGdal_h
#define heliosGdal_h

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <gdal_frmts.h>
#include <ogr_srs_api.h>

#ifdef VTKHELIOS_LOAD_GDAL
#include "heliosLoadedGdal.h"
#endif

#endif
