"""Registers as they are when hardware is switched on: with any value, but with one.

A simulator's X goes further than what is not known: all bits of a decoded number are X if the number is, even where a low `valid` makes them 0. As
the generator resets only registers that must be reset, others would leave X behind for good.
"""

import random
import re

# A declaration's width, and its names with their numbers of words; a port's may be followed by another one's direction.
DECLARATION = re.compile(r"\breg +(?:\[(\d+):0\] )?(\w+(?: \[0:\d+\])?(?:,\s+\w+(?: \[0:\d+\])?)*)")
NAME = re.compile(r"(\w+)(?: \[0:(\d+)\])?")
# What only assertions look at is there with these alone. They close a module.
ASSERTIONS = re.compile(r"^`ifdef RTL_ASSERT$.*", re.MULTILINE | re.DOTALL)
MODULE = re.compile(r"^module .*?^endmodule", re.MULTILINE | re.DOTALL)


def switched_on(verilog: str, seed: int) -> str:
    """The same modules, with random values in every register and memory."""
    source = random.Random(seed)

    def initialized(module: re.Match[str]) -> str:
        hardware = ASSERTIONS.sub("", module[0])
        values = []
        for declaration in DECLARATION.finditer(hardware):
            highest, names = declaration.groups()
            width = int(highest or 0) + 1
            for name, last in NAME.findall(names):
                # No register is the output of an `always @(*)`, nor the direction of the next port.
                if re.search(rf"\b{name}(?:\[.*\])? <= ", hardware):
                    places = [f"{name}[{index}]" for index in range(int(last) + 1)] if last else [name]
                    values += [f"        {place} = {width}'h{source.getrandbits(width):x};" for place in places]
        if not values:
            return module[0]
        return "\n".join([module[0].removesuffix("endmodule"), "    initial begin", *values, "    end", "endmodule"])

    return MODULE.sub(initialized, verilog)
