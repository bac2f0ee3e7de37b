/**
 * @file remeshingAppearance.h
 * @brief How ParaView first draws the filters' outputs, in its window and in scripts.
 */
#ifndef remeshingAppearance_h
#define remeshingAppearance_h

/**
 * Adds defaults below the user's own to ParaView's settings: a palette that parts neighbouring
 * cells for `CellColor`, named colours for `EdgeType`, flat triangles for meshes, thick lines for
 * the port Edges.
 */
void addRemeshingAppearance();

#endif
