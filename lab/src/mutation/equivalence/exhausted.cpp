// Gives both versions every operand, until they differ.
#include "Vboth.h"
#include <cinttypes>
#include <cstdio>

int main() {
    Vboth both;
    for (uint64_t operand = 0; operand < UINT64_C(1) << OPERAND_BITS; operand++) {
        both.operand = operand;
        both.eval();
        if (both.differ) {
            printf("differs: %" PRIx64 "\n", operand);
            return 1;
        }
    }
    return 0;
}
