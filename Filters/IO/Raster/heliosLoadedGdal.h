// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Functions of a GDAL that is loaded at run time: each name is looked up when it is called.

#ifndef heliosLoadedGdal_h
#define heliosLoadedGdal_h

namespace helios
{

/// Returns the address of a function in the loaded library; null if it has none.
void* FindGdalFunction(const char* name);

} // namespace helios

#define HELIOS_GDAL(name) reinterpret_cast<decltype(&name)>(helios::FindGdalFunction(#name))

#define CPLErrorReset HELIOS_GDAL(CPLErrorReset)
#define CPLGetConfigOption HELIOS_GDAL(CPLGetConfigOption)
#define CPLGetErrorHandlerUserData HELIOS_GDAL(CPLGetErrorHandlerUserData)
#define CPLPopErrorHandler HELIOS_GDAL(CPLPopErrorHandler)
#define CPLPushErrorHandlerEx HELIOS_GDAL(CPLPushErrorHandlerEx)
#define CPLSetConfigOption HELIOS_GDAL(CPLSetConfigOption)
#define CPLSetThreadLocalConfigOption HELIOS_GDAL(CPLSetThreadLocalConfigOption)
#define CSLDestroy HELIOS_GDAL(CSLDestroy)
#define GDALClose HELIOS_GDAL(GDALClose)
#define GDALDataTypeIsComplex HELIOS_GDAL(GDALDataTypeIsComplex)
#define GDALGetBlockSize HELIOS_GDAL(GDALGetBlockSize)
#define GDALGetDataCoverageStatus HELIOS_GDAL(GDALGetDataCoverageStatus)
#define GDALGetDataTypeName HELIOS_GDAL(GDALGetDataTypeName)
#define GDALGetDataTypeSizeBytes HELIOS_GDAL(GDALGetDataTypeSizeBytes)
#define GDALGetDatasetDriver HELIOS_GDAL(GDALGetDatasetDriver)
#define GDALGetDriverShortName HELIOS_GDAL(GDALGetDriverShortName)
#define GDALGetFileList HELIOS_GDAL(GDALGetFileList)
#define GDALGetGCPCount HELIOS_GDAL(GDALGetGCPCount)
#define GDALGetGeoTransform HELIOS_GDAL(GDALGetGeoTransform)
#define GDALGetMaskBand HELIOS_GDAL(GDALGetMaskBand)
#define GDALGetMaskFlags HELIOS_GDAL(GDALGetMaskFlags)
#define GDALGetMetadataItem HELIOS_GDAL(GDALGetMetadataItem)
#define GDALGetRasterBand HELIOS_GDAL(GDALGetRasterBand)
#define GDALGetRasterCount HELIOS_GDAL(GDALGetRasterCount)
#define GDALGetRasterDataType HELIOS_GDAL(GDALGetRasterDataType)
#define GDALGetRasterNoDataValue HELIOS_GDAL(GDALGetRasterNoDataValue)
#define GDALGetRasterNoDataValueAsInt64 HELIOS_GDAL(GDALGetRasterNoDataValueAsInt64)
#define GDALGetRasterNoDataValueAsUInt64 HELIOS_GDAL(GDALGetRasterNoDataValueAsUInt64)
#define GDALGetRasterOffset HELIOS_GDAL(GDALGetRasterOffset)
#define GDALGetRasterScale HELIOS_GDAL(GDALGetRasterScale)
#define GDALGetRasterUnitType HELIOS_GDAL(GDALGetRasterUnitType)
#define GDALGetRasterXSize HELIOS_GDAL(GDALGetRasterXSize)
#define GDALGetRasterYSize HELIOS_GDAL(GDALGetRasterYSize)
#define GDALGetSpatialRef HELIOS_GDAL(GDALGetSpatialRef)
#define GDALOpenEx HELIOS_GDAL(GDALOpenEx)
#define GDALRasterIO HELIOS_GDAL(GDALRasterIO)
#define GDALRegister_GTiff HELIOS_GDAL(GDALRegister_GTiff)
#define GDALRegister_VRT HELIOS_GDAL(GDALRegister_VRT)
#define GDALSetCacheMax64 HELIOS_GDAL(GDALSetCacheMax64)
#define OSRDestroySpatialReference HELIOS_GDAL(OSRDestroySpatialReference)
#define OSRExportToWktEx HELIOS_GDAL(OSRExportToWktEx)
#define OSRGetAttrValue HELIOS_GDAL(OSRGetAttrValue)
#define OSRGetLinearUnits HELIOS_GDAL(OSRGetLinearUnits)
#define OSRGetName HELIOS_GDAL(OSRGetName)
#define OSRIsLocal HELIOS_GDAL(OSRIsLocal)
#define OSRIsProjected HELIOS_GDAL(OSRIsProjected)
#define OSRNewSpatialReference HELIOS_GDAL(OSRNewSpatialReference)
#define OSRSetPROJSearchPaths HELIOS_GDAL(OSRSetPROJSearchPaths)
#define OSRSetVertCS HELIOS_GDAL(OSRSetVertCS)
#define OSRStripVertical HELIOS_GDAL(OSRStripVertical)
#define VSIFree HELIOS_GDAL(VSIFree)
#define VSIStatL HELIOS_GDAL(VSIStatL)

#endif
