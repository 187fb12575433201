"""Writes the docstrings of the built module into its stub, from which editors show them:

    PYTHONPATH=build/python python3 scripts/python_stub.py
"""

import ast
import inspect
import pathlib
import textwrap
from typing import Any, Iterator, List, Tuple

STUB = pathlib.Path(__file__).resolve().parents[1] / "python" / "ompl_certificates" / "_core.pyi"
WIDTH = 120


def docstring_of(thing: Any) -> str:
    """Its docstring without the signature that pybind11 writes before it"""
    text = inspect.cleandoc(thing.__doc__ or "")
    if not callable(thing) or isinstance(thing, type):
        return text
    return text.partition("\n")[2].strip()


def documented(tree: ast.Module, module: Any) -> Iterator[Tuple[ast.stmt, str]]:
    """Each class, function, property and attribute of a stub, with its docstring in the module"""
    for node in tree.body:
        if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            thing = getattr(module, node.name)
            yield node, docstring_of(thing)
        if isinstance(node, ast.ClassDef):
            for member in node.body:
                if isinstance(member, ast.FunctionDef):
                    yield member, docstring_of(getattr(thing, member.name))
                elif isinstance(member, ast.AnnAssign) and isinstance(member.target, ast.Name):
                    yield member, docstring_of(getattr(thing, member.target.id))


def literal(text: str, indent: int) -> List[str]:
    """The lines of a docstring"""
    margin = " " * indent
    lines: List[str] = []
    for paragraph in f'"""{text}"""'.split("\n\n"):
        lines += [""] if lines else []
        lines += textwrap.wrap(paragraph, WIDTH, initial_indent=margin, subsequent_indent=margin)
    return lines


def has_docstring(node: ast.stmt) -> bool:
    """Whether a statement is a docstring"""
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)


def following(tree: ast.Module, node: ast.stmt) -> List[ast.stmt]:
    """The statements of a class after one of them"""
    for parent in tree.body:
        if isinstance(parent, ast.ClassDef) and node in parent.body:
            return parent.body[parent.body.index(node) + 1:]
    return []


def with_docstrings(source: str, module: Any) -> str:
    """A stub with the docstrings of a module in place of those that it has"""
    tree = ast.parse(source)
    lines = source.splitlines()
    for node, text in sorted(documented(tree, module), key=lambda pair: -pair[0].lineno):
        if not text:
            continue
        if isinstance(node, ast.AnnAssign):
            after = following(tree, node)
            if after and has_docstring(after[0]):
                del lines[after[0].lineno - 1:after[0].end_lineno]
            lines[node.lineno:node.lineno] = literal(text, node.col_offset)
            continue
        assert isinstance(node, (ast.ClassDef, ast.FunctionDef))
        first = node.body[0]
        # "..." stands behind the colon
        head = lines[first.lineno - 1][:first.col_offset].rstrip()
        if has_docstring(first) or head:
            lines[first.lineno - 1:first.end_lineno] = ([head] if head else []) + literal(text, node.col_offset + 4)
        else:
            decorators = getattr(first, "decorator_list", [])
            begin = min(one.lineno for one in [first, *decorators]) - 1
            lines[begin:begin] = literal(text, node.col_offset + 4)
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    import ompl_certificates

    # getattr: the module itself is not for users.
    core = getattr(ompl_certificates, "_core")
    STUB.write_text(with_docstrings(STUB.read_text(encoding="utf-8"), core), encoding="utf-8")
