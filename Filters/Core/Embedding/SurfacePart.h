/**
 * @file SurfacePart.h
 * @brief A range of a surface's facets as a surface of its own, and how it is sent to another rank.
 */
#ifndef remesh_SurfacePart_h
#define remesh_SurfacePart_h

#include "Embedding/EmbeddedSurface.h"
#include "Support/Ranks.h"

namespace remesh
{
/**
 * The facets [begin, end) and their corners, in the same order. What is computed of a facet is the
 * same in both surfaces, to the bit. Coordinates that are lent are copied. Its masses are the whole
 * surface's.
 */
EmbeddedSurface partOf(const EmbeddedSurface& surface, Offset begin, Offset end);

void addSurface(const EmbeddedSurface& surface, Packet& packet);
EmbeddedSurface takeSurface(Packet& packet);
}

#endif
