"""The stubs, the documentation and the module say the same."""

import ast
import inspect
import re
from pathlib import Path

import pointcore
import pytest

STUBS = Path(pointcore.__file__).with_name("__init__.pyi")
PAGE = Path(__file__).parents[3] / "docs" / "bindings.md"


def parameters(function):
    """Names of a stub's parameters, and how many of them have defaults."""
    arguments = function.args
    names = [argument.arg for argument in arguments.posonlyargs + arguments.args + arguments.kwonlyargs]
    defaults = len(arguments.defaults) + sum(default is not None for default in arguments.kw_defaults)
    return [name for name in names if name not in ("self", "cls")], defaults


def check(function, callable_):
    """Whether a stub's signature is that of what it stands for."""
    own = [one for one in inspect.signature(callable_).parameters.values() if one.name not in ("self", "cls")]
    given = [one.name for one in own], sum(one.default is not inspect.Parameter.empty for one in own)
    assert parameters(function) == given, function.name


def test_stubs_are_installed_and_say_what_the_module_has():
    assert STUBS.with_name("py.typed").exists()
    body = [node for node in ast.parse(STUBS.read_text()).body if isinstance(node, ast.ClassDef | ast.FunctionDef)]
    members = vars(pointcore).items()
    public = {name for name, value in members if not name.startswith("_") and not inspect.ismodule(value)}
    assert {node.name for node in body} == public
    checked = 0
    for node in body:
        own = getattr(pointcore, node.name)
        if isinstance(node, ast.FunctionDef):
            check(node, own)
            checked += 1
            continue
        members = [member for member in node.body if isinstance(member, ast.FunctionDef)]
        if not issubclass(own, Exception):
            hidden = {name for name in vars(own) if not name.startswith("_")}
            assert {member.name for member in members if not member.name.startswith("_")} == hidden, node.name
        for member in members:
            if member.name == "__new__":
                check(member, own)
                checked += 1
            elif not member.decorator_list and not member.name.startswith("_"):
                check(member, getattr(own, member.name))
                checked += 1
    assert checked > 8


@pytest.mark.skipif(not PAGE.exists(), reason="tested without the project around it")
def test_the_documented_examples_run(tmp_path, monkeypatch):
    examples = re.findall(r"```python\n(.*?)```", PAGE.read_text(), re.DOTALL)
    monkeypatch.chdir(tmp_path)
    own = [{} for _ in examples]
    for example, names in zip(examples, own, strict=True):
        exec(compile(example, str(PAGE), "exec"), names)
    generating, processing = own
    assert (tmp_path / "out" / "verilog" / "search_top.v").exists() and generating["found"].counts.all()
    assert processing["found"].valid.all() and processing["timed"].cycles and processing["timed"]["mean"] > 0.9
