"""The register map of either core: what it holds, what it refuses, and that refused accesses change nothing."""

import random

import cocotb
from cocotb.handle import HierarchyObject
from cocotbext.axi import AxiResp
from host import ERRORS, SEEDS, TIMEOUT_MS, Control, Host, Register

# "PC", the core, version 1.
IDENTITY = {"splat_axi": 0x5043_0A01, "search_axi": 0x5043_0B01}
READ_ONLY = [Register.ID, Register.STATUS, *ERRORS, Register.CYCLES, Register.PACKETS_IN, Register.EVENTS]
OUTSIDE = [0x030, 0x03C, 0x07C, 0x0FC, 0x1FC, 0xFFC]
BASE = 0x1234_5000
WORD = (0xFFFF_FFFF).to_bytes(4, "little")


@cocotb.test(timeout_time=TIMEOUT_MS, timeout_unit="ms")
@cocotb.parametrize(seed=SEEDS)
async def registers_hold_what_is_written(dut: HierarchyObject, seed: int) -> None:
    """And begin with what the map says."""
    host = await Host.begin(dut, seed)
    assert await host.read(Register.ID) == IDENTITY[dut._name]
    for register in [
        Register.STATUS,
        Register.INTERRUPT_ENABLE,
        *ERRORS,
        Register.CYCLES,
        Register.EVENTS,
        Register.BASE,
    ]:
        assert await host.read(register) == 0, register.name
    await host.write(Register.BASE, BASE)
    await host.write(Register.INTERRUPT_ENABLE, 1)
    assert await host.read(Register.BASE) == BASE
    assert await host.read(Register.INTERRUPT_ENABLE) == 1
    assert not dut.irq.value, "no run has ended"
    assert await host.errors() == {}


@cocotb.test(timeout_time=TIMEOUT_MS, timeout_unit="ms")
@cocotb.parametrize(seed=SEEDS)
async def refused_accesses_count_once_and_change_nothing(dut: HierarchyObject, seed: int) -> None:
    """Reads and writes in random order, several at a time."""
    host = await Host.begin(dut, seed)
    await host.write(Register.BASE, BASE)
    writes = [(address, WORD) for address in [*READ_ONLY, *OUTSIDE]]
    # Not whole words, words that are not aligned, and a base that is no multiple of 4,096.
    writes += [(Register.BASE + offset, WORD[:count]) for offset, count in [(0, 1), (0, 3), (1, 3), (2, 2), (3, 1)]]
    writes += [(Register.BASE, (BASE + 8).to_bytes(4, "little"))]
    # A partial word even to `control`, whose start would be refused otherwise.
    writes += [(Register.CONTROL, bytes([Control.CLEAR_ERRORS]))]
    reads = [
        (Register.CONTROL, 4),
        (Register.BASE + 1, 1),
        (Register.ID + 2, 2),
        *((address, 4) for address in OUTSIDE),
    ]
    if dut._name == "search_axi":
        # A start without queries.
        writes += [(Register.CONTROL, bytes([Control.START, 0, 0, 0]))]
    else:
        reads += [(0x100, 4)]
    source = random.Random(seed)
    source.shuffle(writes)
    source.shuffle(reads)
    answers = [cocotb.start_soon(host.try_write(address, data)) for address, data in writes]
    refused = [cocotb.start_soon(host.try_read(address, count)) for address, count in reads]
    for (address, _), answer in zip(writes, answers):
        assert await answer == AxiResp.SLVERR, f"write to {address:#05x}"
    for (address, count), answer in zip(reads, refused):
        assert await answer == (AxiResp.SLVERR, bytes(count)), f"read of {address:#05x}"
    assert await host.errors() == {"access_errors": len(writes) + len(reads)}
    assert await host.read(Register.BASE) == BASE
    assert await host.read(Register.STATUS) == 4, "nothing was started"
    await host.write(Register.CONTROL, Control.CLEAR_ERRORS)
    assert await host.errors() == {}
