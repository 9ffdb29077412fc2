// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Embree 3 and Embree 4 by one interface. Embree 4 takes the context of a query within arguments.

#ifndef heliosEmbree_h
#define heliosEmbree_h

#if HELIOS_EMBREE_VERSION == 3
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif

namespace helios
{

#if HELIOS_EMBREE_VERSION == 3

using EmbreeContext = RTCIntersectContext;

inline void InitContext(EmbreeContext& context)
{
  rtcInitIntersectContext(&context);
}

/// Calls rtcIntersect1 or rtcOccluded1.
template <typename RayT>
void TraceRay(
  void (*trace)(RTCScene, EmbreeContext*, RayT*), RTCScene scene, EmbreeContext& context, RayT& ray)
{
  trace(scene, &context, &ray);
}

/// Calls rtcIntersect4, 8, 16, or rtcOccluded4, 8, 16; rays that are not valid (-1) are left out.
template <typename RaysT>
void TracePacket(void (*trace)(const int*, RTCScene, EmbreeContext*, RaysT*), const int* valid,
  RTCScene scene, EmbreeContext& context, void* rays)
{
  trace(valid, scene, &context, static_cast<RaysT*>(rays));
}

#else

using EmbreeContext = RTCRayQueryContext;

inline void InitContext(EmbreeContext& context)
{
  rtcInitRayQueryContext(&context);
}

inline void InitArguments(RTCIntersectArguments& arguments, EmbreeContext& context)
{
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
}
inline void InitArguments(RTCOccludedArguments& arguments, EmbreeContext& context)
{
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
}

/// Calls rtcIntersect1 or rtcOccluded1.
template <typename RayT, typename ArgumentsT>
void TraceRay(
  void (*trace)(RTCScene, RayT*, ArgumentsT*), RTCScene scene, EmbreeContext& context, RayT& ray)
{
  ArgumentsT arguments;
  InitArguments(arguments, context);
  trace(scene, &ray, &arguments);
}

/// Calls rtcIntersect4, 8, 16, or rtcOccluded4, 8, 16; rays that are not valid (-1) are left out.
template <typename RaysT, typename ArgumentsT>
void TracePacket(void (*trace)(const int*, RTCScene, RaysT*, ArgumentsT*), const int* valid,
  RTCScene scene, EmbreeContext& context, void* rays)
{
  ArgumentsT arguments;
  InitArguments(arguments, context);
  trace(valid, scene, static_cast<RaysT*>(rays), &arguments);
}

#endif

} // namespace helios

#endif
