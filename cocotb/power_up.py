"""Registers as they are when hardware is switched on: with any value, but with one.

A simulator's X goes further than what is not known: all bits of a decoded number are X if the number is, even where a low `valid` makes them 0. As
the generator resets only registers that must be reset, others would leave X behind for good.
"""

import random
import re

REGISTER = re.compile(r"^ *(?:output )?reg +(?:\[(\d+):0\] )?(\w+)(?: \[0:(\d+)\])?[;,]?$", re.MULTILINE)
MODULE = re.compile(r"^module .*?^endmodule", re.MULTILINE | re.DOTALL)


def switched_on(verilog: str, seed: int) -> str:
    """The same modules, with random values in every register and memory."""
    source = random.Random(seed)

    def initialized(module: re.Match[str]) -> str:
        values = []
        for register in REGISTER.finditer(module[0]):
            highest, name, last = register.groups()
            if not re.search(rf"\b{name}(?:\[.*\])? <= ", module[0]):
                # The output of an `always @(*)`.
                continue
            width = int(highest or 0) + 1
            places = [f"{name}[{index}]" for index in range(int(last) + 1)] if last else [name]
            values += [f"        {place} = {width}'h{source.getrandbits(width):x};" for place in places]
        if not values:
            return module[0]
        return "\n".join([module[0].removesuffix("endmodule"), "    initial begin", *values, "    end", "endmodule"])

    return MODULE.sub(initialized, verilog)
