"""The host's side of a core on AXI, as docs/interfaces.md describes it."""

import logging
import os
import random
import re
from collections.abc import Iterator
from enum import IntEnum, IntFlag
from pathlib import Path
from typing import Any, Self

import cocotb
from cocotb.clock import Clock
from cocotb.handle import HierarchyObject
from cocotb.triggers import ClockCycles, ReadOnly, RisingEdge
from cocotbext.axi import (
    AxiLiteBus,
    AxiLiteMaster,
    AxiResp,
    AxiStreamBus,
    AxiStreamFrame,
    AxiStreamSink,
    AxiStreamSource,
)
from memory import Memory
from vectors import Vectors

CLOCK_NS = 10
RESET_CYCLES = 4
# Cycles in which anything still under way would have come out.
SETTLE_CYCLES = 200
# Side, channel, and signal of a port.
PORT = re.compile(r"([sm])_axi\w*_(aw|w|b|ar|r|t)([a-z]+)")
# Ten times what the longest test takes.
TIMEOUT_MS = 1

# Seed 0 pauses nothing.
SEEDS = [int(seed) for seed in os.environ["SEEDS"].split()]


class Register(IntEnum):
    """Addresses that both cores have."""

    ID = 0x000
    CONTROL = 0x004
    STATUS = 0x008
    INTERRUPT_ENABLE = 0x00C
    ACCESS_ERRORS = 0x010
    BUSY_ERRORS = 0x014
    BURST_ERRORS = 0x018
    PACKET_ERRORS = 0x01C
    MEMORY_ERRORS = 0x020
    CYCLES = 0x024
    PACKETS_IN = 0x028
    PACKETS_OUT = 0x02C
    EVENTS = 0x040
    # The renderer's buffer, the search core's points.
    BASE = 0x080


ERRORS = [
    Register.ACCESS_ERRORS,
    Register.BUSY_ERRORS,
    Register.BURST_ERRORS,
    Register.PACKET_ERRORS,
    Register.MEMORY_ERRORS,
]


class Control(IntFlag):
    """Bits of `control`."""

    START = 1
    RESET = 2
    CLEAR_ERRORS = 4
    ABORT = 8


class Status(IntFlag):
    """Bits of `status`."""

    BUSY = 1
    DONE = 2
    ERROR = 4
    WAITING = 8


class Host:
    """A core with its driver and its memory; every channel pauses at random, unless the seed is 0."""

    @classmethod
    async def begin(cls, dut: HierarchyObject, seed: int) -> Self:
        """Resets the core, and gives it its surroundings."""
        cocotb.start_soon(Clock(dut.clk, CLOCK_NS, unit="ns").start())
        dut.rst.value = 1
        inputs, outputs = ports(dut)
        for handle in inputs:
            handle.value = 0
        await ClockCycles(dut.clk, RESET_CYCLES)
        assert not any(output.value for output in outputs if output._name.endswith("valid")), "valid during reset"
        dut.rst.value = 0
        await ClockCycles(dut.clk, 1)
        host = cls(dut, seed)
        host.fill_payloads()
        return host

    def __init__(self, dut: HierarchyObject, seed: int) -> None:
        # The bus models tell of every transaction.
        logging.getLogger(f"cocotb.{dut._name}").setLevel(logging.WARNING)
        self.dut = dut
        self.random = random.Random(seed)
        self.vectors = Vectors.load(Path(os.environ["VECTORS"]))
        send, receive = self.vectors.send.name, self.vectors.receive.name
        self.registers = AxiLiteMaster(AxiLiteBus.from_prefix(dut, "s_axil"), dut.clk)
        self.source = AxiStreamSource(AxiStreamBus.from_prefix(dut, f"s_axis_{send}"), dut.clk)
        self.sink = AxiStreamSink(AxiStreamBus.from_prefix(dut, f"m_axis_{receive}"), dut.clk)
        regions = [region for region in self.vectors.memory if region.port.startswith("m_axi")]
        self.memories = [Memory(dut, region) for region in regions]
        if seed:
            self.pause(self.source, self.sink, self.registers, *(memory.slave for memory in self.memories))

    def pause(self, *interfaces: Any) -> None:
        """Lets every channel pause at random, each in a share of the cycles of its own."""
        for interface in interfaces:
            for channel in channels(interface):
                share = self.random.choice([0.0, 0.1, 0.3, 0.6])
                channel.set_pause_generator(pauses(share, self.random.random()))

    def fill_payloads(self) -> None:
        """Gives signals that count only with `valid` any value; the bus models leave them X until something is sent."""
        for handle in ports(self.dut)[0]:
            if not handle._name.endswith(("valid", "ready")):
                handle.value = self.random.getrandbits(len(handle))

    async def try_write(self, address: int, data: bytes) -> AxiResp:
        """Writes bytes of a word."""
        return (await self.registers.write(address, data)).resp

    async def try_read(self, address: int, count: int = 4) -> tuple[AxiResp, bytes]:
        """Reads bytes of a word."""
        answer = await self.registers.read(address, count)
        return answer.resp, answer.data

    async def write(self, address: int, value: int) -> None:
        """Writes a register."""
        assert await self.try_write(address, value.to_bytes(4, "little")) == AxiResp.OKAY, f"write to {address:#05x}"

    async def read(self, address: int) -> int:
        """Reads a register."""
        response, data = await self.try_read(address)
        assert response == AxiResp.OKAY, f"read of {address:#05x}"
        return int.from_bytes(data, "little")

    async def refused(self, address: int, value: int) -> None:
        """Writes to a register that must refuse it."""
        assert await self.try_write(address, value.to_bytes(4, "little")) == AxiResp.SLVERR, f"write to {address:#05x}"

    async def errors(self) -> dict[str, int]:
        """The error counters that are not zero."""
        counts = {register.name.lower(): await self.read(register) for register in ERRORS}
        status = await self.read(Register.STATUS)
        assert bool(status & Status.ERROR) == any(counts.values())
        return {name: count for name, count in counts.items() if count}

    async def set_up(self) -> None:
        """Writes the run's registers, in any order."""
        writes = list(self.vectors.registers.values())
        self.random.shuffle(writes)
        for address, value in writes:
            await self.write(address, value)

    def send(self, packets: list[bytes]) -> None:
        """Sends packets as soon as the core takes them."""
        for packet in packets:
            self.source.send_nowait(AxiStreamFrame(packet))

    async def start(self) -> None:
        """Begins a run."""
        await self.write(Register.CONTROL, Control.START)

    async def abort_part(self) -> None:
        """Begins a run, sends a part of what it needs, and ends it somewhere on its way."""
        await self.start()
        packets = self.vectors.send.packets
        self.send(packets[: self.random.randrange(len(packets))])
        while not self.source.idle():
            await ClockCycles(self.dut.clk, 1)
        await ClockCycles(self.dut.clk, self.random.randrange(SETTLE_CYCLES))
        await self.write(Register.CONTROL, Control.ABORT)
        while await self.read(Register.STATUS) & Status.BUSY:
            pass
        assert await self.read(Register.STATUS) & Status.DONE
        while not self.sink.empty():
            self.sink.recv_nowait()

    async def receive(self, count: int) -> list[bytes]:
        """The next packets from the core."""
        return [bytes((await self.sink.recv()).tdata) for _ in range(count)]

    async def finish(self, times: int = 1) -> None:
        """Waits for the end of a run whose packets have been sent so many times, and received, and checks what it counted."""
        if await self.read(Register.INTERRUPT_ENABLE):
            await ReadOnly()
            if not self.dut.irq.value:
                await RisingEdge(self.dut.irq)
            await RisingEdge(self.dut.clk)
        while await self.read(Register.STATUS) & Status.BUSY:
            pass
        assert await self.read(Register.STATUS) & Status.DONE
        await ClockCycles(self.dut.clk, SETTLE_CYCLES)
        assert self.sink.empty(), "packets after the end of the run"
        assert self.source.idle(), "packets that were not taken"
        packets = times * len(self.vectors.send.packets)
        assert await self.read(Register.PACKETS_IN) == packets
        cycles = await self.read(Register.CYCLES)
        assert cycles >= packets
        assert cycles == await self.read(Register.CYCLES), "cycles are counted after the run"


def pauses(share: float, seed: float) -> Iterator[bool]:
    """Whether to pause, cycle by cycle."""
    source = random.Random(seed)
    while True:
        yield source.random() < share


def channels(interface: Any) -> Iterator[Any]:
    """The channels of a bus model."""
    halves = [getattr(interface, half) for half in ("write_if", "read_if") if hasattr(interface, half)] or [interface]
    names = ["aw_channel", "w_channel", "b_channel", "ar_channel", "r_channel"]
    for half in halves:
        found = [getattr(half, name) for name in names if hasattr(half, name)]
        yield from found or [half]


def ports(dut: HierarchyObject) -> tuple[list[Any], list[Any]]:
    """The signals of the buses that are inputs, and those that are outputs."""
    inputs, outputs = [], []
    for handle in dut:
        if matched := PORT.fullmatch(handle._name):
            side, channel, signal = matched.groups()
            from_master = (channel in ("aw", "w", "ar", "t")) != (signal == "ready")
            (inputs if from_master == (side == "s") else outputs).append(handle)
    return inputs, outputs
