"""Surface splatting, neighbor search and programs on neighborhoods, on generated hardware."""

from os import PathLike
from typing import Any, Literal, Sequence, final

import numpy as np
from numpy.typing import NDArray

# Arrays of any strides.
_Numbers = NDArray[np.float32] | NDArray[np.float64]
_Vector = Sequence[float]
_BackEnd = Literal["golden", "verilog"]
# The interpreter carries out programs alone.
_ProcessBackEnd = Literal["interpreter", "golden", "verilog"]
# By name: a number, a sequence of three, or an array.
_Named = dict[str, float | Sequence[float] | NDArray[Any]]

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
class Processed:
    """What left with queries, in their order; result["normal"] is result.outputs["normal"]."""

    @property
    def outputs(self) -> dict[str, NDArray[Any]]:
        """The outputs of the program, in its order: (queries,), vectors (queries, 3).

        Floats are float32, ints int32, bools bool. `position` and `mean` are float64, in the coordinates of the points.
        """
    @property
    def positions(self) -> NDArray[np.float64]:
        """Where the queries lie in the end, (queries, 3): the output `position`, or where they began without it."""
    @property
    def valid(self) -> NDArray[np.bool_] | None:
        """The output `valid`, (queries,): False where there is no surface, say; None of a program without it."""
    @property
    def capped(self) -> NDArray[np.bool_]:
        """Queries that were not done, but had no iteration left, (queries,)."""
    @property
    def iterations(self) -> NDArray[np.uint32]:
        """Iterations of each query, (queries,)."""
    @property
    def neighbors(self) -> NDArray[np.uint32] | None:
        """Neighbors of each query in its last iteration, (queries,); a point processor does not tell: None."""
    @property
    def cycles(self) -> int | None:
        """Cycles from the first query to the last result, of all programs and passes; None of the interpreter."""
    @property
    def report(self) -> dict[str, Any]:
        """The report's figures: where settings and fields come from, what each program took (`timings`)."""
    def __getitem__(self, name: str) -> NDArray[Any]:
        """An output; KeyError if there is none of the name."""

@final
class ProcessSession:
    """A program, and what carries it out: process() for one program after another cloud of points.

    A point processor is kept from call to call while the points call for the same hardware.
    """

    def __new__(
        cls,
        program: str | PathLike[str],
        *,
        backend: _ProcessBackEnd = "interpreter",
        lockstep: bool = False,
        config: str | None = None,
    ) -> ProcessSession: ...
    def process(
        self,
        points: _Numbers,
        k: int | None = None,
        radius: float | None = None,
        *,
        iterations: int = 16,
        passes: int = 1,
        queries: _Numbers | None = None,
        attributes: _Named | None = None,
        query_attributes: _Named | None = None,
        settings: _Named | None = None,
        pattern: tuple[int, int] | None = None,
    ) -> Processed:
        """Carries the program out for each point, or for each query; see the function process()."""

@final
class Scene:
    """A scene, ready to be rendered.

    Points are (N, 3), radii (N,) or one for all, normals (N, 3), colors sRGB from 0 to 1, (N, 3). Points without a normal
    face the eye. Without an eye or a direction the camera sees the whole scene from the side that shows most. With more
    than one frame it turns around the scene.

    Triangles, seen from both sides, hide what of the splats lies behind them, and are in the picture: vertices are (V, 3),
    faces whole numbers, (F, 3). Vertices without normals have the means of those of their faces; without colors they are
    white.
    """

    def __new__(
        cls,
        points: _Numbers,
        radii: _Numbers | float,
        normals: _Numbers | None = None,
        colors: _Numbers | None = None,
        *,
        two_sided: bool = False,
        vertices: _Numbers | None = None,
        faces: NDArray[np.integer[Any]] | None = None,
        vertex_normals: _Numbers | None = None,
        vertex_colors: _Numbers | None = None,
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

def process(
    points: _Numbers,
    program: str | PathLike[str],
    k: int | None = None,
    radius: float | None = None,
    *,
    iterations: int = 16,
    passes: int = 1,
    queries: _Numbers | None = None,
    attributes: _Named | None = None,
    query_attributes: _Named | None = None,
    settings: _Named | None = None,
    pattern: tuple[int, int] | None = None,
    backend: _ProcessBackEnd = "interpreter",
    lockstep: bool = False,
    config: str | None = None,
) -> Processed:
    """Carries a program on neighborhoods out for each point, or for each query (docs/programs.md).

    points: (N, 3), finite, in any unit of length; results are in the same.
    program: the name of an operation ("normals", "covariance", "mls", "apss", "smooth", "resample", "sph") or of one of
        its programs ("sph_density", "sph_forces"); the path of a .pasm file; or a text of several lines.
    k: neighbors of a query at most, 1 to 64, nearest first, itself among them; 16, or 64 where there is a radius.
    radius: only neighbors nearer than this count.
    iterations: of a query at most, 1 to 65535; one that is not done by then is capped.
    passes: how often the points are replaced by what leaves, 1 at least.
    queries: (M, 3), asked in the place of the points.
    attributes: what the program reads of each point, by name: (N,), of vectors (N, 3), or what all points share: a
        number, or three. Normals are made ones of length 1. Without them normals, areas and masses are estimated.
    query_attributes: what it reads of each query, (M,) or (M, 3), or what all share.
    settings: by name, a number or three; those that are not given follow from the points.
    pattern: columns and rows of queries around each point, for "resample"; (2, 2) without it.
    backend: "interpreter", the golden model of the program alone, has no cycles; "golden" is the model of the whole
        point processor, "verilog" its hardware, with lockstep compared with the model in every cycle.
    config: the point processor's configuration, TOML with the line `kind = "points"`; its program is replaced.

    InputError: no points, or one or an attribute that is not finite (both name the point); a shape, a name or a number
    that does not suit; a mistake in a program's text, with its line and column. FileError: a file that cannot be read.
    HardwareError: a tool is missing or fails, hardware and model differ.
    """

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
