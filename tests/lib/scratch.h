/*
 * scratch - files for unit tests: a text or bytes under a name, gone when the test program ends.
 */
#ifndef CLOUDMILL_SCRATCH_H
#define CLOUDMILL_SCRATCH_H

#include <stddef.h>

/* The name of the scratch file; one for the whole process, whatever is in it. */
const char *scratch_name(void);

/* Puts n bytes (or a text) into it, in place of what was there; returns its name. */
const char *scratch_bytes(const void *bytes, size_t n);
const char *scratch_text(const char *text);

/* Ends, or gives back, all room for files: what is written to one fails. */
void scratch_no_room(void);
void scratch_room(void);

/* What is in it, with a '\0' behind; to be freed. */
char *scratch_read(size_t *n);

#endif
