"""The window through which the host writes the search core's tree: what it refuses is answered, counted, and not written."""

from collections.abc import Iterator

import cocotb
from bursts import Burst, Bursts
from cocotb.handle import HierarchyObject
from cocotb.triggers import ClockCycles, Event
from cocotbext.axi import AxiBurstType, AxiResp
from host import SEEDS, SETTLE_CYCLES, TIMEOUT_MS, Control, Register
from searcher import LONGEST_BURST, WORD_BYTES, Searcher

IDS = 16
WRONG = 0xDEAD_BEEF_DEAD_BEEF
# What AXI gives a slave at least.
RANGE_BYTES = 4096
NARROW_SIZE = 2


class WindowHost(Searcher):
    """A host that writes the tree burst by burst."""

    def __init__(self, dut: HierarchyObject, seed: int) -> None:
        super().__init__(dut, seed)
        self.window = Bursts(dut, "s_axi")
        if seed:
            self.pause(self.window)

    def words(self, begin: int, count: int) -> list[int]:
        """Words of the tree."""
        starts = range(begin, min(begin + WORD_BYTES * count, len(self.tree)), WORD_BYTES)
        return [int.from_bytes(self.tree[start : start + WORD_BYTES], "little") for start in starts]

    def good_bursts(self) -> Iterator[Burst]:
        """The whole tree."""
        begin = 0
        while begin < len(self.tree):
            words = self.words(begin, self.random.randint(1, LONGEST_BURST))
            yield Burst(begin, words)
            begin += WORD_BYTES * len(words)

    def beyond(self) -> list[int]:
        """Addresses beyond the window, where it does not fill the range that it has."""
        end = len(self.tree)
        return [place for place in (end, 2 * end, RANGE_BYTES - 2 * WORD_BYTES) if end <= place < RANGE_BYTES]

    def refused_bursts(self) -> list[Burst]:
        """Bursts that a window refuses, whole or in a beat; what it would write otherwise spoils the tree."""
        end = len(self.tree)
        right = self.words(0, 4)
        return [
            Burst(0, [WRONG] * 4, burst=AxiBurstType.FIXED),
            Burst(0, [WRONG] * 4, burst=AxiBurstType.WRAP),
            Burst(0, [WRONG] * 4, size=NARROW_SIZE),
            Burst(0, [WRONG], size=0),
            Burst(WORD_BYTES // 2, [WRONG] * 2),
            Burst(end - WORD_BYTES, [WRONG] * 2),
            Burst(end - WORD_BYTES, [WRONG] * 256),
            *(Burst(beyond, [WRONG] * 2) for beyond in self.beyond()),
            Burst(0, [right[0], WRONG, right[2], WRONG], strobes={1: 0x7F, 3: 0}),
            Burst(0, [WRONG], strobes={0: 0xF0}),
            Burst(0, [right[0], WRONG, *right[2:]], misplaced=frozenset([1])),
            Burst(0, [*right[:3], WRONG], misplaced=frozenset([3])),
            Burst(0, [right[0], WRONG, right[2], WRONG], misplaced=frozenset([1, 3])),
        ]

    async def write_burst(self, burst: Burst, go_on: Event | None = None) -> AxiResp:
        """Under any id."""
        return await self.window.write(burst, self.random.randrange(IDS), go_on)


@cocotb.test(timeout_time=TIMEOUT_MS, timeout_unit="ms")
@cocotb.parametrize(seed=SEEDS)
async def refused_bursts_count_once_and_write_nothing(dut: HierarchyObject, seed: int) -> None:
    """Before and after the good ones, and between them reads."""
    host = await WindowHost.begin(dut, seed)
    await host.set_up()
    refused = 0
    for burst in host.good_bursts():
        assert await host.write_burst(burst) == AxiResp.OKAY
        for wrong in host.refused_bursts() if burst.address == 0 else []:
            assert await host.write_burst(wrong) == AxiResp.SLVERR, wrong
            refused += 1
        beats = host.random.choice([1, 3, 256])
        await host.window.read(burst.address, beats, host.random.randrange(IDS))
        refused += 1
    assert await host.errors() == {"burst_errors": refused}
    host.send(host.vectors.send.packets)
    await host.start()
    await host.receive_results()
    assert await host.errors() == {"burst_errors": refused}


@cocotb.test(timeout_time=TIMEOUT_MS, timeout_unit="ms")
@cocotb.parametrize(seed=SEEDS)
async def the_tree_is_locked_during_a_run(dut: HierarchyObject, seed: int) -> None:
    """And no run starts during a burst."""
    host = await WindowHost.begin(dut, seed)
    await host.set_up()
    [first, *rest] = host.good_bursts()
    go_on = Event()
    under_way = cocotb.start_soon(host.write_burst(first, go_on))
    await ClockCycles(dut.clk, SETTLE_CYCLES)
    await host.refused(Register.CONTROL, Control.START)
    go_on.set()
    assert await under_way == AxiResp.OKAY
    for burst in rest:
        assert await host.write_burst(burst) == AxiResp.OKAY
    await host.start()
    wrong = Burst(0, [WRONG] * 8)
    assert await host.write_burst(wrong) == AxiResp.SLVERR
    # What is wrong in itself counts as such.
    assert await host.write_burst(Burst(0, [WRONG], size=NARROW_SIZE)) == AxiResp.SLVERR
    host.send(host.vectors.send.packets)
    await host.receive_results()
    assert await host.errors() == {"busy_errors": 2, "burst_errors": 1}
