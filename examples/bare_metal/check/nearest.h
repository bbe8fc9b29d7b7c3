/* Numbers and distances as docs/interfaces.md has them, with nothing that the drivers use. */
#ifndef POINTCORE_NEAREST_H
#define POINTCORE_NEAREST_H

#include "check.h"

/* A real number rounded to the geometry format: as a number, with nothing that the driver uses. */
static inline double rounded(double real)
{
    int exponent;
    const int bits = CORE_(GEOMETRY_MANTISSA_BITS) + 1;
    const double mantissa = frexp(real, &exponent);
    if (real == 0 || !isfinite(real))
        return real;
    return ldexp(rint(ldexp(mantissa, bits)), exponent - bits);
}

/* What the bits of a result or a query say. */
static inline double value_of(uint32_t bits)
{
    const uint32_t bias = (1u << (CORE_(GEOMETRY_EXPONENT_BITS) - 1)) - 1;
    const uint32_t exponent = bits >> CORE_(GEOMETRY_MANTISSA_BITS) & (2 * bias + 1);
    const uint32_t mantissa = bits & ((1u << CORE_(GEOMETRY_MANTISSA_BITS)) - 1);
    const double sign = bits >> (CORE_(GEOMETRY_MANTISSA_BITS) + CORE_(GEOMETRY_EXPONENT_BITS)) ? -1 : 1;
    if (exponent == 2 * bias + 1)
        return mantissa ? NAN : sign * INFINITY;
    if (exponent == 0) /* none of the numbers here is subnormal */
        return sign * 0;
    return sign * ldexp(1 + ldexp(mantissa, -(int)CORE_(GEOMETRY_MANTISSA_BITS)), (int)exponent - (int)bias);
}

/* Squared. Rounding twice is rounding once: a double has more than twice as many bits. */
static inline double distance2(const float point[3], const uint32_t query[3])
{
    double sum = 0;
    for (int axis = 0; axis < 3; axis++) {
        const double difference = rounded(rounded(point[axis]) - value_of(query[axis]));
        const double square = rounded(difference * difference);
        sum = axis ? rounded(sum + square) : square;
    }
    return sum;
}

/* For `qsort`, smallest first. */
static inline int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

#endif
