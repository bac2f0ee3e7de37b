#include "Delaunay/Collar.h"

#include "Voronoi/VertexPlaces.h"

#include <algorithm>
#include <tuple>

namespace remesh
{
namespace
{
/** A stretch of a facet's edge that lies in one cell. */
struct Stretch
{
  Offset piece;
  double end; ///< in [0, 1] along the facet's sense of rotation
};

/** Where the side of a piece on edge k of its facet starts, or -1. */
Offset sideOn(const Diagram& diagram, Offset piece, int k)
{
  for (Offset v = diagram.vertexBegin[piece]; v < diagram.vertexBegin[piece + 1]; ++v)
  {
    if (diagram.across[v] == -1 - k)
    {
      return v;
    }
  }
  return -1;
}

/** The first piece with a side on edge k of a facet that starts at its corner k, or -1. */
Offset pieceAtCorner(const Diagram& diagram, Index facet, int k)
{
  for (Offset piece = diagram.facetBegin[facet]; piece < diagram.facetBegin[facet + 1]; ++piece)
  {
    const Offset v = sideOn(diagram, piece, k);
    if (v >= 0 && diagram.acrossIncoming(piece, v) == -1 - (k + 2) % 3)
    {
      return piece;
    }
  }
  return -1;
}

/**
 * The pieces along edge k of a facet, in the facet's sense of rotation; false if they do not reach
 * from one end to the other.
 */
bool listStretches(const VertexPlaces& places, Index facet, int k, std::vector<Stretch>& stretches)
{
  const Diagram& diagram = places.diagram;
  stretches.clear();
  const auto pieces =
    static_cast<std::size_t>(diagram.facetBegin[facet + 1] - diagram.facetBegin[facet]);
  for (Offset at = pieceAtCorner(diagram, facet, k); at >= 0;)
  {
    const Offset begin = sideOn(diagram, at, k);
    if (begin < 0 || stretches.size() == pieces)
    {
      break;
    }
    const Offset first = diagram.vertexBegin[at];
    const Offset end = begin + 1 == diagram.vertexBegin[at + 1] ? first : begin + 1;
    stretches.push_back({ at, places.at(at, end)[(k + 1) % 3] });
    const Index next = diagram.across[end];
    if (next < 0)
    {
      return true;
    }
    at = diagram.pieceOf(facet, next);
  }
  return false;
}

/** Walks along one side of one feature edge, and joins what meets there. */
class SeamBuilder
{
public:
  SeamBuilder(const VertexPlaces& places, const Components& components,
    const FeaturedSurface& featured, const FeatureSites& featureSites, Seams& seams)
    : m_places(places)
    , m_diagram(places.diagram)
    , m_components(components)
    , m_mesh(featured.mesh)
    , m_features(featured.features)
    , m_sites(featureSites)
    , m_seams(seams)
  {
  }

  void sew(const CollarEdge& collar, Index facet)
  {
    m_facet = facet;
    m_edge = m_features.edges.sideOf(facet, collar.edge);
    m_seams.isComplete &= listStretches(m_places, facet, m_edge, m_stretches);
    m_forward = m_mesh.facetPoints[facet][m_edge] == collar.start;
    m_sewing = m_features.cuts[collar.edge] != 0;
    this->layCollar(collar);
    std::size_t inner = 0;
    std::size_t outer = 0;
    bool innerEnd = true; // of the edge: the cells go on around it
    while (inner < m_stretches.size())
    {
      const Index x = m_components.ofPiece[m_stretches[inner].piece];
      const Index c = m_seams.components[m_cells[outer].point];
      if (x != c)
      {
        this->noteIntrusion(collar, inner, outer);
      }
      const Contact contact{ static_cast<Index>(m_stretches[inner].piece), innerEnd ? 1 : 0 };
      const bool lastInner = inner + 1 == m_stretches.size();
      const bool lastOuter = outer + 1 == m_cells.size();
      if (lastInner && lastOuter)
      {
        this->touch(contact, x, c, true);
        break;
      }
      if (lastOuter || (!lastInner && m_stretches[inner].end <= m_cells[outer].end))
      {
        const Index next = m_components.ofPiece[m_stretches[++inner].piece];
        this->join(next, x, c);
        innerEnd = x == c && next == c;
      }
      else
      {
        this->join(x, c, m_seams.components[m_cells[++outer].point]);
        innerEnd = false;
      }
      this->touch(contact, x, c, innerEnd);
    }
  }

private:
  struct Cell
  {
    Index point; ///< feature point
    double end;  ///< as of a stretch
  };

  /** The curve's cells in the facet's sense of rotation. */
  void layCollar(const CollarEdge& collar)
  {
    m_cells.clear();
    Index owner = collar.first;
    for (const CollarEdge::Change& change : collar.changes)
    {
      m_cells.push_back({ owner, change.t });
      owner = change.to;
    }
    m_cells.push_back({ owner, 1.0 });
    if (!m_forward)
    {
      std::reverse(m_cells.begin(), m_cells.end());
      for (std::size_t c = 0; c < m_cells.size(); ++c)
      {
        m_cells[c].end = c + 1 < m_cells.size() ? 1.0 - m_cells[c + 1].end : 1.0;
      }
    }
  }

  /** A triangle of three different cells. */
  void join(Index a, Index b, Index c)
  {
    if (m_sewing && a != b && b != c && c != a && a != noIndex && b != noIndex && c != noIndex)
    {
      m_seams.triangles.push_back({ a, b, c });
    }
  }

  /** Notes a contact of piece and collar if both are of the same component. */
  void touch(Contact contact, Index x, Index c, bool innerEnd)
  {
    if (m_sewing && x == c)
    {
      contact.innerEnds += innerEnd ? 1 : 0;
      m_seams.contacts.push_back(contact);
    }
  }

  /** A piece on the curve that is not the curve's own there. */
  void noteIntrusion(const CollarEdge& collar, std::size_t inner, std::size_t outer)
  {
    const Offset piece = m_stretches[inner].piece;
    const Index site = m_diagram.sites[piece];
    const double begin = std::max(
      inner > 0 ? m_stretches[inner - 1].end : 0.0, outer > 0 ? m_cells[outer - 1].end : 0.0);
    const double end = std::min(m_stretches[inner].end, m_cells[outer].end);
    Intrusion intrusion{ collar.curve, 0, site, m_components.ofPiece[piece], {}, 0.0 };
    const double foot = this->footOf(site, begin, end, intrusion.squared);
    intrusion.foot = { collar.segment, m_forward ? foot : 1.0 - foot };
    const std::vector<Index>& segments = m_features.curves[collar.curve].edges;
    if (intrusion.foot.t >= 1.0 && collar.segment + 1 < static_cast<Index>(segments.size()))
    {
      intrusion.foot = { collar.segment + 1, 0.0 };
    }
    const std::vector<Station>& stations = m_sites.stations[collar.curve];
    const auto after = std::upper_bound(stations.begin(), stations.end(), intrusion.foot);
    intrusion.section = std::clamp(static_cast<Index>(after - stations.begin()) - 1, Index(0),
      static_cast<Index>(stations.size()) - 2);
    if (site >= m_sites.sites.count())
    {
      m_seams.intrusions.push_back(intrusion);
    }
    else if (!this->endsSection(intrusion))
    {
      m_seams.encroachments.push_back(intrusion);
    }
  }

  /** Whether the cell is of one of the two sites that the section is between. */
  bool endsSection(const Intrusion& intrusion) const
  {
    const std::vector<Index>& points = m_sites.curvePoints[intrusion.curve];
    return intrusion.component == m_seams.components[points[intrusion.section]] ||
      intrusion.component == m_seams.components[points[intrusion.section + 1]];
  }

  /** The place on the edge nearest to a site, between two others. */
  double footOf(Index site, double begin, double end, double& squared) const
  {
    const EmbeddedSurface& surface = m_places.surface;
    const int d = surface.dimension;
    const double* p = surface.corner(m_mesh.facetCorners[m_facet][m_edge]);
    const double* q = surface.corner(m_mesh.facetCorners[m_facet][(m_edge + 1) % 3]);
    const double* x = m_places.sites.site(site);
    double along = 0.0, length2 = 0.0;
    for (int c = 0; c < d; ++c)
    {
      along += (x[c] - p[c]) * (q[c] - p[c]);
      length2 += (q[c] - p[c]) * (q[c] - p[c]);
    }
    // Ends that are rounded each on their own can lie the wrong way round.
    const double t = std::min(std::max(length2 > 0.0 ? along / length2 : 0.5, begin), end);
    squared = 0.0;
    for (int c = 0; c < d; ++c)
    {
      const double difference = x[c] - ((1.0 - t) * p[c] + t * q[c]);
      squared += difference * difference;
    }
    return t;
  }

  const VertexPlaces& m_places;
  const Diagram& m_diagram;
  const Components& m_components;
  const SurfaceMesh& m_mesh;
  const Features& m_features;
  const FeatureSites& m_sites;
  Seams& m_seams;
  Index m_facet = 0;
  int m_edge = 0;        ///< of the facet
  bool m_sewing = true;  ///< false where the surface is not cut
  bool m_forward = true; ///< whether the facet runs along the edge as its curve does
  std::vector<Stretch> m_stretches;
  std::vector<Cell> m_cells;
};

/** The component that holds each feature point. */
std::vector<Index> componentsOfPoints(
  const Diagram& diagram, const Components& components, const FeatureSites& sites)
{
  std::vector<Index> result(sites.points.size(), noIndex);
  for (std::size_t p = 0; p < sites.points.size(); ++p)
  {
    for (Offset s = sites.seatBegin[p]; s < sites.seatBegin[p + 1] && result[p] == noIndex; ++s)
    {
      const Offset piece = diagram.pieceOf(sites.seats[s].facet, sites.seats[s].site);
      result[p] = piece >= 0 ? components.ofPiece[piece] : noIndex;
    }
  }
  return result;
}

/** The collars along the cut edges, and where the border of the surface passes from one to another.
 */
void shapeCollars(const Features& features, const FeatureSites& sites, Seams& seams)
{
  seams.collars.assign(sites.points.size(), CollarShape::None);
  for (const CollarEdge& collar : sites.collar)
  {
    if (!features.cuts[collar.edge])
    {
      continue;
    }
    Index owner = collar.first;
    const auto meet = [&](CollarShape shape)
    { seams.collars[owner] = std::max(seams.collars[owner], shape); };
    meet(CollarShape::Disk);
    for (const CollarEdge::Change& change : collar.changes)
    {
      if (change.to == owner)
      {
        meet(CollarShape::Ring);
      }
      if (features.edges.valence(collar.edge) == 1)
      {
        seams.borderCrossings.emplace_back(owner, change.to);
      }
      owner = change.to;
      meet(CollarShape::Disk);
    }
  }
}

std::vector<Pinch> listPinches(const Features& features, const FeatureSites& sites)
{
  std::vector<Index> borders(features.corners.size(), 0);
  for (std::size_t c = 0; c < features.curves.size(); ++c)
  {
    const FeatureCurve& curve = features.curves[c];
    if (curve.kind == FeatureKind::Boundary && curve.hasCorners)
    {
      ++borders[sites.curvePoints[c].front()];
      ++borders[sites.curvePoints[c].back()];
    }
  }
  std::vector<Pinch> pinches;
  for (std::size_t p = 0; p < features.corners.size(); ++p) // the first feature points
  {
    if (std::binary_search(features.pinches.begin(), features.pinches.end(), features.corners[p]))
    {
      pinches.push_back({ static_cast<Index>(p), borders[p] });
    }
  }
  return pinches;
}

void addSegments(const Features& features, const FeatureSites& sites, Seams& seams)
{
  for (std::size_t c = 0; c < sites.curvePoints.size(); ++c)
  {
    const std::vector<Index>& points = sites.curvePoints[c];
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
    {
      const Index a = seams.components[points[k]];
      const Index b = seams.components[points[k + 1]];
      if (a != b && a != noIndex && b != noIndex)
      {
        seams.segments.push_back({ { a, b }, features.curves[c].kind });
      }
    }
  }
}
}

namespace
{
/** Of the stretches of one component in one section, the one nearest to its site. */
void keepNearest(std::vector<Intrusion>& intrusions)
{
  const auto key = [](const Intrusion& i)
  { return std::make_tuple(i.curve, i.section, i.component); };
  std::stable_sort(intrusions.begin(), intrusions.end(),
    [&](const Intrusion& a, const Intrusion& b)
    { return key(a) != key(b) ? key(a) < key(b) : a.squared < b.squared; });
  intrusions.erase(std::unique(intrusions.begin(), intrusions.end(),
                     [&](const Intrusion& a, const Intrusion& b) { return key(a) == key(b); }),
    intrusions.end());
}
}

Seams sewAlongFeatures(const VertexPlaces& places, const Components& components,
  const FeaturedSurface& featured, const FeatureSites& featureSites)
{
  const Features& features = featured.features;
  Seams seams;
  seams.components = componentsOfPoints(places.diagram, components, featureSites);
  seams.pinches = listPinches(features, featureSites);
  shapeCollars(features, featureSites, seams);
  addSegments(features, featureSites, seams);
  SeamBuilder builder(places, components, featured, featureSites, seams);
  for (const CollarEdge& collar : featureSites.collar)
  {
    for (Offset i = features.edges.edgeFacetsBegin[collar.edge];
         i < features.edges.edgeFacetsBegin[collar.edge + 1]; ++i)
    {
      builder.sew(collar, features.edges.edgeFacets[i]);
    }
  }
  keepNearest(seams.intrusions);
  keepNearest(seams.encroachments);
  return seams;
}

std::vector<char> verticesOnFeatures(const Seams& seams, Index numberOfVertices)
{
  std::vector<char> on(static_cast<std::size_t>(numberOfVertices), 0);
  for (const Index vertex : seams.components)
  {
    if (vertex != noIndex)
    {
      on[vertex] = 1;
    }
  }
  return on;
}
}
