/**
 * @file DiagramOutput.h
 * @brief From the core's result to the five outputs of a diagram filter.
 *
 * Array names, types and meaning: see vtkRestrictedVoronoiAlgorithm. Scaled units become the
 * caller's here and nowhere else.
 */
#ifndef remesh_DiagramOutput_h
#define remesh_DiagramOutput_h

#include "Preparation/SurfacePreparation.h"
#include "Remesh.h"
#include "Voronoi/DiagramPoints.h"

class vtkPolyData;
class vtkTable;

namespace remesh
{
/** What all output adaptors read. */
struct DiagramSource
{
  vtkPolyData* input;
  const PreparedSurface& prepared;
  const RemeshResult& result;
  /** Given sites as they stood in R^3, or none; for sites whose cell is empty. */
  const std::vector<Point3>& givenPlaces;
  int seed;
  /** Silent; when it cancels, the outputs are of no use. */
  RunControl control;
  /** Blocks of the input's cells, where it has several (BlockNames.h); else nullptr. */
  const int* cellBlocks = nullptr;

  const EmbeddedSurface& surface() const { return this->prepared.surface; }
  int dimension() const { return this->surface().dimension; }
  /** The block of a facet, 0 where there are none. */
  int blockOfFacet(Index facet) const
  {
    return this->cellBlocks ? this->cellBlocks[this->prepared.mesh.facetInputCells[facet]] : 0;
  }
  /** The patch of a facet and of a site. */
  Offset patchOfFacet(Index facet) const
  {
    return this->prepared.features ? this->prepared.features->facetPatches[facet] : 0;
  }
  Offset patchOfSite(Index site) const
  {
    return this->surface().patches.patchOf(this->result.sites.site(site));
  }
  double massUnit() const { return this->surface().unit * this->surface().unit; }
  double energyUnit() const { return this->massUnit() * this->massUnit(); }
  /** By what the sums that a density weights are multiplied in addition. */
  double densityUnit() const { return this->surface().densityUnit; }
  bool hasDensity() const { return this->surface().hasDensity(); }
  /** Of the sites, without density. */
  const std::vector<double>& siteMass() const
  {
    return this->hasDensity() ? this->result.plainSums.mass : this->result.sums.mass;
  }
  const std::vector<double>& siteEnergy() const
  {
    return this->hasDensity() ? this->result.plainSums.energy : this->result.sums.energy;
  }
  const std::vector<double>& siteMoment() const
  {
    return this->hasDensity() ? this->result.plainSums.moment : this->result.sums.moment;
  }
  /** Of the components. */
  const std::vector<double>& componentMass() const
  {
    return this->hasDensity() ? this->result.plainComponentSums.mass : this->result.components.mass;
  }
  const std::vector<double>& componentEnergy() const
  {
    return this->hasDensity() ? this->result.plainComponentSums.energy
                              : this->result.components.energy;
  }
};

/**
 * Port 0: the restricted Delaunay triangulation, with the input's arrays (CarriedArrays.h).
 * `warnings` gets a sentence for arrays that are lost.
 */
void writeSurface(
  const DiagramSource& source, vtkPolyData* output, std::vector<std::string>& warnings);

/** Port 1: the pieces of the cells. `embeddingDimension`: largest d with the array `Embedding`. */
void writeVoronoiCells(const DiagramSource& source, const DiagramPoints& points,
  int embeddingDimension, vtkPolyData* output);

/** Port 2: the sites. */
void writeSites(const DiagramSource& source, vtkPolyData* output);

/** Port 3: the history of the optimisation. */
void writeConvergence(const DiagramSource& source, vtkTable* output);

/** Port 4: borders between cells, boundary and non-manifold edges. `edges`: buildCutEdgeTable. */
void writeEdges(const DiagramSource& source, const EdgeTable& edges, const DiagramPoints& points,
  vtkPolyData* output);
}

#endif
