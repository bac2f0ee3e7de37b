#include "Repair/InvertedSearch.h"

#include "Placement/TriangleShape.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <optional>

namespace remesh
{
Status InvertedSearch::find(const std::vector<Triple>& triangles,
  const std::vector<Point3>& positions, const RunControl& control, std::vector<Index>& inverted,
  const std::vector<char>* suspects)
{
  const bool first = m_triangles.empty();
  if (first)
  {
    m_isInverted.assign(triangles.size(), 0);
  }
  std::optional<NormalCones> cones; // worth their time where all triangles are judged
  if (first && !suspects)
  {
    cones.emplace(m_surface.problem(), control);
  }
  const auto isKnown = [&](std::size_t t)
  {
    if (first)
    {
      return suspects && !(*suspects)[t];
    }
    return triangles[t] == m_triangles[t] &&
      std::all_of(triangles[t].begin(), triangles[t].end(),
        [&](Index v) { return positions[v] == m_positions[v]; });
  };
  if (!forEachRange(Blocks::cut(static_cast<Offset>(triangles.size()), 64, 4096), control.silent(),
        [&](Offset begin, Offset end)
        {
          for (auto t = static_cast<std::size_t>(begin); t < static_cast<std::size_t>(end); ++t)
          {
            if (!isKnown(t))
            {
              const Corners corners = cornersOf(triangles[t], positions);
              m_isInverted[t] = cones ? m_surface.isInverted(triangles[t], corners, *cones)
                                      : m_surface.isInverted(triangles[t], corners);
            }
          }
        }))
  {
    m_triangles.clear(); // some of them are not judged
    return Status::cancelled();
  }
  inverted.clear();
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (m_isInverted[t])
    {
      inverted.push_back(static_cast<Index>(t));
    }
  }
  m_triangles.clear();
  if (!inverted.empty()) // else there is nothing to repair, and no other search
  {
    m_triangles = triangles;
    m_positions = positions;
  }
  return Status::success();
}
}
