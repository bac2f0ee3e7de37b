#include "Mesh/BoxTree.h"

#include <algorithm>

namespace remesh
{
void BoxTree::widen(const BoxGroup& boxes, Point3& lower, Point3& upper)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    lower[axis] =
      std::min(lower[axis], *std::min_element(boxes.lower[axis], boxes.lower[axis] + lanes));
    upper[axis] =
      std::max(upper[axis], *std::max_element(boxes.upper[axis], boxes.upper[axis] + lanes));
  }
}
}
