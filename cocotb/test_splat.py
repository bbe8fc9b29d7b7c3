"""Frames through the renderer on AXI: the golden model's, bit for bit, whatever the bus does."""

import cocotb
from cocotb.handle import HierarchyObject
from cocotb.triggers import ClockCycles
from cocotbext.axi import AxiResp
from host import SEEDS, SETTLE_CYCLES, TIMEOUT_MS, Control, Host, Register, Status

FIRST_UNIFORM = 0x100


async def receive_frame(host: Host, frames: int = 1) -> None:
    """Receives a run's frames, which are all the same, compares them, and sees the run end."""
    expected = host.vectors.receive
    for _ in range(frames):
        received = await host.receive(len(expected.packets))
        # Tiles come in any order, and of the last packet only `end` counts.
        assert sorted(received[:-1]) == sorted(expected.packets[:-1])
        assert [expected.value(packet, "end") for packet in received[-2:]] == [0, 1]
    await host.finish(frames)
    assert await host.read(Register.PACKETS_OUT) == frames * len(expected.packets)


async def begun(host: Host) -> None:
    """Sees a start's frame begin."""
    while await host.read(Register.STATUS) & Status.WAITING:
        pass


@cocotb.test(timeout_time=TIMEOUT_MS, timeout_unit="ms")
@cocotb.parametrize(seed=SEEDS)
async def frames_are_the_models(dut: HierarchyObject, seed: int) -> None:
    """Two frames without a reset between them; splats wait for the start."""
    host = await Host.begin(dut, seed)
    await host.set_up()
    await host.write(Register.INTERRUPT_ENABLE, 1)
    for _ in range(2):
        host.send(host.vectors.send.packets)
        await ClockCycles(dut.clk, SETTLE_CYCLES)
        assert not dut.s_axis_splat_tready.value, "splats are taken only during a run"
        await host.start()
        await ClockCycles(dut.clk, 2)
        assert not dut.irq.value, "a start clears `done`"
        await receive_frame(host)
        assert dut.irq.value
        # Samples are evaluated and accumulated in every frame.
        assert await host.read(Register.EVENTS) > 0
        assert await host.errors() == {}


@cocotb.test(timeout_time=TIMEOUT_MS, timeout_unit="ms")
@cocotb.parametrize(seed=SEEDS[-1:])
async def frames_follow_each_other(dut: HierarchyObject, seed: int) -> None:
    """Each is started while the one before is drawn, which what is written then does not disturb."""
    host = await Host.begin(dut, seed)
    await host.set_up()
    for _ in range(3):
        await host.start()
        host.send(host.vectors.send.packets)
        await begun(host)
        await host.write(FIRST_UNIFORM, host.random.getrandbits(32))
        assert await host.try_write(Register.BASE, bytes(4)) == AxiResp.SLVERR, "a run is under way"
        for address, value in host.vectors.registers.values():
            if address >= FIRST_UNIFORM:
                await host.write(address, value)
    await receive_frame(host, frames=3)
    assert await host.errors() == {"busy_errors": 3}


@cocotb.test(timeout_time=TIMEOUT_MS, timeout_unit="ms")
@cocotb.parametrize(seed=SEEDS[-1:])
async def a_running_core_refuses_what_would_disturb_it(dut: HierarchyObject, seed: int) -> None:
    """Starts, resets, uniforms and bases while a start waits, and broken packets between the good ones."""
    host = await Host.begin(dut, seed)
    await host.set_up()
    await host.start()
    await begun(host)
    await host.start()
    beat = host.vectors.stream_bytes
    broken = 0
    *splats, end = host.vectors.send.packets
    for splat in splats:
        if host.random.random() < 0.3:
            # The end of a frame, too, if it is broken.
            packet = host.random.choice([splat, end])
            short = packet[: beat * host.random.randrange(len(packet) // beat)]
            long = packet + bytes(beat * host.random.randint(1, 3))
            host.send([short or long])
            host.send([long])
            broken += 2
        host.send([splat])
    refusals = [
        (Register.CONTROL, Control.START),
        (Register.CONTROL, Control.RESET),
        (Register.CONTROL, Control.START | Control.CLEAR_ERRORS),
        (Register.BASE, 0),
        (FIRST_UNIFORM, 0),
        (FIRST_UNIFORM + 4 * 22, 0),
    ]
    for address, value in refusals:
        await host.refused(address, value)
    assert await host.read(Register.STATUS) == Status.BUSY | Status.ERROR | Status.WAITING
    host.send([end, *splats, end])
    await receive_frame(host, frames=2)
    assert await host.errors() == {"busy_errors": len(refusals), "packet_errors": broken}


@cocotb.test(timeout_time=TIMEOUT_MS, timeout_unit="ms")
@cocotb.parametrize(seed=SEEDS)
async def an_aborted_run_leaves_nothing_behind(dut: HierarchyObject, seed: int) -> None:
    """Frames that lack their end are ended; the next one is the model's."""
    host = await Host.begin(dut, seed)
    await host.set_up()
    for _ in range(3):
        await host.abort_part()
    host.send(host.vectors.send.packets)
    await host.start()
    await receive_frame(host)
    assert await host.errors() == {}


@cocotb.test(timeout_time=TIMEOUT_MS, timeout_unit="ms")
@cocotb.parametrize(seed=SEEDS[-1:])
async def spoilt_answers_are_counted(dut: HierarchyObject, seed: int) -> None:
    """The data of an answer with an error is used as it came: here it is right."""
    host = await Host.begin(dut, seed)
    await host.set_up()
    # Of what happens without a run, nothing may stay.
    await host.write(Register.CONTROL, Control.RESET)
    await host.set_up()
    expected = host.memories[0].spoil(host.random)
    host.send(host.vectors.send.packets)
    await host.start()
    await receive_frame(host)
    assert expected["memory_errors"] and expected["burst_errors"], "nothing was spoilt"
    assert await host.errors() == expected
    await host.write(Register.CONTROL, Control.CLEAR_ERRORS)
    assert await host.errors() == {}
