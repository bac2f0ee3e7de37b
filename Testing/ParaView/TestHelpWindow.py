#!/usr/bin/env python3
"""TestHelpWindow.py PLUGIN.so TEMPORARY_DIR PARAVIEW: ParaView's window knows the help pages.

Starts the real window with the plugin, and reads the collection of registered documentation that
it keeps in its temporary folder while it runs: that is where the "?" button looks.
"""
import os
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time
from pathlib import Path

plugin, temporary, paraview = Path(sys.argv[1]), sys.argv[2], sys.argv[3]
PAGES = {f"filters.{name}.html" for name in (
    "AnisotropicRemesher", "RestrictedVoronoiDiagram", "GaussMapEmbedding",
    "MetricEmbedding", "SolutionMetric", "SpectralEmbedding", "SurfaceMeshComparison")}
SECONDS = 120


def registered_pages(folder):
    """The pages that a "?" finds: those in the folder of the namespace's name up to its dot."""
    result = set()
    for collection in folder.glob("*.qhc"):
        database = sqlite3.connect(f"file:{collection}?mode=ro", uri=True)
        try:
            rows = database.execute(
                "SELECT n.Name, d.Name, f.Name FROM NamespaceTable n "
                "JOIN FolderTable d ON d.NamespaceId = n.Id "
                "JOIN FileNameTable f ON f.FolderId = d.Id").fetchall()
        except sqlite3.Error:
            continue  # it is being written
        finally:
            database.close()
        result.update(page for space, directory, page in rows if directory == space.split(".")[0])
    return result


def wait_for_pages(process, folder):
    end = time.monotonic() + SECONDS
    while time.monotonic() < end and process.poll() is None:
        if PAGES <= registered_pages(folder):
            return True
        time.sleep(0.5)
    return False


def end_group(process):
    """Ends the window and its X server, by force where they do not go by themselves."""
    for kind in (signal.SIGTERM, signal.SIGTERM, signal.SIGKILL):
        try:
            os.killpg(process.pid, kind)
        except ProcessLookupError:
            break
        process.poll()
        time.sleep(1)
    process.wait()


def run(folder):
    """Whether a window with its temporary files in a folder comes to know the pages."""
    (folder / "settings").mkdir()
    environment = dict(os.environ, TMPDIR=str(folder), HOME=str(folder),
                       XDG_CONFIG_HOME=str(folder / "settings"), XDG_RUNTIME_DIR=str(folder),
                       PV_PLUGIN_PATH=str(plugin.parent))
    with open(folder / "log.txt", "w", encoding="utf-8") as log:
        process = subprocess.Popen(
            ["xvfb-run", "-a", "-s", "-screen 0 1024x768x24", paraview], env=environment,
            stdout=log, stderr=log, start_new_session=True)
        try:
            return wait_for_pages(process, folder)
        finally:
            end_group(process)


with tempfile.TemporaryDirectory(dir=temporary, ignore_cleanup_errors=True) as name:
    found = run(Path(name))
    print("found" if found else f"not registered within {SECONDS} s\n"
          + (Path(name) / "log.txt").read_text(encoding="utf-8"))
sys.exit(0 if found else 1)
