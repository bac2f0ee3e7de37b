#include "Optimization/SiteOrder.h"

#include "Embedding/Distance.h"
#include "Mesh/SpatialOrder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace remesh
{
namespace
{
constexpr double farApart = 0.1; // of the diagonal
}

bool areScattered(const Sites& sites)
{
  const auto d = static_cast<std::size_t>(sites.dimension);
  std::vector<double> least(d, std::numeric_limits<double>::infinity());
  std::vector<double> most(d, -std::numeric_limits<double>::infinity());
  double steps = 0.0;
  for (Index i = 0; i < sites.count(); ++i)
  {
    const double* x = sites.site(i);
    for (std::size_t k = 0; k < d; ++k)
    {
      least[k] = std::min(least[k], x[k]);
      most[k] = std::max(most[k], x[k]);
    }
    if (i > 0)
    {
      steps += std::sqrt(squaredDistance<Eigen::Dynamic>(x, sites.site(i - 1), sites.dimension));
    }
  }
  const double diagonal =
    std::sqrt(squaredDistance<Eigen::Dynamic>(most.data(), least.data(), sites.dimension));
  return steps > farApart * diagonal * std::max(0, sites.count() - 1);
}

std::vector<Index> orderInSpace(const Sites& sites, const RunControl& control)
{
  std::vector<Point3> points(static_cast<std::size_t>(sites.count()), Point3::Zero());
  for (Index i = 0; i < sites.count(); ++i)
  {
    std::copy_n(sites.site(i), std::min(sites.dimension, 3), points[i].data());
  }
  return orderAlongHilbertCurve(points, control);
}

Sites inOrder(const Sites& sites, const std::vector<Index>& order)
{
  Sites ordered;
  ordered.dimension = sites.dimension;
  ordered.coordinates.resize(order.size() * static_cast<std::size_t>(sites.dimension));
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    std::copy_n(sites.site(order[k]), sites.dimension, ordered.site(static_cast<Index>(k)));
  }
  return ordered;
}

Sites inFormerOrder(const Sites& ordered, const std::vector<Index>& order)
{
  Sites sites = ordered;
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    std::copy_n(ordered.site(static_cast<Index>(k)), sites.dimension, sites.site(order[k]));
  }
  return sites;
}
}
