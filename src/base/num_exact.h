/*
 * num_exact - the double nearest to a decimal number of any length, as strtod finds it; for num.c.
 */
#ifndef CLOUDMILL_NUM_EXACT_H
#define CLOUDMILL_NUM_EXACT_H

/*
 * The text [from, to) is one number as num_read takes it: sign, digits with or without a point, and
 * an exponent by e, E, d or D.  Half way between two doubles the even one is taken; too large
 * a number is +-HUGE_VAL, too small a one +-0.
 */
double num_exact(const char *from, const char *to);

#endif
