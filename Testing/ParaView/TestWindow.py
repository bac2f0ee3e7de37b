"""Presses the buttons of ParaView's real window, on a display of its own.

TestWindow.py <paraview> <its version> <plugin.so> <folder> <scenario>

The steps are played by ParaView's own test playback: it sends mouse and key events to widgets that
it finds by name, so that neither fonts nor sizes matter, and it waits until the window is idle. A
step whose widget is missing fails, and so does typing into a hidden one. What the window then
holds is written by WindowState.py, which the window's Python shell runs, and judged here.
"""
import json
import os
import shutil
import signal
import subprocess
import sys
import threading
from xml.sax.saxutils import quoteattr

MAIN = "pqClientMainWindow"
PROPERTIES = MAIN + "/propertiesDock/propertiesPanel"
PANEL = PROPERTIES + ("/scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents"
                      "/PropertiesFrame/ProxyPanel")
ANISOTROPY = PANEL + "/Anisotropy/DoubleRangeWidget/DoubleLineEdit"
SIZE = PANEL + "/remeshing_size"
SHELL = MAIN + "/pythonShellDock/pythonShell/consoleWidget"
BASELINES = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))),
                         "Data", "Baseline")
STATE_SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "WindowState.py")
SECONDS = 110
TROUBLE = ("Traceback", "ERR|", "Couldn't find object", "Expecting", "In event 'object=")


class Playback:
    """Steps in the window, written to a file that ParaView plays."""

    def __init__(self, folder, version):
        self.folder = folder
        self.version = tuple(int(number) for number in version.split("."))
        self.steps = []

    def event(self, widget, command, arguments=""):
        self.steps.append("<pqevent object=%s command=%s arguments=%s />" % tuple(
            quoteattr(text) for text in (widget, command, arguments)))

    def check(self, widget, name, value):
        self.steps.append("<pqcheck object=%s property=%s arguments=%s />" % tuple(
            quoteattr(text) for text in (widget, name, value)))

    def press(self, button):
        self.event(button, "activate")

    def menu(self, menu, entry):
        self.event(MAIN + "/menubar/" + menu, "activate", entry)

    def apply(self):
        self.check(PROPERTIES + "/Accept", "enabled", "true")
        self.press(PROPERTIES + "/Accept")

    def filter(self, name):
        if self.version >= (5, 12):  # whose categories come when the menu opens
            self.event(MAIN + "/menubar", "activate", "menuFilters")
        if self.version >= (6, 0):  # or a while later
            self.event(MAIN, "pause", "2000")
        self.menu("menuFilters/Surface Remeshing", name)

    def click(self, tree, place):
        """Click an entry of a tree, at its left side."""
        self.event(tree, "mousePress", "1,1,0,40,10," + place)
        self.event(tree, "mouseRelease", "1,0,0,40,10," + place)

    def select(self, place):
        self.click(MAIN + "/pipelineBrowserDock/pipelineBrowser", place)

    def choose_input(self, name, place):
        """Answer the dialog that asks for a filter's inputs."""
        dialog = MAIN + "/SelectInputDialog"
        self.event(dialog + "/buttonFrame/" + name, "set_boolean", "true")
        self.click(dialog + "/pipelineView", place)
        self.press(dialog + "/buttonBox/1QPushButton0")

    def type(self, widget, text):
        """Replace a box's text, key by key, and press Return."""
        self.check(widget, "visible", "true")
        self.key(widget, ord("A"), "", modifiers=0x04000000)
        for letter in text:
            self.key(widget, ord(letter), letter)
        self.key(widget, 0x01000004, "")

    def key(self, widget, code, text, modifiers=0):
        for kind in (6, 7):  # pressed, released
            self.event(widget, "keyEvent", "%d:%d:%d:%s:0:1" % (kind, code, modifiers, text))

    def load_plugin(self, plugin):
        dialog = MAIN + "/PluginManagerDialog"
        self.menu("menuTools", "actionManage_Plugins")
        self.press(dialog + "/splitter/localGroup/loadLocal")
        files = "/pqFileDialog"
        if (5, 12) <= self.version < (6, 0):
            files = "/1pqFileDialog0/tabWidget/qt_tabwidget_stackedwidget/pqFileDialog"
        self.event(dialog + files, "filesSelected", plugin)
        self.press(dialog + "/buttonBox/1QPushButton0")

    def open(self, file):
        self.menu("menu_File", "actionFileOpen")
        self.event(MAIN + "/FileOpenDialog", "filesSelected", os.path.join(self.folder, file))
        self.apply()

    def save_state(self, file):
        self.menu("menu_File", "actionFileSaveServerState")
        self.event(MAIN + "/FileSaveServerStateDialog", "filesSelected",
                   os.path.join(self.folder, file))

    def load_state(self, file):
        self.menu("menu_File", "actionFileLoadServerState")
        self.event(MAIN + "/FileLoadServerStateDialog", "filesSelected",
                   os.path.join(self.folder, file))
        self.press("LoadStateOptionsDialog/widget/OKButton")

    def animate(self, source, name):
        """Add a track for a property, which the lists must offer."""
        if self.version < (5, 12):
            self.menu("menu_View", "Animation View")
            tracks = MAIN + "/animationViewDock/animationView/pqAnimationWidget"
            chooser = tracks + "/CreateDeleteWidget"
            boxes = [chooser + "/ProxyCombo", chooser + "/PropertyCombo"]
        else:
            self.menu("menu_View", "Time Manager")
            tracks = (MAIN + "/timeManagerDock/timeManagerPanel/timeline/1pqTimelineView0"
                      "/qt_scrollarea_viewport/addTrackWidget")
            boxes = [tracks + "/proxiesBox", tracks + "/propertiesBox"]
        for box, text in zip(boxes, (source, name)):
            self.event(box, "activated", text)
            self.check(box, "currentText", text)
        if self.version < (5, 12):
            # The "+" is section 2 of a header, below the header's own and Time's.
            for command in ("mousePress", "mouseRelease"):
                self.event(tracks + "/1QHeaderView0", command, "1,1,0,0,0,2")
        else:
            self.press(tracks + "/addButton")

    def state(self, name, digests=()):
        """Have the window's Python shell write what there is."""
        values = {"name": name, "folder": self.folder, "digests": digests}
        self.event(SHELL, "executeCommand",
                   "exec(compile(open(%r).read(), 'State', 'exec'), %r)" % (STATE_SCRIPT, values))

    def write(self):
        file = os.path.join(self.folder, "steps.xml")
        with open(file, "w") as out:
            out.write('<?xml version="1.0" ?>\n<pqevents>\n%s\n</pqevents>\n'
                      % "\n".join(self.steps))
        return file


class Display:
    """A screen and a window manager of its own."""

    def __enter__(self):
        reading, writing = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writing), "-screen", "0", "1280x1024x24", "-noreset",
             "-nolisten", "tcp"], pass_fds=(writing,), stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as pipe:
            name = ":" + pipe.readline().strip()
        self.environment = dict(os.environ, DISPLAY=name)
        self.manager = subprocess.Popen(["openbox"], env=self.environment,
                                        stderr=subprocess.DEVNULL)
        return self

    def __exit__(self, *_):
        for process in (self.manager, self.server):
            process.kill()
            process.wait()


def play(paraview, version, playback):
    """Play the steps. Returns the lines that tell of failures."""
    settings = os.path.join(playback.folder, "settings", "ParaView")
    os.makedirs(settings)
    for name in ("ParaView%s.ini" % version, "ParaView.ini"):  # the second since ParaView 6
        with open(os.path.join(settings, name), "w") as file:
            file.write("[General]\nGeneralSettings.ShowWelcomeDialog=false\n")
    with Display() as display:
        environment = dict(display.environment, XDG_CONFIG_HOME=os.path.dirname(settings))
        process = subprocess.Popen(
            [paraview, "--exit", "--test-directory=" + playback.folder,
             "--test-script=" + playback.write()], env=environment, text=True, errors="replace",
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True)
        return watch(process)


def watch(process):
    """Read what ParaView tells until it ends, or fails, or takes too long."""
    def end():
        os.killpg(process.pid, signal.SIGKILL)

    failures = []
    timer = threading.Timer(SECONDS, end)
    timer.start()
    for line in process.stdout:
        print(line, end="", flush=True)
        if any(word in line for word in TROUBLE):
            failures.append(line.strip())
        if "In event 'object=" in line:  # The playback stops here, and ParaView may wait for ever.
            timer.cancel()
            timer = threading.Timer(1, end)
            timer.start()
    timer.cancel()
    process.wait()
    if process.returncode and not failures:
        failures.append("ParaView ended with %d" % process.returncode)
    return failures


def write_mesh(file):
    """A torus of triangles without normals, as a scan has none."""
    from math import cos, pi, sin
    rows, columns = 30, 60
    with open(file, "w") as out:
        out.write("ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\n"
                  "property float z\nelement face %d\nproperty list uchar int vertex_indices\n"
                  "end_header\n" % (rows * columns, 2 * rows * columns))
        for row in range(rows):
            for column in range(columns):
                small, large = 2 * pi * row / rows, 2 * pi * column / columns
                radius = 1 + 0.4 * cos(small)
                out.write("%.6f %.6f %.6f\n"
                          % (radius * cos(large), radius * sin(large), 0.4 * sin(small)))
        for row in range(rows):
            for column in range(columns):
                a, b = row * columns, (row + 1) % rows * columns
                here, there = column, (column + 1) % columns
                out.write("3 %d %d %d\n3 %d %d %d\n"
                          % (a + here, a + there, b + there, a + here, b + there, b + here))


def write_field(mesh, file):
    """The mesh with heights as its active scalars."""
    from vtkmodules.vtkFiltersCore import vtkElevationFilter
    from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
    from vtkmodules.vtkIOPLY import vtkPLYReader
    reader = vtkPLYReader()
    reader.SetFileName(mesh)
    heights = vtkElevationFilter()
    heights.SetInputConnection(reader.GetOutputPort())
    writer = vtkPolyDataWriter()
    writer.SetInputConnection(heights.GetOutputPort())
    writer.SetFileName(file)
    writer.Write()


def squares_of(file):
    """A picture's mean colours (0 to 255) in squares of 10 by 10."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
    rows, columns = height // 10, width // 10
    return pixels[:10 * rows, :10 * columns, :3].reshape(
        rows, 10, columns, 10, 3).mean(axis=(1, 3))


class Judge:
    """Compares what the window held with what it should."""

    def __init__(self, folder, version, failures):
        self.folder = folder
        self.version = version
        self.failures = failures

    def read(self, name):
        file = os.path.join(self.folder, name + ".json")
        if not os.path.exists(file):
            self.failures.append("%s: was not reached" % name)
            return None
        with open(file) as text:
            state = json.load(text)
        if "error" in state:
            self.failures.append("%s: %s" % (name, state["error"]))
            return None
        return state

    def equal(self, what, found, expected):
        if found != expected:
            self.failures.append("%s: %r instead of %r" % (what, found, expected))

    def within(self, what, found, low, high):
        if not low <= found <= high:
            self.failures.append("%s: %r is not within %r and %r" % (what, found, low, high))

    def picture(self, name):
        """
        The picture of the view against that of Testing/Data/Baseline, square by square: drivers
        draw edges a little differently, but a wrong colour, view or mesh shows in many squares.
        """
        baseline = os.path.join(BASELINES, "TestWindow-%s-%d.%d.png" % ((name,) + self.version[:2]))
        if not os.path.exists(baseline):
            print("No baseline of this ParaView: %s" % os.path.basename(baseline))
            return
        found = squares_of(os.path.join(self.folder, name + ".png"))
        wanted = squares_of(baseline)
        if found.shape != wanted.shape:
            self.equal(name + ", size of the picture", found.shape, wanted.shape)
            return
        off = abs(found - wanted).max(axis=2)
        self.within(name + ", mean difference to the baseline", float(off.mean()), 0.0, 6.0)
        self.within(name + ", squares unlike the baseline", float((off > 40).mean()), 0.0, 0.02)

    def visible(self, name, state, expected):
        """What is seen, in all views, as (source, port) pairs; the render view stays active."""
        seen = sorted((item["source"], item["port"])
                      for view in state["views"].values() for item in view["visible"])
        self.equal(name + ", visible outputs", seen, sorted(expected))
        self.equal(name + ", views", [view["type"] for view in state["views"].values()],
                   ["RenderView"])
        if name != "loaded" or state["active_view"]:  # ParaView 5.13 leaves none active then
            self.equal(name + ", active view", state["active_view"], "RenderView")


# Places in trees of the pipeline, by rows.
MESH = "/0:0/0:0"
SURFACE = MESH + "/0:0/0:0"
SITES = MESH + "/0:0/2:0"
REMESHER = "AnisotropicRemesher1"


def play_remesher(steps):
    steps.filter("AnisotropicRemesher")
    for choice, number, tolerance in (("DistanceTolerance", "false", "true"),
                                      ("NumberOfPoints", "true", "false")):
        steps.event(SIZE + "/Choose" + choice, "set_boolean", "true")
        steps.check(SIZE + "/NumberOfPoints", "visible", number)
        steps.check(SIZE + "/DistanceTolerance", "visible", tolerance)
    steps.type(SIZE + "/NumberOfPoints", "500")
    steps.type(ANISOTROPY, "0.06")
    steps.apply()
    steps.state("first")
    steps.type(SIZE + "/NumberOfPoints", "300")
    steps.apply()
    steps.menu("menu_Edit", "actionEditUndo")
    steps.check(SIZE + "/NumberOfPoints", "text", "500")
    steps.menu("menu_Edit", "actionEditRedo")
    steps.check(SIZE + "/NumberOfPoints", "text", "300")
    steps.state("redone", [REMESHER])
    steps.save_state("window.pvsm")
    steps.menu("menu_Edit", "actionDelete_All")
    if steps.version < (5, 12):  # later ones do not ask
        steps.press(MAIN + "/CoreUtilitiesPromptUser/qt_msgbox_buttonbox/1QPushButton0")
    steps.load_state("window.pvsm")
    steps.state("loaded", [REMESHER])
    steps.select(MESH + "/0:0")
    steps.press(PANEL + "/ConvergenceChart/Button")
    steps.state("chart")


def judge_remesher(judge):
    first = judge.read("first")
    if first:
        source = first["sources"][REMESHER]
        judge.equal("first, Number Of Points", source["NumberOfPoints"], 500)
        judge.equal("first, Anisotropy", source["Anisotropy"], 0.06)
        judge.equal("first, points", source["points"][0], 500)
        judge.equal("first, triangles", source["cells"][0], 1000)
        judge.visible("first", first, [(REMESHER, 0)])
        picture = first.get("picture", {"surface": 0, "lines": 0})
        judge.within("first, part of the picture", picture["surface"], 0.1, 0.9)
        judge.within("first, edges in the picture", picture["lines"], 0.03, 0.6)
        judge.picture("first")
    redone = judge.read("redone")
    if redone:
        judge.equal("redone, points", redone["sources"][REMESHER]["points"][0], 300)
    loaded = judge.read("loaded")
    if redone and loaded:
        judge.equal("loaded", loaded["sources"][REMESHER], redone["sources"][REMESHER])
        judge.visible("loaded", loaded, [(REMESHER, 0)])
    chart = judge.read("chart")
    if chart:
        judge.equal("chart, views", sorted(view["type"] for view in chart["views"].values()),
                    ["RenderView", "XYChartView"])


def play_animation(steps):
    steps.filter("AnisotropicRemesher")
    steps.type(SIZE + "/NumberOfPoints", "300")
    steps.apply()
    steps.animate(REMESHER, "Number Of Points")
    steps.event(SHELL, "executeCommand",  # ParaView 6 begins with one
                "from paraview import simple; simple.GetAnimationScene().NumberOfFrames = 10")
    steps.state("animation")
    for button, name in (("First", "First"), ("Next", ""), ("Next", "Second"), ("Last", "Last")):
        steps.press(MAIN + "/VCRToolbar/actionVCR%sFrame" % button)
        if name:
            steps.state("frame" + name)


def judge_animation(judge):
    animated = judge.read("animation")
    if animated:
        judge.equal("animation, active view", animated["active_view"], "RenderView")
    counts = []
    for frame in ("First", "Second", "Last"):
        state = judge.read("frame" + frame)
        if state:
            source = state["sources"][REMESHER]
            judge.equal("frame%s, points" % frame, source["points"][0], source["NumberOfPoints"])
            counts.append(source["NumberOfPoints"])
    # From the least of the property's range to what it was, in 10 frames.
    judge.equal("animation, Number Of Points", counts, [4, 69, 300])


def play_others(steps):
    steps.filter("AnisotropicRemesher")
    steps.type(SIZE + "/NumberOfPoints", "400")
    steps.apply()
    steps.filter("SurfaceMeshComparison")
    steps.choose_input("Reference", MESH)
    steps.apply()
    steps.state("comparison")
    steps.select(MESH)
    steps.filter("RestrictedVoronoiDiagram")
    steps.choose_input("Sites", SITES)
    steps.type(ANISOTROPY, "0.03")
    steps.apply()
    steps.state("diagram")
    steps.select(MESH)
    steps.filter("GaussMapEmbedding")
    steps.type(PANEL + "/NumberOfPoints/LineEdit0", "700")
    steps.type(ANISOTROPY, "0.05")
    steps.apply()
    steps.state("embedding")


def judge_others(judge):
    comparison = judge.read("comparison")
    if comparison:
        source = comparison["sources"]["SurfaceMeshComparison1"]
        judge.equal("comparison, Input", source["Input"], REMESHER)
        judge.equal("comparison, Reference", source["Reference"], "mesh.ply")
        judge.equal("comparison, points", source["points"][:2], [400, 1800])
        judge.visible("comparison", comparison, [("SurfaceMeshComparison1", 0)])
    diagram = judge.read("diagram")
    if diagram:
        source = diagram["sources"]["RestrictedVoronoiDiagram1"]
        judge.equal("diagram, Input", source["Input"], "mesh.ply")
        judge.equal("diagram, Sites", source["Sites"], REMESHER)
        judge.equal("diagram, Anisotropy", source["Anisotropy"], 0.03)
        judge.equal("diagram, triangles", source["cells"][0], 800)
        judge.visible("diagram", diagram,
                      [("RestrictedVoronoiDiagram1", 0), ("SurfaceMeshComparison1", 0)])
    embedding = judge.read("embedding")
    if embedding:
        source = embedding["sources"]["GaussMapEmbedding1"]
        judge.equal("embedding, Number Of Points", source["NumberOfPoints"], 700)
        judge.equal("embedding, Anisotropy", source["Anisotropy"], 0.05)
        judge.equal("embedding, points", source["points"], [1800])


def play_fields(steps):
    """A metric for the active scalars, its embedding, the mesh in it; and eigenfunctions."""
    steps.open("field.vtk")
    steps.filter("SolutionMetric")
    steps.type(PANEL + "/NumberOfPoints/LineEdit0", "600")
    steps.apply()
    steps.filter("MetricEmbedding")
    choice = PANEL + "/MetricArray/ComboBox"
    steps.event(choice, "activated", "Metric")
    steps.check(choice, "currentText", "Metric")
    steps.type(PANEL + "/NumberOfPoints/LineEdit0", "600")
    steps.apply()
    steps.filter("SpectralEmbedding")
    steps.type(PANEL + "/Dimension/LineEdit0", "8")
    steps.apply()
    steps.state("fields")


def judge_fields(judge):
    state = judge.read("fields")
    if not state:
        return
    for name, array, components in (("SolutionMetric1", "Metric", 6),
                                    ("MetricEmbedding1", "Embedding", 6),
                                    ("SpectralEmbedding1", "Embedding", 8)):
        source = state["sources"][name]
        judge.equal("fields, %s of %s" % (array, name), source["arrays"].get(array), components)
        # The metric's embedding splits triangles where the metric asks for that.
        judge.within("fields, cells of " + name, source["cells"][0], 3600,
                     3600 if array == "Metric" else 36000)
    judge.visible("fields", state, [("SpectralEmbedding1", 0), ("mesh.ply", 0)])


SCENARIOS = {"Remesher": (play_remesher, judge_remesher),
             "Animation": (play_animation, judge_animation),
             "Others": (play_others, judge_others),
             "Fields": (play_fields, judge_fields)}


def main(paraview, version, plugin, folder, scenario):
    folder = os.path.join(os.path.abspath(folder), "Window" + scenario)
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    write_mesh(os.path.join(folder, "mesh.ply"))
    write_field(os.path.join(folder, "mesh.ply"), os.path.join(folder, "field.vtk"))
    press, judge = SCENARIOS[scenario]
    steps = Playback(folder, version)
    steps.load_plugin(plugin)
    steps.open("mesh.ply")
    press(steps)
    failures = play(paraview, version, steps)
    judge(Judge(folder, steps.version, failures))
    for failure in failures:
        print("FAILED:", failure)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
