"""Searches through the search core on AXI: the golden model's neighbors, whatever the bus does."""

from collections import Counter

import cocotb
from cocotb.handle import HierarchyObject
from cocotb.triggers import ClockCycles
from host import SEEDS, SETTLE_CYCLES, TIMEOUT_MS, Control, Register, Status
from searcher import Searcher

QUERIES = 0x088


@cocotb.test(timeout_time=TIMEOUT_MS, timeout_unit="ms")
@cocotb.parametrize(seed=SEEDS)
async def neighbors_are_the_models(dut: HierarchyObject, seed: int) -> None:
    """Two searches without a reset between them; queries wait for the start."""
    host = await Searcher.begin(dut, seed)
    await host.write_tree()
    await host.set_up()
    await host.write(Register.INTERRUPT_ENABLE, 1)
    for _ in range(2):
        host.send(host.vectors.send.packets)
        await ClockCycles(dut.clk, SETTLE_CYCLES)
        assert not dut.s_axis_query_tready.value, "queries are taken only during a run"
        await host.start()
        await ClockCycles(dut.clk, 2)
        assert not dut.irq.value, "a start clears `done`"
        cached = await host.receive_results()
        assert bool(cached) == host.has_neighbor_cache
        assert dut.irq.value
        assert await host.errors() == {}


@cocotb.test(timeout_time=TIMEOUT_MS, timeout_unit="ms")
@cocotb.parametrize(seed=SEEDS[-1:])
async def a_running_core_refuses_what_would_disturb_it(dut: HierarchyObject, seed: int) -> None:
    """Starts, resets and settings during a search, and broken packets between the good ones."""
    host = await Searcher.begin(dut, seed)
    await host.write_tree()
    await host.set_up()
    await host.start()
    beat = host.vectors.stream_bytes
    byte, count = host.vectors.send.fields["k"]
    broken = 0
    for query in host.vectors.send.packets[:-1]:
        if host.random.random() < 0.5:
            host.send([query + bytes(beat * host.random.randint(1, 3))])
            # Of no neighbor, and of more than any queue holds.
            host.send([query[:byte] + bytes([k] * count) + query[byte + count :] for k in (0, 255)])
            broken += 3
        if len(query) > beat and host.random.random() < 0.5:
            host.send([query[: beat * host.random.randrange(1, len(query) // beat)]])
            broken += 1
        host.send([query])
    refusals = [
        (Register.CONTROL, Control.START),
        (Register.CONTROL, Control.RESET),
        (Register.CONTROL, Control.START | Control.CLEAR_ERRORS),
        (Register.BASE, 0),
        (QUERIES, 1),
    ]
    for address, value in refusals:
        await host.refused(address, value)
    assert await host.read(Register.STATUS) == Status.BUSY | Status.ERROR
    host.send(host.vectors.send.packets[-1:])
    await host.receive_results()
    assert await host.errors() == {"busy_errors": len(refusals), "packet_errors": broken}


@cocotb.test(timeout_time=TIMEOUT_MS, timeout_unit="ms")
@cocotb.parametrize(seed=SEEDS)
async def an_aborted_run_leaves_nothing_behind(dut: HierarchyObject, seed: int) -> None:
    """Runs that lack queries are ended; the next one finds what there is to find."""
    host = await Searcher.begin(dut, seed)
    await host.write_tree()
    await host.set_up()
    for _ in range(3):
        await host.abort_part()
    host.send(host.vectors.send.packets)
    await host.start()
    await host.receive_results()
    assert await host.errors() == {}


@cocotb.test(timeout_time=TIMEOUT_MS, timeout_unit="ms")
@cocotb.parametrize(seed=SEEDS[-1:])
async def spoilt_answers_are_counted(dut: HierarchyObject, seed: int) -> None:
    """The data of an answer with an error is used as it came: here it is right. A reset afterwards empties the caches."""
    host = await Searcher.begin(dut, seed)
    await host.write_tree()
    await host.set_up()
    counts = [memory.spoil(host.random) for memory in host.memories]
    for _ in range(2):
        host.send(host.vectors.send.packets)
        await host.start()
        await host.receive_results()
        expected = sum(counts, Counter())
        assert expected["memory_errors"] and expected["burst_errors"], "nothing was spoilt"
        assert await host.errors() == expected
        await host.write(Register.CONTROL, Control.RESET | Control.CLEAR_ERRORS)
        assert await host.errors() == {}
        for spoilt in counts:
            spoilt.clear()
