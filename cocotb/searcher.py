"""A search core with its driver."""

from cocotb.handle import HierarchyObject
from cocotbext.axi import AxiBus, AxiMaster, AxiResp
from host import Host, channels

WORD_BYTES = 8
LONGEST_BURST = 40


class Searcher(Host):
    """A search core, with its tree behind a window or in memory."""

    def __init__(self, dut: HierarchyObject, seed: int) -> None:
        super().__init__(dut, seed)
        windows = [region.contents for region in self.vectors.memory if region.port == "s_axi"]
        self.tree = windows[0] if windows else b""
        self.has_neighbor_cache = "cache_ball" in self.vectors.registers

    async def write_tree(self) -> None:
        """Writes the tree, where the core keeps it, in bursts of any length."""
        if not self.tree:
            return
        master = AxiMaster(AxiBus.from_prefix(self.dut, "s_axi"), self.dut.clk)
        self.pause(master)
        self.fill_payloads()
        begin = 0
        while begin < len(self.tree):
            end = begin + WORD_BYTES * self.random.randint(1, LONGEST_BURST)
            answer = await master.write(begin, self.tree[begin:end])
            assert answer.resp == AxiResp.OKAY
            begin = end
        for channel in channels(master):
            channel.clear_pause_generator()

    def result(self, packet: bytes, field: str) -> int:
        """A field of a result."""
        return self.vectors.receive.value(packet, field)

    async def receive_results(self) -> int:
        """Receives what there must be, compares it, and sees the run end; returns how many results came from the neighbor cache."""
        count = len(self.vectors.send.packets)
        received: list[list[bytes]] = [[] for _ in range(count)]
        answered = 0
        while answered < count:
            [result] = await self.receive(1)
            received[self.result(result, "number")].append(result)
            answered += self.result(result, "last")
        expected: list[list[bytes]] = [[] for _ in range(count)]
        for result in self.vectors.receive.packets:
            expected[self.result(result, "number")].append(result)
        if self.has_neighbor_cache:
            for number in range(count):
                self.compare_neighborhood(received[number], expected[number])
        else:
            assert received == expected
        await self.finish()
        results = [result for results in received for result in results]
        assert await self.read(0x02C) == len(results)
        return sum(self.result(result, "cached") for result in results) if self.has_neighbor_cache else 0

    def compare_neighborhood(self, received: list[bytes], expected: list[bytes]) -> None:
        """A neighbor cache has the core answer with more than is wanted, and where it answers itself, with another query's distances."""
        neighbors = [self.result(result, "index") for result in expected if self.result(result, "found")]
        found = [self.result(result, "index") for result in received if self.result(result, "found")]
        assert set(neighbors) <= set(found) and len(found) == len(set(found))
        if not self.result(received[0], "cached") and neighbors:
            assert found[: len(neighbors)] == neighbors
            for got, wanted in zip(received, expected):
                assert self.result(got, "distance2") == self.result(wanted, "distance2")
