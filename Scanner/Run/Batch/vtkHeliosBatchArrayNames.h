// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosBatchArrayNames
 * @brief   names of the arrays of vtkHeliosScanBatch
 *
 * All others are in vtkHeliosArrayNames.
 */

#ifndef vtkHeliosBatchArrayNames_h
#define vtkHeliosBatchArrayNames_h

namespace vtkHeliosBatchArrayNames
{

/** Poses of scans: point data. */
inline constexpr const char* SceneIds = "SceneIds"; // int64, from 0

/** Field data of the echoes of scans: int64, where each begins, and the end. */
inline constexpr const char* Offsets = "Offsets";

} // namespace vtkHeliosBatchArrayNames

#endif
