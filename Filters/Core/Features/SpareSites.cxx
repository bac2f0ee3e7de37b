#include "Features/SpareSites.h"

#include <set>

namespace remesh
{
SpareSites::SpareSites(const EmbeddedSurface& surface, const Sites& sites)
  : m_patches(surface.patches)
{
  std::set<Index> bordered;
  for (Index i = 0; i < sites.fixed; ++i)
  {
    bordered.insert(m_patches.patchOf(sites.site(i)));
  }
  for (Index i = sites.fixed; i < sites.count(); ++i)
  {
    const Index patch = m_patches.patchOf(sites.site(i));
    if (bordered.count(patch) == 0)
    {
      ++m_spare.try_emplace(patch, -minOfClosed).first->second;
    }
  }
}

bool SpareSites::has(const double* site) const
{
  const auto found = m_spare.find(m_patches.patchOf(site));
  return found == m_spare.end() || found->second > 0;
}

bool SpareSites::take(const double* site)
{
  const auto found = m_spare.find(m_patches.patchOf(site));
  if (found == m_spare.end())
  {
    return true;
  }
  const bool goes = found->second > 0;
  found->second -= goes ? 1 : 0;
  return goes;
}
}
