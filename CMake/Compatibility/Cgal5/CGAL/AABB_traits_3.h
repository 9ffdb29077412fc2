// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The header of CGAL 6 for CGAL 5, which calls the class AABB_traits.

#ifndef heliosCgal5_h
#define heliosCgal5_h

#include <CGAL/AABB_traits.h>

namespace CGAL
{

template <typename KernelT, typename PrimitiveT>
using AABB_traits_3 = AABB_traits<KernelT, PrimitiveT>;

} // namespace CGAL

#endif
