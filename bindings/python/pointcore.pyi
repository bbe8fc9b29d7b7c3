"""Surface splatting and neighbor search on generated hardware."""

from os import PathLike
from typing import Any, Literal, Sequence, final

import numpy as np
from numpy.typing import NDArray

# Arrays of any strides.
_Numbers = NDArray[np.float32] | NDArray[np.float64]
_Vector = Sequence[float]
_BackEnd = Literal["golden", "verilog"]

__version__: str

class InputError(ValueError):
    """What was given makes no sense."""

class FileError(OSError):
    """A file cannot be read or written."""

class HardwareError(RuntimeError):
    """The hardware could not be generated, built or run, a tool is missing, or hardware and model differ."""

class InternalError(RuntimeError):
    """A fault of pointcore itself."""

@final
class Found:
    """Neighbors of some queries."""

    @property
    def indices(self) -> NDArray[np.int64]:
        """Indices of points, (queries, k), nearest first; -1 where there are fewer."""
    @property
    def distances2(self) -> NDArray[np.float32]:
        """Squared distances, (queries, k), as the core rounds them; infinite where there is no neighbor."""
    @property
    def counts(self) -> NDArray[np.uint32]:
        """Neighbors of each query, (queries,)."""
    @property
    def cycles(self) -> int:
        """Cycles from the first query to the last neighbor."""

@final
class SearchSession:
    """Points in a tree, and a core that searches it for up to k neighbors of each query."""

    def __new__(
        cls,
        points: _Numbers,
        k: int = 10,
        *,
        backend: _BackEnd = "golden",
        lockstep: bool = False,
        config: str | Plan | None = None,
    ) -> SearchSession: ...
    def search(self, queries: _Numbers, k: int | None = None, radius: float | None = None) -> Found:
        """The nearest k neighbors of each query, or those of them within a radius."""

@final
class Scene:
    """A scene, ready to be rendered.

    Points are (N, 3), radii (N,) or one for all, normals (N, 3), colors sRGB from 0 to 1, (N, 3). Points without a normal
    face the eye. Without an eye or a direction the camera sees the whole scene from the side that shows most. With more
    than one frame it turns around the scene.
    """

    def __new__(
        cls,
        points: _Numbers,
        radii: _Numbers | float,
        normals: _Numbers | None = None,
        colors: _Numbers | None = None,
        *,
        two_sided: bool = False,
        width: int = 512,
        height: int = 512,
        background: _Vector = (0.0, 0.0, 0.0),
        eye: _Vector | None = None,
        target: _Vector | None = None,
        fov_degrees: float | None = None,
        direction: _Vector | None = None,
        up: _Vector | None = None,
        frames: int = 1,
    ) -> Scene: ...
    @staticmethod
    def load(path: str | PathLike[str]) -> Scene:
        """Loads a scene file, or a model that a camera fits."""
    def __len__(self) -> int:
        """Splats in it."""

@final
class Frame:
    """A frame: arrays of its samples, one a pixel unless a scene file asks for more."""

    @property
    def color(self) -> NDArray[np.float32]:
        """Linear RGB of the surface, (height, width, 3), not shaded; zero where there is none."""
    @property
    def depth(self) -> NDArray[np.float32]:
        """Distance from the eye's plane, (height, width); infinite where there is no surface."""
    @property
    def normal(self) -> NDArray[np.float32]:
        """World-space normal, (height, width, 3), of a length up to one; zero where there is no surface."""
    @property
    def mask(self) -> NDArray[np.bool_]:
        """Whether there is a surface, (height, width)."""
    @property
    def picture(self) -> NDArray[np.uint8]:
        """The shaded picture on its background, sRGB, (height, width, 3)."""
    @property
    def cycles(self) -> int:
        """Cycles from the first splat to the end of the frame."""
    @property
    def report(self) -> dict[str, Any]:
        """The report's figures."""

@final
class RenderSession:
    """A scene, and the core that renders it."""

    def __new__(
        cls,
        scene: Scene,
        *,
        backend: _BackEnd = "golden",
        lockstep: bool = False,
        config: str | Plan | None = None,
    ) -> RenderSession: ...
    def __len__(self) -> int:
        """Frames of the scene's sequence."""
    def frame(self, index: int = 0) -> Frame:
        """Renders a frame of the sequence, which counts from 0."""

@final
class Plan:
    """Hardware that something calls for; str() is its text."""

    @property
    def text(self) -> str:
        """What was chosen and why, and what it takes, for people."""
    @property
    def toml(self) -> str:
        """The hardware's configuration as TOML."""

def search(
    points: _Numbers,
    queries: _Numbers,
    k: int = 10,
    radius: float | None = None,
    *,
    backend: _BackEnd = "golden",
    lockstep: bool = False,
    config: str | Plan | None = None,
) -> Found:
    """The nearest k points of each query, or those of them within a radius."""

def render(
    scene: Scene,
    *,
    backend: _BackEnd = "golden",
    lockstep: bool = False,
    config: str | Plan | None = None,
) -> Frame:
    """Renders a scene's first frame."""

def plan(what: Scene | _Numbers, k: int = 10) -> Plan:
    """Plans the renderer for a scene, or the search core for points and up to k neighbors of each query."""

def generate(config: str | Plan, folder: str | PathLike[str], name: str = "pointcore") -> list[str]:
    """Writes the Verilog of a configuration and what goes with it into a folder; returns the files' paths."""
