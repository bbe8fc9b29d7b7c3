"""Memory around a core: cocotbext-axi's slaves, whose answers can be spoilt."""

import random
from collections import Counter
from typing import Any

from cocotb.handle import HierarchyObject
from cocotbext.axi import AxiBus, AxiReadBus, AxiResp, AxiSlave, AxiSlaveRead
from vectors import Region

# Share of the answers that are spoilt.
SPOILT = 0.1


class Memory:
    """A region behind a port; accesses outside it are errors of the core, and answered so."""

    def __init__(self, dut: HierarchyObject, region: Region) -> None:
        self.region = region
        self.contents = bytearray(region.contents)
        # Writes that have not been answered yet: no read sees them.
        self.unanswered: list[tuple[slice, bytes]] = []
        self.slave: AxiSlave | AxiSlaveRead
        if hasattr(dut, f"{region.port}_awvalid"):
            self.slave = AxiSlave(AxiBus.from_prefix(dut, region.port), dut.clk, target=self)
            self.reads = self.slave.read_if
            before(self.slave.write_if.b_channel, self.store)
        else:
            self.slave = AxiSlaveRead(AxiReadBus.from_prefix(dut, region.port), dut.clk, target=self)
            self.reads = self.slave

    def place(self, address: int, length: int) -> slice:
        """Where an access lies among the contents."""
        start = address - self.region.base
        if not 0 <= start <= len(self.contents) - length:
            raise ValueError(f"{self.region.port}: {length} bytes at {address:#x} are outside the region")
        return slice(start, start + length)

    async def read(self, address: int, length: int) -> bytes:
        """Called by the slave."""
        return bytes(self.contents[self.place(address, length)])

    async def write(self, address: int, data: bytes) -> None:
        """Called by the slave."""
        self.unanswered.append((self.place(address, len(data)), data))

    def store(self, _answer: Any) -> None:
        """What has been written can be read when it is answered."""
        for place, data in self.unanswered:
            self.contents[place] = data
        self.unanswered.clear()

    def spoil(self, source: random.Random) -> Counter[str]:
        """Spoils answers at random from now on: data stays as it is, responses and ends of bursts do not. Counts what a core must count."""
        counts: Counter[str] = Counter()
        # Whether the burst under way has had its `rlast` misplaced: it counts once.
        misplaced = False

        def response() -> AxiResp:
            if source.random() >= SPOILT:
                return AxiResp.OKAY
            counts["memory_errors"] += 1
            return source.choice([AxiResp.SLVERR, AxiResp.DECERR])

        def spoil_beat(beat: Any) -> None:
            nonlocal misplaced
            beat.rresp = response()
            last = bool(beat.rlast)
            if source.random() < SPOILT:
                beat.rlast = not last
                misplaced = True
            if last:
                counts["burst_errors"] += misplaced
                misplaced = False

        def spoil_answer(answer: Any) -> None:
            answer.bresp = response()

        before(self.reads.r_channel, spoil_beat)
        if isinstance(self.slave, AxiSlave):
            before(self.slave.write_if.b_channel, spoil_answer)
        return counts


def before(channel: Any, change: Any) -> None:
    """Lets `change` have every transaction before `channel` sends it."""
    send = channel.send

    async def changed(transaction: Any) -> None:
        change(transaction)
        await send(transaction)

    channel.send = changed
