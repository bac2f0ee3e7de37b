"""What cpack makes of this build: each package's files, relations and, with lintian, rules."""
import argparse
import gzip
import pathlib
import re
import shutil
import subprocess
import tarfile

VTK_PACKAGES = {
    "libanisotropic-remeshing0": [r"lib/.*libvtkFiltersAnisotropicRemeshing\.so\.0(\.\d+)*"],
    "libanisotropic-remeshing-dev": [
        r"include/AnisotropicRemeshing/vtk\w+\.h", r"lib/.*\.cmake",
        r"lib/.*libvtkFiltersAnisotropicRemeshing\.so", r"lib/.*-hierarchy\.txt"],
    "python3-anisotropic-remeshing": [r"lib/python3/dist-packages/anisotropic_remeshing.*"],
    "anisotropic-remeshing-tools": [
        r"bin/remesh_surface", r"share/man/man1/remesh_surface\.1\.gz",
        r"share/(bash-completion|zsh|fish)/.*"],
}
PARAVIEW_PACKAGES = {
    "paraview-anisotropic-remeshing": [r"bin/paraview\.conf", r"lib/.*paraview-[\d.]+/plugins/.*"],
}


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    assert done.returncode == 0, f"{command}: {done.stdout}{done.stderr}"
    return done.stdout


def make_packages(arguments):
    """cpack, compressed less than for others, as that takes most of its time."""
    shutil.rmtree(arguments.work, ignore_errors=True)
    work = pathlib.Path(arguments.work)
    run(arguments.cpack, "--config", arguments.config, "-B", work,
        "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=gzip")
    return work


def files_below(root):
    return {str(path.relative_to(root)) for path in root.rglob("*")
            if path.is_symlink() or not path.is_dir()}


def runtime_path(path):
    """The search path of a program or library; None where it is neither."""
    with open(path, "rb") as file:
        if file.read(4) != b"\x7fELF":
            return None
    found = re.search(r"\((?:RUNPATH|RPATH)\).*\[(.*)\]", run("readelf", "-d", path))
    return found.group(1) if found else ""


def check_archive(work, kind):
    """One folder, which can be anywhere: its programs find the library by themselves."""
    archive, = work.glob("*.tar.gz")
    with tarfile.open(archive) as tar:
        tar.extractall(work / "archive")
    root, = (work / "archive").iterdir()
    assert root.name + ".tar.gz" == archive.name
    binaries = [path for path in root.rglob("*")
                if path.is_file() and not path.is_symlink() and runtime_path(path) is not None]
    assert binaries
    for path in binaries:
        words = runtime_path(path).split(":")
        assert all(word.startswith("$ORIGIN") for word in words if word), (path, words)
    if kind == "vtk":
        version = run(root / "bin" / "remesh_surface", "--version")
        assert re.search(r"\d+\.\d+\.\d+", version), version
    else:
        outside = [name for name in files_below(root) if "/paraview-" not in name]
        assert not outside, outside


def check_documentation(root, package):
    documents = root / "usr" / "share" / "doc" / package
    assert "Redistribution" in (documents / "copyright").read_text()
    with gzip.open(documents / "changelog.gz", "rt") as file:
        assert file.read().startswith("anisotropic-remeshing (")


def check_debian_package(path, package, patterns, kind):
    """Its files, by the patterns, each of which some file fits but those of completions."""
    root = path.parent / package
    run("dpkg-deb", "-x", path, root)
    check_documentation(root, package)
    names = {name[len("usr/"):] for name in files_below(root)
             if not name.startswith(f"usr/share/doc/{package}/")}
    strangers = [name for name in names if not any(re.fullmatch(p, name) for p in patterns)]
    assert not strangers, (package, strangers)
    for pattern in patterns:
        assert "completion" in pattern or any(re.fullmatch(pattern, name) for name in names), (
            package, pattern, names)
    if kind == "vtk":  # in folders that the system searches
        for name in names:
            file = root / "usr" / name
            assert file.is_symlink() or not runtime_path(file), file
    return names


def check_relations(path, package):
    fields = run("dpkg-deb", "-f", path)
    depends = re.search(r"^Depends: (.*)$", fields, re.M).group(1)
    if package != "libanisotropic-remeshing0" and not package.startswith("paraview"):
        assert re.search(r"libanisotropic-remeshing0 \(= [\d.]+\)", depends), depends
    if package.startswith("paraview"):
        assert re.search(r"paraview \(>= [\d.]+\), paraview \(<< [\d.]+~\)", depends), depends
    elif not package.endswith("-dev"):
        assert re.search(r"libvtk9\.", depends), depends
    assert re.search(r"^Description: anisotropic surface remeshing .*\(.*\)$", fields, re.M), fields


def check_debian_packages(work, kind):
    expected = VTK_PACKAGES if kind == "vtk" else PARAVIEW_PACKAGES
    paths = {path.name.split("_")[0]: path for path in work.glob("*.deb")}
    assert set(paths) == set(expected), paths
    seen = {}
    for package, patterns in expected.items():
        check_relations(paths[package], package)
        for name in check_debian_package(paths[package], package, patterns, kind):
            assert name not in seen, (name, package, seen[name])
            seen[name] = package
    if shutil.which("lintian"):
        text = run("lintian", "--allow-root", "--fail-on", "error", *paths.values())
        print(text)
    else:
        print("lintian is not installed: its rules are not checked")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for option in ("cpack", "config", "kind", "generators", "work"):
        parser.add_argument("--" + option, required=True)
    arguments = parser.parse_args()
    work = make_packages(arguments)
    check_archive(work, arguments.kind)
    if "DEB" in arguments.generators.split(";"):
        check_debian_packages(work, arguments.kind)
    else:
        assert not shutil.which("dpkg-shlibdeps") or not shutil.which("file")
        print("no .deb files without dpkg-dev and file")


if __name__ == "__main__":
    main()
