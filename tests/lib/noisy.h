/*
 * noisy - clouds of the panel and of a sphere with noise, for the tests of what is found in scans.
 */
#ifndef TEST_NOISY_H
#define TEST_NOISY_H

#include "base/array.h"
#include "math/vec.h"

/* How the points lie: in rows, on laser lines four steps apart, anywhere. */
enum noisy_pattern { NOISY_GRID, NOISY_LINES, NOISY_RANDOM };

/* Uniform from 0 to 1, and normal of deviation 1, from one sequence that noisy_seed begins. */
void noisy_seed(unsigned seed);
double noisy_uniform(void);
double noisy_normal(void);

/* Appends about n points over 74 x 54 mm of z = height(x, y), moved by normal noise along the
 * surface's normal. */
void noisy_scan(struct vec3s *scan, double (*height)(double x, double y), int n,
                enum noisy_pattern pattern, double sigma);

/* Unit normal of z = height(x, y), by central differences. */
struct vec3 noisy_up(double (*height)(double x, double y), double x, double y);

#endif
