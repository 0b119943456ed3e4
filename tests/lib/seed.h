/*
 * seed - what the random numbers of the tests begin with: $SEED, a whole number, gives every
 * sequence another course; without it, and with 0, it is the same one each time.
 *
 * A sequence is state * 6364136223846793005 + seed_step(), of which the upper bits are used (Knuth,
 * The Art of Computer Programming, 3.3.4: any odd step will do).
 */
#ifndef CLOUDMILL_TEST_SEED_H
#define CLOUDMILL_TEST_SEED_H

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

/* Odd, another for every $SEED. */
static inline uint64_t seed_step(void)
{
    const char *given = getenv("SEED");
    uint64_t number = given ? strtoull(given, NULL, 10) : 0;
    return 1442695040888963407u + 2 * 0x9E3779B97F4A7C15u * number;
}

/* The same for sequences of 32 bits, state * 1664525 + seed_step_32(). */
static inline uint32_t seed_step_32(void)
{
    return seed_step() == 1442695040888963407u ? 1013904223u : (uint32_t)(seed_step() >> 31) | 1u;
}

/* What a sequence without such a step (xorshift, Lehmer's) begins with: as is, and with $SEED a
 * number from 1 to 2^31 - 2, as those of 31 bits need it. */
static inline uint64_t seed_begin(uint64_t as_is)
{
    bool other = seed_step() != 1442695040888963407u;
    return other ? (seed_step() >> 20) % 2147483646u + 1 : as_is;
}

#endif
