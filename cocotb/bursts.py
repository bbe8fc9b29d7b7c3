"""A small AXI4 master for bursts that no library's master makes."""

from dataclasses import dataclass, field

from cocotb.handle import HierarchyObject
from cocotb.triggers import Event
from cocotbext.axi import AxiBurstType, AxiReadBus, AxiResp, AxiWriteBus
from cocotbext.axi.axi_channels import (
    AxiARSource,
    AxiARTransaction,
    AxiAWSource,
    AxiAWTransaction,
    AxiBSink,
    AxiRSink,
    AxiWSource,
    AxiWTransaction,
)

WORD_BYTES = 8
WORD_SIZE = 3
ALL_STROBES = 0xFF


@dataclass(frozen=True)
class Burst:
    """A write burst, as it should be unless told otherwise."""

    address: int
    words: list[int]
    burst: AxiBurstType = AxiBurstType.INCR
    size: int = WORD_SIZE
    # Strobes of beats that are not all set.
    strobes: dict[int, int] = field(default_factory=dict)
    # Beats whose `wlast` is the opposite of what it should be.
    misplaced: frozenset[int] = frozenset()


class Bursts:
    """The write and read channels of a port."""

    def __init__(self, dut: HierarchyObject, port: str) -> None:
        write, read = AxiWriteBus.from_prefix(dut, port), AxiReadBus.from_prefix(dut, port)
        self.aw_channel = AxiAWSource(write.aw, dut.clk)
        self.w_channel = AxiWSource(write.w, dut.clk)
        self.b_channel = AxiBSink(write.b, dut.clk)
        self.ar_channel = AxiARSource(read.ar, dut.clk)
        self.r_channel = AxiRSink(read.r, dut.clk)

    async def write(self, burst: Burst, number: int, go_on: Event | None = None) -> AxiResp:
        """Sends a burst, its data when told to go on, and waits for its answer, which must bear its number."""
        length = len(burst.words) - 1
        address = AxiAWTransaction(
            awid=number, awaddr=burst.address, awlen=length, awsize=burst.size, awburst=burst.burst
        )
        await self.aw_channel.send(address)
        if go_on:
            await go_on.wait()
        for beat, word in enumerate(burst.words):
            last = (beat == length) != (beat in burst.misplaced)
            strobes = burst.strobes.get(beat, ALL_STROBES)
            await self.w_channel.send(AxiWTransaction(wdata=word, wstrb=strobes, wlast=last))
        answer = await self.b_channel.recv()
        assert answer.bid == number
        return AxiResp(int(answer.bresp))

    async def read(self, address: int, beats: int, number: int) -> None:
        """Reads, which the window does not let: every beat is 0 and an error."""
        request = AxiARTransaction(
            arid=number, araddr=address, arlen=beats - 1, arsize=WORD_SIZE, arburst=AxiBurstType.INCR
        )
        await self.ar_channel.send(request)
        for beat in range(beats):
            answer = await self.r_channel.recv()
            found = (int(answer.rid), int(answer.rdata), int(answer.rresp), int(answer.rlast))
            assert found == (number, 0, AxiResp.SLVERR, int(beat == beats - 1))
