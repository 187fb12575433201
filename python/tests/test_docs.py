"""The snippets of README.md and docs/python.md run, in their order; docstrings are there, in the stub too"""

import importlib.util
import pathlib
import re
import sys
import types
from typing import Any, Dict

import ompl_certificates as oc
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


class SpaceInformation:
    """In place of OMPL's, whose Python bindings Debian has not"""

    def getStateDimension(self) -> int:
        return 4


class StateValidityChecker:
    def __init__(self, si: SpaceInformation) -> None:
        self.si = si


def test_snippets_run(monkeypatch: pytest.MonkeyPatch, room: oc.Scene) -> None:
    fakes = {"ompl": types.ModuleType("ompl"), "ompl.base": types.ModuleType("ompl.base")}
    setattr(fakes["ompl"], "base", fakes["ompl.base"])
    setattr(fakes["ompl.base"], "StateValidityChecker", StateValidityChecker)
    for name, module in fakes.items():
        monkeypatch.setitem(sys.modules, name, module)
    monkeypatch.chdir(ROOT)
    (ROOT / "out").mkdir(exist_ok=True)
    names: Dict[str, Any] = {}
    snippets = []
    for page in ("README.md", "docs/python.md"):
        snippets += re.findall(r"```python\n(.*?)```", (ROOT / page).read_text(encoding="utf-8"), re.DOTALL)
    assert len(snippets) == 20
    for snippet in snippets:
        exec(snippet, names)  # pylint: disable=exec-used
    checker = names["CertificateChecker"](SpaceInformation(), oc.Checker(room))
    assert checker.isValid([1, 5, 9, 5, 77]) is True
    assert checker.isValid([5, 5, 9, 5]) is False


def test_every_public_name_is_explained() -> None:
    for name in oc.__all__:
        thing = getattr(oc, name)
        assert thing.__doc__, name
        if isinstance(thing, type) and name != "Error":
            for member, value in vars(thing).items():
                assert member.startswith("_") or value.__doc__, f"{name}.{member}"


def test_stubs_name_what_there_is() -> None:
    text = (ROOT / "python" / "ompl_certificates" / "_core.pyi").read_text(encoding="utf-8")
    for name in ("Body", "Robot", "Scene", "Checker", "Plan", "ControlPlan"):
        section = re.search(rf"class {name}:\n(.*?)(?=\n\S|\Z)", text, re.DOTALL)
        assert section
        stubs = set(re.findall(r"^    (?:def )?([a-z]\w*)\b", section[1], re.MULTILINE)) - {"def", "self", "name:"}
        public = {member for member in vars(getattr(oc, name)) if not member.startswith("_")}
        assert stubs >= public, f"{name}: {public - stubs} have no stub"
        defined = set(re.findall(r"^    def ([a-z]\w*)", section[1], re.MULTILINE))
        assert defined <= public, f"{name}: {defined - public} are stubs of nothing"


def test_editors_show_the_docstrings() -> None:
    spec = importlib.util.spec_from_file_location("python_stub", ROOT / "scripts" / "python_stub.py")
    assert spec and spec.loader
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    text = script.STUB.read_text(encoding="utf-8")
    assert text == script.with_docstrings(text, getattr(oc, "_core")), "scripts/python_stub.py mends it"
    assert "Which states are valid" in text
