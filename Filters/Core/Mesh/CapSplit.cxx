#include "Mesh/CapSplit.h"

#include "Mesh/FacetGeometry.h"

#include <algorithm>
#include <deque>
#include <unordered_map>
#include <utility>

namespace remesh
{
namespace
{
/** Each split makes a shorter side of a longer one; a bound for what rounding might make of it. */
constexpr std::size_t maxSplits = 16; // for each cap there was

class CapSplit
{
public:
  CapSplit(const TriangleSoup& soup, std::vector<unsigned char>& marked, Draft& draft)
    : m_soup(soup)
    , m_marked(marked)
    , m_draft(draft)
  {
  }

  void run(const RunControl& control)
  {
    std::vector<char> isCorner;
    std::deque<Index> caps = this->findCaps(isCorner);
    if (caps.empty())
    {
      return;
    }
    m_gone.assign(m_draft.facets.size(), 0);
    // Sides with a corner of a cap: no others matter, then or later.
    for (std::size_t f = 0; f < m_draft.facets.size(); ++f)
    {
      const auto& [a, b, c] = m_draft.facets[f];
      if (a != b && b != c && c != a && (isCorner[a] || isCorner[b] || isCorner[c]))
      {
        this->enter(static_cast<Index>(f));
      }
    }
    m_draft.facetInputs.reserve(m_draft.facets.size());
    for (const Index triangle : m_draft.facetTriangles)
    {
      m_draft.facetInputs.push_back(m_soup.triangles[triangle]);
    }
    for (std::size_t splits = maxSplits * caps.size(); !caps.empty() && splits > 0 &&
         static_cast<std::int64_t>(m_draft.facets.size()) < maximumInputTriangles &&
         !control.cancelled();
         --splits)
    {
      this->replace(caps.front(), caps);
      caps.pop_front();
    }
  }

private:
  /** Marked facets with three corners, and which points these are. */
  std::deque<Index> findCaps(std::vector<char>& isCorner) const
  {
    std::deque<Index> caps;
    isCorner.assign(m_draft.points.size(), 0);
    for (std::size_t f = 0; f < m_draft.facets.size(); ++f)
    {
      const auto& [a, b, c] = m_draft.facets[f];
      if (m_marked[f] && a != b && b != c && c != a)
      {
        caps.push_back(static_cast<Index>(f));
        isCorner[a] = isCorner[b] = isCorner[c] = 1;
      }
    }
    return caps;
  }

  static std::uint64_t keyOf(Index a, Index b)
  {
    return static_cast<std::uint64_t>(std::min(a, b)) << 32U |
      static_cast<std::uint64_t>(std::max(a, b));
  }

  /** Two caps on the same corners make each other needless: then false, and both are gone. */
  bool enter(Index facet)
  {
    const Triple& corners = m_draft.facets[facet];
    if (m_marked[facet])
    {
      for (const Index other : m_around[keyOf(corners[0], corners[1])])
      {
        if (m_marked[other] && has(m_draft.facets[other], corners[2]))
        {
          m_gone[facet] = m_gone[other] = 1;
          this->leave(other);
          return false;
        }
      }
    }
    for (int k = 0; k < 3; ++k)
    {
      m_around[keyOf(corners[k], corners[(k + 1) % 3])].push_back(facet);
    }
    return true;
  }

  void leave(Index facet)
  {
    const Triple& corners = m_draft.facets[facet];
    for (int k = 0; k < 3; ++k)
    {
      std::vector<Index>& around = m_around[keyOf(corners[k], corners[(k + 1) % 3])];
      around.erase(std::remove(around.begin(), around.end(), facet), around.end());
    }
  }

  /** The corner across the longest side. */
  int middleOf(Index facet) const
  {
    const Triple& corners = m_draft.facets[facet];
    double longest = -1.0;
    int middle = 0;
    for (int k = 0; k < 3; ++k)
    {
      const double squared =
        (m_draft.points[corners[(k + 1) % 3]] - m_draft.points[corners[(k + 2) % 3]]).squaredNorm();
      if (squared > longest)
      {
        longest = squared;
        middle = k;
      }
    }
    return middle;
  }

  /** The cap goes, and its neighbours across the longest side are split. */
  void replace(Index cap, std::deque<Index>& caps)
  {
    if (m_gone[cap] || !m_marked[cap])
    {
      return;
    }
    const int k = this->middleOf(cap);
    const Triple corners = m_draft.facets[cap];
    const Offset inputPoint = m_draft.facetInputs[cap][k];
    this->leave(cap);
    m_gone[cap] = 1;
    m_free = cap;
    const std::vector<Index> neighbors =
      m_around[keyOf(corners[(k + 1) % 3], corners[(k + 2) % 3])];
    for (const Index neighbor : neighbors)
    {
      if (m_gone[neighbor]) // by a part of another one
      {
        continue;
      }
      this->split(neighbor, corners[k], inputPoint, corners, caps);
    }
  }

  /** Splits a facet at a point on its side between two of these corners. */
  void split(
    Index facet, Index point, Offset inputPoint, const Triple& corners, std::deque<Index>& caps)
  {
    const Triple whole = m_draft.facets[facet];
    const std::array<Offset, 3> inputs = m_draft.facetInputs[facet];
    int far = 0; // the corner across
    while (whole[(far + 1) % 3] == point || whole[(far + 2) % 3] == point ||
      !has(corners, whole[(far + 1) % 3]) || !has(corners, whole[(far + 2) % 3]))
    {
      ++far;
    }
    this->leave(facet);
    const int first = (far + 1) % 3;
    const int second = (far + 2) % 3;
    const Index part = this->placeForFacet();
    m_draft.facets[part] = whole;
    m_draft.facetTriangles[part] = m_draft.facetTriangles[facet];
    m_draft.facetInputs[part] = inputs;
    m_marked[part] = m_gone[part] = 0;
    m_draft.facets[facet][second] = point;
    m_draft.facetInputs[facet][second] = inputPoint;
    m_draft.facets[part][first] = point;
    m_draft.facetInputs[part][first] = inputPoint;
    for (const Index f : { facet, part })
    {
      const auto& [a, b, c] = m_draft.facets[f];
      const bool waits = f == facet && m_marked[f];
      m_marked[f] = !hasArea(m_draft.points[a], m_draft.points[b], m_draft.points[c]);
      if (this->enter(f) && m_marked[f] && !waits)
      {
        caps.push_back(f);
      }
    }
  }

  /** That of the cap that goes, for the first part: so many splits take no memory. */
  Index placeForFacet()
  {
    if (m_free != noIndex)
    {
      return std::exchange(m_free, noIndex);
    }
    const std::size_t count = m_draft.facets.size();
    m_draft.facets.resize(count + 1);
    m_draft.facetTriangles.resize(count + 1);
    m_draft.facetInputs.resize(count + 1);
    m_marked.resize(count + 1);
    m_gone.resize(count + 1);
    return static_cast<Index>(count);
  }

  const TriangleSoup& m_soup;
  std::vector<unsigned char>& m_marked;
  Draft& m_draft;
  Index m_free = noIndex;                                         ///< a place in the draft
  std::vector<char> m_gone;                                       ///< F
  std::unordered_map<std::uint64_t, std::vector<Index>> m_around; ///< the facets of a side
};
}

void splitAtCaps(const TriangleSoup& soup, const RunControl& control,
  std::vector<unsigned char>& marked, Draft& draft)
{
  CapSplit(soup, marked, draft).run(control);
}
}
