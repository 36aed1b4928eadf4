"""The page of an FMU's model for people, its pictures, and the terminals that plugs fit."""

from __future__ import annotations

import html
import io
import re
from collections.abc import Sequence
from pathlib import Path
from xml.etree import ElementTree as Xml

from lxml import etree
from lxml import html as trees

from pam_cosim.compiler import ClassTree, Ode, read_library
from pam_cosim.fmu.about import identity
from pam_cosim.fmu.description import document
from pam_cosim.fmu.table import VariableEntry, table

_TERMINALS = re.compile(r'terminals\s*=\s*"([^"]*)"')
_REMOVED = ("script", "style", "iframe", "object", "embed", "form")
_STYLE = """body{font:15px/1.5 sans-serif;max-width:60em;margin:2em auto;padding:0 1em}
table{border-collapse:collapse}td,th{border:1px solid #ccc;padding:.2em .6em;text-align:left}img{max-width:100%}"""
_HEADS = ("name", "unit", "default", "min", "max", "meaning")


def documentation(ode: Ode, files: Sequence[Path], fmi: str) -> dict[str, bytes]:
    """The page of the model, pictures of it, and in FMI 3.0 its terminals, by their names in the archive.

    Args:
        ode: the model.
        files: the user's Modelica files.
        fmi: version of the interface.
    """
    tree = read_library(files=files)
    icon, diagram = _pictures(ode.interface.model, files)
    files_by_path = {"documentation/index.html": _page(ode, tree, table(ode, fmi), bool(diagram))}
    if diagram:
        files_by_path["documentation/diagram.png"] = diagram
    if fmi == "2.0":
        return files_by_path | ({"model.png": icon} if icon else {})
    annotation = tree.classes[ode.interface.model].annotations.get("__PamCosim", "")
    files_by_path["terminalsAndIcons/terminalsAndIcons.xml"] = _terminals(
        ode, annotation, bool(icon)
    )
    return files_by_path | ({"terminalsAndIcons/icon.png": icon} if icon else {})


def _pictures(model: str, files: Sequence[Path]) -> tuple[bytes, bytes]:
    """Icon and diagram as PNG; empty where the annotations are no literals, or draw nothing."""
    from pam_cosim.fmu.drawing import Pictures, diagram, gallery

    try:
        pictures = Pictures(files)
        of = pictures.of(model)
        figures = [
            gallery(pictures, [model], columns=1, wide=1.0) if pictures.shapes(of) else None,
            diagram(pictures, model) if pictures.parts(of) else None,
        ]
    except (ValueError, KeyError, TypeError, IndexError):
        return b"", b""
    drawn = []
    for figure in figures:
        content = io.BytesIO()
        if figure is not None:
            figure.savefig(content, format="png", dpi=110, metadata={"Software": None})
        drawn.append(content.getvalue())
    return drawn[0], drawn[1]


def _terminals(ode: Ode, annotation: str, has_icon: bool) -> bytes:
    """The plugs that the class declares: ``terminals="gas: p, V"``, with the members of each."""
    root = Xml.Element("fmiTerminalsAndIcons", {"fmiVersion": "3.0"})
    if has_icon:
        drawing = Xml.SubElement(root, "GraphicalRepresentation")
        corners = {"x1": "-100.0", "y1": "-100.0", "x2": "100.0", "y2": "100.0"}
        scale = {"suggestedScalingFactorTo_mm": "0.1"}
        Xml.SubElement(drawing, "CoordinateSystem", corners | scale)
        Xml.SubElement(drawing, "Icon", corners)
    declared = _TERMINALS.search(annotation)
    signals = ode.interface.inputs | ode.interface.outputs
    listed = Xml.SubElement(root, "Terminals") if declared else root
    for plug in declared[1].split(";") if declared else ():
        name, _, members = plug.partition(":")
        terminal = Xml.SubElement(
            listed, "Terminal", {"name": name.strip(), "matchingRule": "plug"}
        )
        for member in (part.strip() for part in members.split(",")):
            if member in signals:
                named = {"variableName": member, "memberName": member, "variableKind": "signal"}
                Xml.SubElement(terminal, "TerminalMemberVariable", named)
    return document(root)


def _page(ode: Ode, tree: ClassTree, entries: Sequence[VariableEntry], drawn: bool) -> bytes:
    """The documentation of the class, of what it is made of, and of its sources; its interface as tables."""
    model, about = ode.interface.model, identity(ode)
    first = f"{model} {about.get('version', '')}".strip()
    parts = [f"<h1>{html.escape(first)}</h1>", f"<p>{html.escape(ode.description)}</p>"]
    if about.get("author"):
        parts.append(
            f"<p>{html.escape(about['author'])}, licence {html.escape(about['license'])}</p>"
        )
    if drawn:
        parts.append('<p><img src="diagram.png" alt="Diagram of the model"></p>')
    for title, causality in (
        ("Inputs", "input"),
        ("Outputs", "output"),
        ("Parameters", "parameter"),
    ):
        parts += _table(title, [e for e in entries if e.causality == causality])
    classes = dict.fromkeys(c for part in ode.parts for c in (part.type, *part.bases))
    library = model.split(".")[0]
    for name in (*classes, f"{library}.UsersGuide.References"):
        text = _fragment(tree.classes[name].documentation) if name in tree.classes else ""
        if text:
            parts.append(f"<h2>{html.escape(name)}</h2>{text}")
    body = "\n".join(parts)
    head = f'<meta charset="utf-8"><title>{html.escape(model)}</title><style>{_STYLE}</style>'
    return f'<!DOCTYPE html>\n<html lang="en"><head>{head}</head>\n<body>\n{body}\n</body></html>\n'.encode()


def _table(title: str, entries: Sequence[VariableEntry]) -> list[str]:
    if not entries:
        return []
    rows = [f"<h2>{title}</h2><table><tr>{''.join(f'<th>{h}</th>' for h in _HEADS)}</tr>"]
    for entry in entries:
        v = entry.variable
        limits = ("" if x is None else f"{x:g}" for x in (entry.start, v.min, v.max))
        meaning = v.description + ("; may change in a run" * (entry.variability == "tunable"))
        cells = (v.name, v.unit or "1", *limits, meaning)
        rows.append(f"<tr>{''.join(f'<td>{html.escape(cell)}</td>' for cell in cells)}</tr>")
    return [*rows, "</table>"]


def _fragment(text: str) -> str:
    """The text of a class's documentation without links to other classes, and without anything that runs."""
    if not text.strip():
        return ""
    try:
        root = trees.fragment_fromstring(text, create_parent="div")
    except etree.ParserError:
        return ""
    for element in list(root.iter()):
        if not isinstance(element.tag, str) or element.tag in _REMOVED:
            element.drop_tree()
        elif element.get("href", "#").split(":")[0] not in ("#", "http", "https"):
            element.drop_tag()
        else:
            for key in [key for key in element.attrib if key.startswith("on")]:
                del element.attrib[key]
    return str(etree.tostring(root, encoding="unicode", method="html"))
