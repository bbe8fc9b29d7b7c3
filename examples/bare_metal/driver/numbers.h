/* Numbers as the cores have them (docs/numbers.md), to and from the host's `float`, without a library. */
#ifndef POINTCORE_NUMBERS_H
#define POINTCORE_NUMBERS_H

#include <stdint.h>

/* A floating-point format of a configuration: `<CORE>_<NAME>_EXPONENT_BITS` and `_MANTISSA_BITS` of registers.h. */
struct number_format {
    unsigned exponent_bits;
    unsigned mantissa_bits;
};

/* To the nearest number of the format, ties to even; beyond the largest, infinity. */
uint32_t number_of(struct number_format format, float value);

/* The same number; of a format no wider than `float`, exactly. */
float number_value(struct number_format format, uint32_t bits);

/* To a fraction in two's complement, in so many bits behind the point and one before it: nearest, saturated. */
uint32_t fraction_of(unsigned fraction_bits, float value);

/* Its value: the sign is extended here. */
float fraction_value(unsigned fraction_bits, uint32_t bits);

/* To a number without sign, so many bits in all: nearest, saturated. */
uint32_t unsigned_of(unsigned bits, unsigned fraction_bits, float value);

#endif
