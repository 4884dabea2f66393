#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fails when a room of the project sees another one that it must not see.

A room is a folder such as Filters/Lines. It sees another by including one of its headers, by a
dependency in its vtk.module, or by linking its target in a CMakeLists.txt. Tests, examples and
Testing/ may see everything.

    CheckIncludes.py [ROOT]       checks the tree (default: the one this file stands in)
    CheckIncludes.py --self-test  checks this program on made-up trees
"""

import re
import sys
import tempfile
from pathlib import Path

CHAIN = ["Filters/Core", "Filters/Surfaces", "Filters/Curvature", "Filters/Lines",
         "Filters/Strokes"]
DRAWING = ["Rendering/Offscreen", "Rendering/Shading", "Rendering/Strokes", "Rendering/ImageSpace"]
ON_CORE = ["Filters/Sources", "Filters/Volume", "Modules/IO"]
# These see everything; nothing sees them, but that the doors see the illustration.
ILLUSTRATION = "Rendering/Illustration"
DOORS = ["Modules/Application", "Modules/Python", "Modules/ParaView"]
ROOMS = CHAIN + DRAWING + ON_CORE + [ILLUSTRATION] + DOORS
# Holds build files only.
NO_ROOM = ["Modules/CMake"]

ALLOWED = {room: set(CHAIN[:i]) for i, room in enumerate(CHAIN)}
ALLOWED.update({room: set(CHAIN + DRAWING) for room in DRAWING})
ALLOWED.update({room: {"Filters/Core"} for room in ON_CORE})
ALLOWED[ILLUSTRATION] = set(CHAIN + DRAWING + ON_CORE)
ALLOWED.update({room: set(CHAIN + DRAWING + ON_CORE + [ILLUSTRATION]) for room in DOORS})

# What no filter may include or depend on. A filter may know vtkCamera, vtkProp3D and vtkMatrix4x4;
# the first two live in VTK::RenderingCore, so that module is allowed and its drawing classes are not.
DRAWING_HEADER = re.compile(
    r"(vtk\w*OpenGL\w*|vtk\w*RenderWindow\w*|vtk\w*Renderer\w*|vtk\w*RenderPass\w*|vtk\w*Actor\w*"
    r"|vtk\w*Mapper\w*|vtkShader\w*|vtkTextureObject|(GL|EGL|GLES\d)/.*|glew|osmesa)\.h$")
DRAWING_MODULE = re.compile(r"VTK::(Rendering(?!Core$)|Interaction|Views|GUISupport|glew$|opengl$)")

COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.S)
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"]', re.M)
SOURCES = {".h", ".hxx", ".hpp", ".txx", ".cxx", ".cpp", ".cc", ".c", ".in"}


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def without_comments(text):
    """Blanks C++ comments, keeping the line numbers."""
    return COMMENT.sub(lambda match: re.sub(r"[^\n]", " ", match.group()), text)


def room_of(root, path):
    parts = path.relative_to(root).parts
    return "/".join(parts[:2]) if len(parts) > 2 else None


def check(root):
    """The broken arrows of the tree, each as one line of text."""
    problems = []
    files = []  # (room, path) of what belongs to a room, without its tests
    for top in ("Filters", "Rendering", "Modules"):
        for path in sorted((root / top).rglob("*")):
            room = room_of(root, path)
            if path.is_file() and room and room not in NO_ROOM:
                if "Testing" not in path.relative_to(root).parts:
                    files.append((room, path))
    for room in sorted({room for room, _ in files} - set(ROOMS)):
        problems.append(f"{room}: is not a room of the house. If it should be one, say in "
                        "Testing/Tools/CheckIncludes.py what it may see.")
    files = [(room, path) for room, path in files if room in ROOMS]
    texts = {path: path.read_text(errors="replace") for _, path in files
             if path.suffix in SOURCES or path.name in ("vtk.module", "CMakeLists.txt")}

    owner = {}  # header, module or library -> room
    for room, path in files:
        if path.suffix in (".h", ".hxx", ".hpp", ".txx"):
            other = owner.setdefault(path.name, room)
            if other != room:
                problems.append(f"{path.relative_to(root)}: {other} has a header of this name, too")
        elif path.name == "vtk.module":
            words = re.sub(r"#[^\n]*", "", texts[path]).split()
            name = words[words.index("NAME") + 1]
            library = (words[words.index("LIBRARY_NAME") + 1] if "LIBRARY_NAME" in words
                       else name.split("::")[-1])
            owner[name] = owner[library] = owner[library + "Module.h"] = room

    def judge(room, path, line, name, key):
        seen = owner.get(key)
        where = f"{path.relative_to(root)}:{line}"
        if seen and seen != room and seen not in ALLOWED[room]:
            problems.append(f"{where}: {room} must not see {seen} ({name})")
        elif room.startswith("Filters/") and (DRAWING_HEADER.match(name)
                                              or DRAWING_MODULE.match(name)):
            problems.append(f"{where}: filters must not see what draws ({name})")

    for room, path in files:
        if path not in texts:
            continue
        if path.suffix in SOURCES:
            text = without_comments(texts[path])
            for match in INCLUDE.finditer(text):
                name = match.group(1)
                judge(room, path, line_of(text, match.start(1)), name, name.split("/")[-1])
        else:
            text = re.sub(r"#[^\n]*", lambda match: " " * len(match.group()), texts[path])
            for match in re.finditer(r"(?:NPR|VTK)::\w+|\bvtkNPR\w+", text):
                judge(room, path, line_of(text, match.start()), match.group(), match.group())
    return problems


def self_test():
    """Every broken arrow must be found, and nothing else."""
    sound = {
        "Filters/Core/vtk.module": "NAME NPR::FiltersCore LIBRARY_NAME vtkNPRFiltersCore",
        "Filters/Core/nprMesh.h": "#include <vtkCamera.h>\n#include <vtkObjectFactory.h>\n",
        "Filters/Lines/vtk.module":
            "NAME NPR::FiltersLines LIBRARY_NAME vtkNPRFiltersLines\n"
            "DEPENDS NPR::FiltersCore VTK::RenderingCore",
        "Filters/Lines/vtkNPRLines.h": '#include "nprMesh.h"\n',
        "Filters/Lines/Testing/Cxx/TestLines.cxx": "#include <vtkRenderWindow.h>\n",
        "Filters/Volume/vtkNPRVolume.h": '#include "nprMesh.h"\n// #include "vtkNPRLines.h"\n',
        "Modules/IO/vtkNPRReader.h": '#include "nprMesh.h"\n',
        "Rendering/Strokes/vtkNPRStrokeMapper.h":
            '#include "vtkNPRLines.h"\n#include <vtkOpenGLPolyDataMapper.h>\n',
        "Rendering/Illustration/vtkNPRIllustration.h": '#include "vtkNPRStrokeMapper.h"\n',
        "Modules/Application/npr.cxx": '#include "vtkNPRIllustration.h"\n',
        "Modules/Application/Options.h": "",
        "Modules/CMake/nprX.cmake": "",
    }
    broken = [
        ("Filters/Core/a.cxx", '#include "vtkNPRLines.h"\n', "must not see Filters/Lines"),
        ("Filters/Core/a.cxx", '#if 1\n#  include "../Lines/vtkNPRLines.h"\n#endif\n',
         "a.cxx:2: Filters/Core must not see Filters/Lines"),
        ("Filters/Core/a.cxx", "#include <vtkNPRFiltersLinesModule.h>\n", "Filters/Lines"),
        ("Filters/Core/CMakeLists.txt", "vtk_module_link(NPR::FiltersCore NPR::FiltersLines)",
         "Filters/Lines"),
        ("Filters/Curvature/vtk.module", "NAME NPR::FiltersCurvature\nDEPENDS NPR::FiltersLines",
         "vtk.module:2: Filters/Curvature must not see Filters/Lines"),
        ("Filters/Lines/b.h", '#include "vtkNPRStrokeMapper.h"\n', "Rendering/Strokes"),
        ("Filters/Lines/b.h", '#include "vtkNPRVolume.h"\n', "Filters/Volume"),
        ("Filters/Lines/b.h", "#include <vtkRenderWindow.h>\n", "what draws"),
        ("Filters/Lines/b.h", "#include <vtkActor.h>\n", "what draws"),
        ("Filters/Lines/b.h", "#include <vtkPolyDataMapper.h>\n", "what draws"),
        ("Filters/Lines/b.h", "#include <vtkOpenGLRenderer.h>\n", "what draws"),
        ("Filters/Lines/b.h", "#include <GL/gl.h>\n", "what draws"),
        ("Filters/Strokes/vtk.module", "NAME NPR::S DEPENDS VTK::RenderingOpenGL2", "what draws"),
        ("Filters/Volume/c.cxx", '#include "vtkNPRLines.h"\n', "must not see Filters/Lines"),
        ("Filters/Sources/c.cxx", '#include "vtkNPRReader.h"\n', "must not see Modules/IO"),
        ("Modules/IO/c.cxx", '#include "vtkNPRVolume.h"\n', "must not see Filters/Volume"),
        ("Rendering/Shading/d.h", '#include "vtkNPRIllustration.h"\n', "Rendering/Illustration"),
        ("Rendering/Shading/d.h", '#include "vtkNPRReader.h"\n', "Modules/IO"),
        ("Rendering/Illustration/d.h", '#include "Options.h"\n', "Modules/Application"),
        ("Modules/Python/d.h", '#include "Options.h"\n', "Modules/Application"),
        ("Filters/Sketches/e.h", "", "not a room"),
        ("Rendering/Shading/nprMesh.h", "", "of this name"),
    ]

    def problems_of(tree):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in tree.items():
                path = Path(folder) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            return check(Path(folder))

    failures = [f"in the sound tree: {problem}" for problem in problems_of(sound)]
    for name, text, expected in broken:
        found = problems_of({**sound, name: text})
        if len(found) != 1 or expected not in found[0]:
            failures.append(f"{name} with {text!r}: expected one problem, {expected!r}: {found}")
    return failures


def main():
    if "--self-test" in sys.argv:
        problems = self_test()
    else:
        root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[2])
        if not (root / "Filters").is_dir():
            problems = [f"{root} is not the project's folder: it has no Filters"]
        else:
            problems = check(root.resolve())
    print("\n".join(problems) or "all arrows run the right way")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
