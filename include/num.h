/*
 * num - numbers as text, the same in every locale and on every platform.
 */
#ifndef CLOUDMILL_NUM_H
#define CLOUDMILL_NUM_H

#include <stdbool.h>
#include <stddef.h>

/*
 * Reads one decimal number at *s: sign, digits with or without a point (`5`, `5.`, `.5`),
 * exponent by e, E, d or D.  The value is the nearest double, as strtod's would be.  True when a
 * number was there, and *s then stands behind it; false leaves *s.  The text must end in '\0'
 * (any character that can't be part of a number will do).  nan, inf and hexadecimal are no numbers;
 * a number too large for a double gives +-HUGE_VAL: check with isfinite where it matters.
 */
bool num_read(const char **s, double *value);

/*
 * Passes over a word that programs print for what is no finite number: nan, inf and infinity in any
 * case, with a sign and with brackets behind (`-nan(ind)`), 1.#IND, 1.#QNAN, -1.#INF.  False leaves
 * *s.
 */
bool num_not_finite(const char **s);

/* The whole of text is one finite number (blanks around it allowed). */
bool num_whole(const char *text, double *value);

enum { NUM_MAX = 352 }; /* room for any number that num_write writes, and its '\0' */

/*
 * Writes x with `digits` decimals (0 to 9) at buf, rounded half away from zero, with a decimal
 * point (none at digits 0), never an exponent, never -0; ends in '\0'; returns the length.
 */
size_t num_write(char *buf, double x, int digits);

/* The same without trailing zeros, but with its point where `point` is set: 12. 0.5 -3.25 */
size_t num_write_short(char *buf, double x, int digits, bool point);

/* The value that num_write(x, digits) reads back as. */
double num_round(double x, int digits);

#endif
