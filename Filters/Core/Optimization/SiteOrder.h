/**
 * @file SiteOrder.h
 * @brief Sites that come in any order, as a caller may give them, put along a curve through space:
 * what is near is then near in memory, too.
 */
#ifndef remesh_SiteOrder_h
#define remesh_SiteOrder_h

#include "Embedding/EmbeddedSurface.h"
#include "Support/RunControl.h"

namespace remesh
{
/**
 * Whether sites that follow one another are, in the mean, more than a tenth of the diagonal of the
 * box around all apart. Few sites always are; of many, those drawn from a surface are not. In such
 * an order a run takes longer; and it ends with other sites, as rounding depends on the order.
 * O(n d).
 */
bool areScattered(const Sites& sites);

/** The sites along the Hilbert curve of their first three coordinates. O(n). */
std::vector<Index> orderInSpace(const Sites& sites, const RunControl& control = RunControl());

/** Site k of the result is site order[k]; all are free. Sites may be left out. O(n d). */
Sites inOrder(const Sites& sites, const std::vector<Index>& order);

/** Undoes `inOrder` with all sites. */
Sites inFormerOrder(const Sites& ordered, const std::vector<Index>& order);
}

#endif
