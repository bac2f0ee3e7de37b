"""TestPluginPanel.py PLUGIN OUTPUT_FOLDER (pvbatch): what a person meets in the window.

Each property has a widget, a short tooltip and the name that scripts know; defaults come from the
input when the filter runs, not from whatever is active; after Apply one port is shown, and each of
the others, when asked for, as it is meant.
"""
import os
import re
import sys

from paraview import servermanager
from paraview.simple import *

PLUGIN, OUTPUT_FOLDER = sys.argv[1:3]
LoadPlugin(PLUGIN, remote=False, ns=globals())

EMBEDDED = {"Anisotropy", "CoordinateArrays", "Embedding", "EmbeddingArray", "EstimateNormals",
            "Input", "MergeTolerance", "NormalSmoothingPasses", "NormalSmoothingRadius", "Normals",
            "NumberOfThreads", "SMPBackend"}
DIAGRAM = EMBEDDED | {"Density", "GenerateEdges", "GenerateVoronoiCells",
                      "MaximumCellEmbeddingDimension", "MeasureDistance", "VertexPlacement"}
NAMES = {
    "AnisotropicRemesher": DIAGRAM | {
        "CoarseStart", "DistanceTolerance", "DistanceToleranceIsAbsolute", "EnergyTolerance",
        "FeatureAngle", "FeatureLabelArray", "GradientTolerance", "HistoryLength", "InitialSites",
        "LloydIterations", "MaximumExtraPoints", "MaximumNumberOfPoints", "NewtonIterations",
        "NumberOfPoints", "PreserveFeatures", "SamplingMethod", "Seed"},
    "RestrictedVoronoiDiagram": DIAGRAM | {"Sites"},
    "GaussMapEmbedding": EMBEDDED | {"NumberOfPoints"},
    "MetricEmbedding": {
        "Dimension", "EnergyTolerance", "Input", "LimitMetric", "MetricArray", "MetricComplexity",
        "MetricGrowth", "MetricOrder", "NumberOfIterations", "NumberOfPoints", "NumberOfThreads",
        "Refine", "SMPBackend", "UnitEdges"},
    "SolutionMetric": {
        "ChordTolerance", "DistanceArray", "DistanceGrowth", "DistanceSize", "ErrorNorm",
        "HessianArrays", "Input", "MaximumRatio", "MaximumSize", "MetricArrays", "MetricOrder",
        "MinimumSize", "NumberOfPoints", "NumberOfThreads", "SMPBackend", "SolutionArrays"},
    "SpectralEmbedding": {
        "BorderCondition", "DiffusionTime", "Dimension", "Input", "MassMatrix", "NumberOfThreads",
        "SMPBackend", "Scaling"},
    "SurfaceMeshComparison": {"BoundMaximumDistance", "Input", "NumberOfBins", "NumberOfSamples",
                              "NumberOfThreads", "Reference", "SMPBackend"}}
SLIDERS = {"Anisotropy": (0.0, 0.2), "FeatureAngle": (0.0, 180.0)}
QUICK = {"NumberOfPoints": 100, "NewtonIterations": 3, "MeasureDistance": 0}
KINDS = ["vtkPolyData", "vtkUnstructuredGrid", "vtkMultiBlockDataSet", "vtkPartitionedDataSet",
         "vtkPartitionedDataSetCollection"]


def definition(name):
    """The XML of a filter, as ParaView has it."""
    definitions = servermanager.ProxyManager().SMProxyManager.GetProxyDefinitionManager()
    return definitions.GetCollapsedProxyDefinition("filters", name, None, True)


def children(element, tag=""):
    nested = (element.GetNestedElement(i) for i in range(element.GetNumberOfNestedElements()))
    return [child for child in nested if child.GetName().endswith(tag)]


def check_properties(name):
    """Ranks, widgets and tooltips."""
    proxy = servermanager.ProxyManager().SMProxyManager.GetPrototypeProxy("filters", name)
    assert proxy.GetProcessSupport() == proxy.BOTH, f"{name}: not on any number of ranks"
    for element in children(definition(name), "Property"):
        key = element.GetAttribute("name")
        assert element.GetName() != "IdTypeVectorProperty", f"{name}.{key}: no widget for IdType"
        text = " ".join((proxy.GetProperty(key).GetDocumentation().GetDescription() or "").split())
        sentences = len(re.findall(r"[.!?](?= [A-Z]|$)", text))
        assert 1 <= sentences <= 2, f"{name}.{key}: {sentences} sentences: {text}"
        for domain in children(element, "RangeDomain"):
            low, high = domain.GetAttribute("min"), domain.GetAttribute("max")
            if low is not None and high is not None:  # ParaView makes a slider of it
                assert (float(low), float(high)) == SLIDERS.get(key), f"{name}.{key}: a slider"


def check_names(name):
    """Scripts find the names that they know."""
    inputs = {"Sites": Sphere()} if name == "RestrictedVoronoiDiagram" else {}
    source = globals()[name](Input=Sphere(), **inputs)
    missing = NAMES[name] - set(source.ListProperties())
    assert not missing, f"{name}: {missing}"
    Delete(source)


def check_inputs(name, key):
    """What the menu is enabled for."""
    found = [e for e in children(definition(name), "Property") if e.GetAttribute("name") == key][0]
    domain = children(found, "DataTypeDomain")[0]
    assert [d.GetAttribute("value") for d in children(domain)] == KINDS, (name, key)


for each in NAMES:
    check_properties(each)
    check_names(each)
    check_inputs(each, "Input")
check_inputs("SurfaceMeshComparison", "Reference")


def mesh(source):
    """Points and triangles of a remeshed surface as bytes."""
    data = servermanager.Fetch(source)
    assert data.GetNumberOfPoints() > 0
    return bytes(memoryview(data.GetPoints().GetData())) + \
        bytes(memoryview(data.GetPolys().GetConnectivityArray()))


# --- Normals: decided from the input when the filter runs -----------------------------------------
# An ellipsoid with the normals of a sphere: given and estimated ones give other meshes.
sphere = Sphere(ThetaResolution=20, PhiResolution=20)
given = Calculator(registrationName="given", Input=sphere, CoordinateResults=1,
                   Function="iHat*coordsX+jHat*coordsY+0.3*kHat*coordsZ")
remesher = AnisotropicRemesher(Input=given, **QUICK)
assert list(remesher.Normals) == ["POINTS", "Automatic"], list(remesher.Normals)
with_normals = mesh(remesher)
remesher.EstimateNormals = 1
without_normals = mesh(remesher)
assert with_normals != without_normals
remesher.EstimateNormals = 0
for spelling, expected in (("Normals", with_normals), ("None", without_normals),
                           ("Automatic", with_normals)):
    remesher.Normals = ["POINTS", spelling]
    assert mesh(remesher) == expected, spelling

# Another source is active when the script makes the filter.
other = Cone()
SetActiveSource(other)
assert mesh(AnisotropicRemesher(Input=given, **QUICK)) == with_normals
other = Calculator(Input=Wavelet(), ResultArrayName="Displacement", Function="coords")
other.UpdatePipeline()
SetActiveSource(other)
from_wavelet = AnisotropicRemesher(Input=given, **QUICK)
assert mesh(from_wavelet) == with_normals
for choice in ("EmbeddingArray", "FeatureLabelArray", "Density"):
    assert from_wavelet.GetPropertyValue(choice) == "None", choice

# A reader that was not updated yet.
path = os.path.join(OUTPUT_FOLDER, "TestPluginPanel.vtp")
SaveData(path, given)
reader = XMLPolyDataReader(FileName=[path])
late = AnisotropicRemesher(Input=reader, **QUICK)
assert list(late.Normals) == ["POINTS", "Automatic"], list(late.Normals)
updated = XMLPolyDataReader(FileName=[path])
updated.UpdatePipeline()
read = AnisotropicRemesher(Input=updated, **QUICK)
assert mesh(late) == mesh(read)
read.EstimateNormals = 1
assert mesh(late) != mesh(read)

# The number of points is animated.
track = GetAnimationTrack("NumberOfPoints", proxy=remesher)
track.KeyFrames = [CompositeKeyFrame(KeyTime=0, KeyValues=[80]),
                   CompositeKeyFrame(KeyTime=1, KeyValues=[120])]
for go, count in ((GetAnimationScene().GoToLast, 120), (GetAnimationScene().GoToFirst, 80)):
    go()
    assert remesher.NumberOfPoints == count, remesher.NumberOfPoints
    assert servermanager.Fetch(remesher).GetNumberOfPoints() == count

# A loop with Show, as scripts have it: each pass makes the last one's output active.
view = CreateRenderView()
SetActiveSource(given)
meshes = []
for anisotropy in (0.0, 0.02, 0.05, 0.1, 0.5):
    step = AnisotropicRemesher(Input=given, Anisotropy=anisotropy, **QUICK)
    Show(step, view)
    assert list(step.Normals) == ["POINTS", "Automatic"], list(step.Normals)
    meshes.append(mesh(step))
assert len(set(meshes)) == 5, "values beyond the slider do not reach the filter"


# --- What is shown, and how -----------------------------------------------------------------------
def visible_ports(source, view):
    """The ports that are visible after Apply, which does this for each."""
    controller = servermanager.ParaViewPipelineController()
    for port in range(source.SMProxy.GetNumberOfOutputPorts()):
        controller.ShowInPreferredView(source.SMProxy, port, view.SMProxy)
    return [port for port in range(source.SMProxy.GetNumberOfOutputPorts())
            if controller.GetVisibility(source.SMProxy, port, view.SMProxy)]


views = len(GetViews())
picture = AnisotropicRemesher(Input=Box(), **QUICK)
compared = SurfaceMeshComparison(Input=picture, Reference=Box())
diagram = RestrictedVoronoiDiagram(Input=Box(), Sites=OutputPort(picture, 2))
for source in (picture, compared, diagram):
    assert visible_ports(source, view) == [0], source
    display = GetDisplayProperties(source, view)
    assert display.Representation == "Surface With Edges", display.Representation
    assert display.Interpolation == "Flat", display.Interpolation
assert len(GetViews()) == views, "a table has opened a view"

cells, sites, edges = (Show(OutputPort(picture, port), view) for port in (1, 2, 4))
assert list(cells.ColorArrayName) == ["CELLS", "CellColor"], list(cells.ColorArrayName)
assert cells.Representation == "Surface", cells.Representation
assert sites.Representation == "Point Gaussian", sites.Representation
assert list(edges.ColorArrayName) == ["CELLS", "EdgeType"], list(edges.ColorArrayName)
assert edges.LineWidth == 2.0, edges.LineWidth
for name in ("CellColor", "EdgeType"):
    colors = GetColorTransferFunction(name)
    assert colors.InterpretValuesAsCategories == 1, name
    assert len(colors.IndexedColors) * 2 == len(colors.Annotations) * 3, name
    assert colors.AutomaticRescaleRangeMode == "Never", name

chart = Show(OutputPort(picture, 3), CreateView("XYChartView"))
assert (chart.UseIndexForXAxis, chart.XArrayName) == (0, "Iteration"), chart.XArrayName
assert list(chart.SeriesVisibility) == ["Energy"], list(chart.SeriesVisibility)
bars = Show(OutputPort(compared, 3), CreateView("XYBarChartView"))
assert (bars.UseIndexForXAxis, bars.XArrayName) == (0, "Quality"), bars.XArrayName
assert list(bars.SeriesVisibility) == ["QualityTriangles"], list(bars.SeriesVisibility)
print("passed")
