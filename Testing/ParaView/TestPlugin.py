"""TestPlugin.py PLUGIN OUTPUT_FOLDER (pvbatch): the three filters through the plugin.

The XML agrees with the C++ classes (defaults, nothing left out), the five outputs have
their names and arrays, and array selection, features, placement, the second input and rendering
work.
"""
import math
import os
import sys

from paraview import servermanager
from paraview.simple import *

PLUGIN, OUTPUT_FOLDER = sys.argv[1:3]
LoadPlugin(PLUGIN, remote=False, ns=globals())

PORTS = ["Surface", "VoronoiCells", "Sites", "Convergence", "Edges"]
SITE_ARRAYS = {"SiteId", "MergedSiteId", "PatchId", "Weight", "Embedding", "CellArea", "CellMass",
               "CellEnergy", "Centroid", "NumberOfNeighbors"}
CELL_ARRAYS = {"SiteId", "MergedSiteId", "ComponentId", "PatchId", "InputCellId", "CellArea",
               "CellMass", "CellEnergy"}
SURFACE_ARRAYS = {"SiteId", "ComponentId", "CellArea", "CellMass", "CellEnergy", "Embedding",
                  "Normals"}
COLUMNS = {"Iteration", "Energy", "GradientNorm", "StepLength", "Seconds"}


def fetch(source, port=0):
    return servermanager.Fetch(source, idx=port)


def names(attributes):
    return {attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays())}


def check_against_class(source, name):
    """Defaults of the properties are the class's; no Set method lacks a property."""
    try:
        import anisotropic_remeshing
    except ImportError:
        print("not wrapped: the defaults are not compared")
        return
    from vtkmodules.vtkCommonExecutionModel import vtkPolyDataAlgorithm
    cls = getattr(anisotropic_remeshing, name)
    fresh = cls()
    # Those with a Get method: connections and the embedding array have none.
    parameters = {m[3:] for m in set(dir(cls)) - set(dir(vtkPolyDataAlgorithm))
                  if m.startswith("Set") and hasattr(cls, "Get" + m[3:])}
    assert "NumberOfThreads" in parameters
    for parameter in sorted(parameters):
        prop = source.SMProxy.GetProperty(parameter)
        assert prop, f"{name}: no property for Set{parameter}"
        expected = getattr(fresh, "Get" + parameter)()
        assert prop.GetElement(0) == ("None" if expected is None else expected), \
            f"{name}.{parameter}: {prop.GetElement(0)} in XML, {expected} in C++"


def check_diagram(source, sites):
    """Counts and identities that hold for a closed surface of genus 0 with `sites` sites."""
    got = [source.SMProxy.GetOutputPortName(i) for i in range(source.SMProxy.GetNumberOfOutputPorts())]
    assert got == PORTS, got
    surface, cells, points, table, edges = (fetch(source, i) for i in range(5))
    assert surface.GetNumberOfPoints() == sites, surface.GetNumberOfPoints()
    assert surface.GetNumberOfCells() == 2 * sites - 4, surface.GetNumberOfCells()
    assert points.GetNumberOfPoints() == points.GetNumberOfCells() == sites
    assert cells.GetNumberOfCells() >= sites and edges.GetNumberOfCells() > 0
    assert SURFACE_ARRAYS <= names(surface.GetPointData()), names(surface.GetPointData())
    assert CELL_ARRAYS <= names(cells.GetCellData()), names(cells.GetCellData())
    assert SITE_ARRAYS <= names(points.GetPointData()), names(points.GetPointData())
    assert {"EdgeType", "SiteId"} <= names(edges.GetCellData()), names(edges.GetCellData())
    assert COLUMNS <= names(table.GetRowData()), names(table.GetRowData())
    return surface, points, table


def total(array):
    return sum(array.GetTuple1(i) for i in range(array.GetNumberOfTuples()))


def number_of_creases(source):
    """Lines of port 4 along creases and borders of labels that are kept."""
    types = fetch(source, 4).GetCellData().GetArray("EdgeType")
    return sum(types.GetTuple1(i) == 1 for i in range(types.GetNumberOfTuples()))


def mean_radius(points):
    count = points.GetNumberOfPoints()
    return sum(math.hypot(*points.GetPoint(i)) for i in range(count)) / count


sphere = Sphere(ThetaResolution=40, PhiResolution=40)

# --- The remesher --------------------------------------------------------------------------------
remesher = AnisotropicRemesher(Input=sphere)
check_against_class(remesher, "vtkAnisotropicRemesher")
remesher.NumberOfPoints = 300
remesher.LloydIterations = 10
remesher.NewtonIterations = 5
surface, points, table = check_diagram(remesher, 300)
assert table.GetNumberOfRows() == 16
assert points.GetPointData().GetArray("Embedding").GetNumberOfComponents() == 6
areas = [total(d.GetPointData().GetArray("CellArea")) for d in (surface, points)]
assert abs(areas[0] - areas[1]) < 1e-10 * areas[0], areas
assert list(remesher.Normals) == ["POINTS", "Automatic"], list(remesher.Normals)
assert remesher.EmbeddingArray == "None", remesher.EmbeddingArray

# No normals, other parameters; the same again is the same.
remesher.Normals = ["POINTS", "None"]
remesher.SamplingMethod = "Random"
remesher.Seed = 7
remesher.SMPBackend = "Sequential"
other = fetch(remesher, 2).GetPoint(0)
assert other != points.GetPoint(0)
remesher.SMPBackend = "STDThread"
remesher.NumberOfThreads = 2
assert fetch(remesher, 2).GetPoint(0) == other

# Outputs switched off stay, but empty.
remesher.GenerateVoronoiCells = 0
remesher.GenerateEdges = 0
assert fetch(remesher, 1).GetNumberOfCells() == fetch(remesher, 4).GetNumberOfCells() == 0

# Coordinate arrays are appended; isotropic: position alone. Active scalars are not an embedding.
elevation = Elevation(Input=sphere)
elevation.UpdatePipeline()
appended = AnisotropicRemesher(Input=elevation, NumberOfPoints=100, LloydIterations=2,
                               CoordinateArrays=["Elevation", "0.5"])
assert appended.EmbeddingArray == "None", appended.EmbeddingArray
_, points, _ = check_diagram(appended, 100)
assert points.GetPointData().GetArray("Embedding").GetNumberOfComponents() == 7
assert "Elevation" in names(fetch(appended).GetPointData())
appended.CoordinateArrays = []
appended.Embedding = "Position"
_, points, _ = check_diagram(appended, 100)
assert points.GetPointData().GetArray("Embedding").GetNumberOfComponents() == 3

# A distance instead of a number of points.
within = AnisotropicRemesher(Input=sphere, DistanceTolerance=5e-3)
facts = fetch(within).GetFieldData()
assert 0 < facts.GetArray("MaximumDistance").GetTuple1(0) < 5e-3 * 3 ** 0.5
assert facts.GetArray("RMSDistance").GetTuple1(0) > 0

# A density: all arrays of one component are offered.
assert appended.Density == "None", appended.Density
weights = Calculator(Input=elevation, ResultArrayName="Weight", Function="1 + 15 * Elevation")
dense = AnisotropicRemesher(Input=weights, NumberOfPoints=100, Density="Weight")
surface, _, _ = check_diagram(dense, 100)
assert "CellWeightedMass" in names(surface.GetPointData()), names(surface.GetPointData())

# Features: the sides of a box, which are bent by 90 degrees, and the line between two labels.
quick = {"NumberOfPoints": 100, "NewtonIterations": 3, "MeasureDistance": 0}
box = AnisotropicRemesher(Input=Box(), **quick)
for box.FeatureAngle, box.PreserveFeatures, kept in ((89, 1, True), (91, 1, False), (89, 0, False)):
    assert (number_of_creases(box) > 0) == kept, (box.FeatureAngle, box.PreserveFeatures)
number = globals().get("PointAndCellIds") or GenerateIds  # its name since ParaView 6
halves = number(Input=Plane(XResolution=2), CellIdsArrayName="Half")
labelled = AnisotropicRemesher(Input=halves, **quick)
assert labelled.FeatureLabelArray == "None", labelled.FeatureLabelArray
for labelled.FeatureLabelArray, kept in (("Half", True), ("None", False)):
    assert (number_of_creases(labelled) > 0) == kept, labelled.FeatureLabelArray

# Points that the topology needs: four are no torus, nor are five.
torus = Superquadric(Toroidal=1)
ring = AnisotropicRemesher(Input=torus, NumberOfPoints=4, MergeTolerance=1e-6, MeasureDistance=0)
for ring.MaximumExtraPoints, enough in ((200, True), (1, False)):
    facts = fetch(ring).GetFieldData()
    extra = facts.GetArray("NumberOfExtraPoints").GetTuple1(0)
    assert (extra > 1) == enough, (ring.MaximumExtraPoints, extra)
    assert facts.GetArray("TopologyPreserved").GetTuple1(0) == enough

# Placement: on a sphere, the mean radius tells all four apart.
ball = AnisotropicRemesher(Input=sphere, **quick)
radii = []
for ball.VertexPlacement in ("Centroid", "Surface Point", "Quadric", "Fit"):
    radii.append(mean_radius(fetch(ball)))
assert radii[0] < radii[1] < min(radii[2:]) and radii[2] != radii[3], radii

# Vectors that are no normals are not taken for them.
bare = Calculator(Input=ExtractSurface(Input=Wavelet()), ResultArrayName="Displacement",
                  Function="coords")
bare.UpdatePipeline()
without = AnisotropicRemesher(Input=bare)
assert list(without.Normals) == ["POINTS", "Automatic"], list(without.Normals)
assert without.EmbeddingArray == "None", without.EmbeddingArray

# --- The embedding, used again by the remesher and as sites of the diagram -----------------------
embedding = GaussMapEmbedding(Input=sphere, Anisotropy=0.1)
check_against_class(GaussMapEmbedding(Input=sphere), "vtkGaussMapEmbedding")
assert fetch(embedding).GetPointData().GetArray("Embedding").GetNumberOfComponents() == 6
again = AnisotropicRemesher(Input=embedding, NumberOfPoints=150, LloydIterations=5,
                            EmbeddingArray="Embedding")
check_diagram(again, 150)

# --- The metric of a solution, used by the remesher ----------------------------------------------
check_against_class(SolutionMetric(Input=sphere), "vtkSolutionMetric")
bend = Calculator(Input=sphere, ResultArrayName="Bend", Function="tanh(20*coordsX)")
metric = SolutionMetric(Input=bend, NumberOfPoints=150)
assert list(metric.SolutionArrays) == [], list(metric.SolutionArrays)
metric.SolutionArrays = ["Bend"]
assert fetch(metric).GetPointData().GetArray("Metric").GetNumberOfComponents() == 6
wanted = fetch(metric).GetFieldData().GetArray("MetricPoints").GetTuple1(0)
assert abs(wanted - 150) < 0.1, wanted
across = AnisotropicRemesher(Input=metric, NumberOfPoints=150, LloydIterations=5,
                             MetricArray="Metric")
check_diagram(across, 150)

# --- A metric's embedding, used by the remesher ---------------------------------------------------
check_against_class(MetricEmbedding(Input=metric), "vtkMetricEmbedding")
lengths = MetricEmbedding(Input=metric, NumberOfPoints=150)
lengths.MetricArray = "Metric"
assert fetch(lengths).GetPointData().GetArray("Embedding").GetNumberOfComponents() == 6
assert fetch(lengths).GetCellData().GetArray("LargestStretch").GetRange()[1] > 0.9
check_diagram(AnisotropicRemesher(Input=lengths, NumberOfPoints=150, LloydIterations=5,
                                  EmbeddingArray="Embedding"), 150)

# --- Eigenfunctions as an embedding ---------------------------------------------------------------
check_against_class(SpectralEmbedding(Input=sphere), "vtkSpectralEmbedding")
functions = SpectralEmbedding(Input=sphere, Dimension=3, Scaling="None")
values = fetch(functions).GetFieldData().GetArray("Eigenvalues")
radius = mean_radius(fetch(sphere))
assert all(abs(values.GetTuple1(k) * radius ** 2 - 2.0) < 0.1 for k in range(3))
check_diagram(AnisotropicRemesher(Input=functions, NumberOfPoints=150, LloydIterations=5,
                                  EmbeddingArray="Embedding"), 150)

diagram = RestrictedVoronoiDiagram(Input=sphere, Sites=OutputPort(remesher, 2))
check_against_class(diagram, "vtkRestrictedVoronoiDiagram")
_, _, table = check_diagram(diagram, 300)
assert table.GetNumberOfRows() == 1

# --- Initial sites: taken, and given back ---------------------------------------------------------
resumed = AnisotropicRemesher(Input=sphere, NumberOfPoints=200, LloydIterations=1,
                              InitialSites=OutputPort(remesher, 2))
check_diagram(resumed, 300)
resumed.InitialSites = None
check_diagram(resumed, 200)

# --- A picture ------------------------------------------------------------------------------------
if os.environ.get("DISPLAY"):
    view = CreateRenderView(ViewSize=[400, 400])
    Show(remesher, view).SetRepresentationType("Surface With Edges")
    Show(OutputPort(diagram, 4), view)
    ResetCamera(view)
    picture = os.path.join(OUTPUT_FOLDER, "TestPlugin.png")
    SaveScreenshot(picture, view)
    image = servermanager.Fetch(PNGSeriesReader(FileNames=[picture]))
    low, high = image.GetPointData().GetScalars().GetRange()
    assert high - low > 50, "an empty picture"
else:
    print("no DISPLAY: the screenshot is skipped")
print("passed")
