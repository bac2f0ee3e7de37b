/**
 * @file FeaturedSurface.h
 * @brief A surface with its features: cut open along them, and embedded.
 */
#ifndef remesh_FeaturedSurface_h
#define remesh_FeaturedSurface_h

#include "Embedding/EmbeddedSurface.h"
#include "Features/Features.h"

namespace remesh
{
/** Three views of one surface, that must outlive this one. */
struct FeaturedSurface
{
  const SurfaceMesh& mesh;
  const EmbeddedSurface& surface;
  const Features& features;
};
}

#endif
