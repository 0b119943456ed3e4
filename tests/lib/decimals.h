/* decimals - decimal numbers that are hard to read exactly, for tests that compare with strtod. */
#ifndef CLOUDMILL_TEST_DECIMALS_H
#define CLOUDMILL_TEST_DECIMALS_H

#include <stdint.h>

enum { DECIMAL_MAX = 1200 };

/*
 * Number `i` of a series that *state (not 0) begins: in turn a coordinate, any double to 17 digits,
 * up to 40 random digits with a random point and exponent, and the place half way between two
 * doubles (normal or not), exactly, or with its last digit changed, or with more digits after it.
 */
void decimal_hard(uint64_t *state, uint64_t i, char text[DECIMAL_MAX]);

#endif
