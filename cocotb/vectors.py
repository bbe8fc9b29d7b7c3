"""What `pointcore vectors` wrote: a run of a core, and its answer."""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any


@dataclass(frozen=True)
class Packets:
    """Packets of one kind."""

    name: str
    packets: list[bytes]
    fields: dict[str, tuple[int, int]]

    @classmethod
    def load(cls, folder: Path, described: dict[str, Any]) -> "Packets":
        contents = (folder / described["file"]).read_bytes()
        size = described["packet_bytes"]
        packets = [contents[start : start + size] for start in range(0, len(contents), size)]
        assert len(packets) == described["packets"]
        fields = {field["name"]: (field["byte"], field["bytes"]) for field in described["fields"]}
        return cls(described["name"], packets, fields)

    def value(self, packet: bytes, field: str) -> int:
        """A field of a packet."""
        byte, count = self.fields[field]
        return int.from_bytes(packet[byte : byte + count], "little")


@dataclass(frozen=True)
class Region:
    """A part of the memory around a core, or what the host writes through a window."""

    port: str
    base: int
    contents: bytes

    @classmethod
    def load(cls, folder: Path, described: dict[str, Any]) -> "Region":
        file = described["file"]
        contents = (folder / file).read_bytes() if file else bytes(described["bytes"])
        assert len(contents) == described["bytes"]
        return cls(described["port"], described["base"], contents)


@dataclass(frozen=True)
class Vectors:
    """A run."""

    stream_bytes: int
    registers: dict[str, tuple[int, int]]
    send: Packets
    receive: Packets
    memory: list[Region]

    @classmethod
    def load(cls, folder: Path) -> "Vectors":
        described = json.loads((folder / "vectors.json").read_text())
        return cls(
            stream_bytes=described["stream_bits"] // 8,
            registers={
                register["name"]: (register["address"], register["value"]) for register in described["registers"]
            },
            send=Packets.load(folder, described["send"]),
            receive=Packets.load(folder, described["receive"]),
            memory=[Region.load(folder, region) for region in described["memory"]],
        )
