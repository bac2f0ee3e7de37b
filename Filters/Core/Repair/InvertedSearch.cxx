#include "Repair/InvertedSearch.h"

#include "Placement/TriangleShape.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <optional>

namespace remesh
{
namespace
{
std::vector<Index> listMarked(const std::vector<char>& isMarked)
{
  std::vector<Index> marked;
  for (std::size_t k = 0; k < isMarked.size(); ++k)
  {
    if (isMarked[k])
    {
      marked.push_back(static_cast<Index>(k));
    }
  }
  return marked;
}
}

/** Whether the last search, or in the first one the suspects, tell of a triangle. */
bool InvertedSearch::isKnown(std::size_t triangle, const std::vector<Triple>& triangles,
  const std::vector<Point3>& positions, const std::vector<char>* suspects) const
{
  if (m_triangles.empty())
  {
    return suspects && !(*suspects)[triangle];
  }
  const Triple& corners = triangles[triangle];
  return corners == m_triangles[triangle] &&
    std::all_of(
      corners.begin(), corners.end(), [&](Index v) { return positions[v] == m_positions[v]; });
}

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
  if (!forEachItem(Blocks::cut(static_cast<Offset>(triangles.size()), 64, 4096), control.silent(),
        [&](Offset t)
        {
          if (!this->isKnown(static_cast<std::size_t>(t), triangles, positions, suspects))
          {
            const Corners corners = cornersOf(triangles[t], positions);
            m_isInverted[t] = cones ? m_surface.isInverted(triangles[t], corners, *cones)
                                    : m_surface.isInverted(triangles[t], corners);
          }
        }))
  {
    m_triangles.clear(); // some of them are not judged
    return Status::cancelled();
  }
  inverted = listMarked(m_isInverted);
  if (!first || !inverted.empty()) // else there is nothing to repair, and no other search
  {
    m_triangles = triangles;
    m_positions = positions;
  }
  return Status::success();
}

void InvertedSearch::know(const std::vector<Triple>& triangles,
  const std::vector<Point3>& positions, const std::vector<Index>& inverted)
{
  m_triangles = triangles;
  m_positions = positions;
  m_isInverted.assign(triangles.size(), 0);
  for (const Index t : inverted)
  {
    m_isInverted[t] = 1;
  }
}
}
