/*
 * clouds - what the tests of the readers of clouds share: a text read as a file, and its points
 * compared.
 */
#ifndef CLOUDMILL_TESTS_CLOUDS_H
#define CLOUDMILL_TESTS_CLOUDS_H

#include "io/cloud/cloud.h"

/* What was read last. */
extern struct clouds {
    struct vec3s points;
    struct cloud_count count;
    struct error error;
} clouds;

/* Frees the points. */
void clouds_clear(void);

/* Reads them anew; what cloud_read returns. */
int clouds_bytes(const char *text, size_t n);
int clouds_text(const char *text);

/* The text must hold these n points. */
void clouds_expect(const char *text, size_t n, const double want[][3]);

/* The text must hold the points 1.5 -2.25 3000, 0.5 0.25 -4 and 7 8 9. */
void clouds_three(const char *text);

/* It must be refused with a message that has `says` in it and begins with the file's name. */
void clouds_refused_bytes(const char *text, size_t n, const char *says);
void clouds_refused(const char *text, const char *says);

/* The same row of numbers in each run: below n; and one as some program or other would print it,
 * whose length is returned. */
unsigned clouds_below(unsigned n);
size_t clouds_number(char *buf);

#endif
