#include "numbers.h"

/* The host's own `float` is f32. */
#define HOST_MANTISSA_BITS 23
#define HOST_EXPONENT_MAX 255
#define HOST_BIAS 127

/* C99 allows to read another member of a union than was written. */
union host_float {
    float value;
    uint32_t bits;
};

/* Shifted right, to nearest, ties to even. */
static uint32_t shifted(uint32_t value, unsigned places)
{
    uint32_t kept, rest, half;
    if (places == 0)
        return value;
    if (places > 25) /* a mantissa has 24 bits: less than half of the last place */
        return 0;
    kept = value >> places;
    rest = value & (((uint32_t)1 << places) - 1);
    half = (uint32_t)1 << (places - 1);
    return kept + (rest > half || (rest == half && (kept & 1)));
}

uint32_t number_of(struct number_format format, float value)
{
    const uint32_t exponent_max = ((uint32_t)1 << format.exponent_bits) - 1;
    const uint32_t infinity = exponent_max << format.mantissa_bits;
    const int bias = (int)(exponent_max >> 1);
    const unsigned dropped = HOST_MANTISSA_BITS - format.mantissa_bits;
    const union host_float host = {value};
    const uint32_t sign = (host.bits >> 31) << (format.exponent_bits + format.mantissa_bits);
    const uint32_t host_exponent = host.bits >> HOST_MANTISSA_BITS & HOST_EXPONENT_MAX;
    uint32_t mantissa = host.bits & (((uint32_t)1 << HOST_MANTISSA_BITS) - 1), magnitude;
    int exponent;

    if (host_exponent == HOST_EXPONENT_MAX)
        return mantissa ? infinity | (uint32_t)1 << (format.mantissa_bits - 1) : sign | infinity;
    if (host_exponent)
        mantissa |= (uint32_t)1 << HOST_MANTISSA_BITS;
    exponent = (int)(host_exponent ? host_exponent : 1) - HOST_BIAS + bias;
    if (exponent < 1) /* subnormal, or what rounds up to the smallest normal number */
        magnitude = shifted(mantissa, dropped + (unsigned)(1 - exponent));
    else /* the leading one adds 1 to the exponent, and so does a carry */
        magnitude = ((uint32_t)(exponent - 1) << format.mantissa_bits) + shifted(mantissa, dropped);
    return sign | (magnitude < infinity ? magnitude : infinity);
}

float number_value(struct number_format format, uint32_t bits)
{
    const uint32_t exponent_max = ((uint32_t)1 << format.exponent_bits) - 1;
    const int bias = (int)(exponent_max >> 1);
    const uint32_t exponent = bits >> format.mantissa_bits & exponent_max;
    const uint32_t mantissa = bits & (((uint32_t)1 << format.mantissa_bits) - 1);
    const uint32_t sign = bits >> (format.exponent_bits + format.mantissa_bits) & 1;
    const unsigned dropped = HOST_MANTISSA_BITS - format.mantissa_bits;
    union host_float host;

    if (exponent == exponent_max || exponent_max == HOST_EXPONENT_MAX || exponent) {
        const uint32_t host_exponent =
            exponent == exponent_max ? HOST_EXPONENT_MAX : exponent - (uint32_t)bias + HOST_BIAS;
        host.bits = sign << 31 | host_exponent << HOST_MANTISSA_BITS | mantissa << dropped;
    } else { /* subnormal in the format, normal in the host's: the leading one is taken away again */
        union host_float least;
        least.bits = (uint32_t)(1 - bias + HOST_BIAS) << HOST_MANTISSA_BITS;
        host.bits = least.bits | mantissa << dropped;
        host.value -= least.value;
        host.bits |= sign << 31;
    }
    return host.value;
}

/* To the nearest integer from `low` to `high`; NaN to 0. */
static int32_t nearest(float scaled, int32_t low, int32_t high)
{
    if (scaled != scaled)
        return 0;
    if (scaled <= (float)low)
        return low;
    if (scaled >= (float)high)
        return high;
    return (int32_t)(scaled < 0 ? scaled - 0.5f : scaled + 0.5f);
}

uint32_t fraction_of(unsigned fraction_bits, float value)
{
    const int32_t one = (int32_t)1 << fraction_bits;
    return (uint32_t)nearest(value * (float)one, -one, one - 1) & (((uint32_t)2 << fraction_bits) - 1);
}

float fraction_value(unsigned fraction_bits, uint32_t bits)
{
    const int32_t one = (int32_t)1 << fraction_bits;
    const int32_t value = (int32_t)(bits & (((uint32_t)2 << fraction_bits) - 1));
    return (float)(value < one ? value : value - 2 * one) / (float)one;
}

uint32_t unsigned_of(unsigned bits, unsigned fraction_bits, float value)
{
    return (uint32_t)nearest(value * (float)((uint32_t)1 << fraction_bits), 0, (int32_t)(((uint32_t)1 << bits) - 1));
}
