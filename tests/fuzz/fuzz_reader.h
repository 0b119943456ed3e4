/*
 * fuzz_reader - every reader of the tools, given bytes as a file, in this process.
 *
 * Linked with -Wl,--wrap=exit: where the tools would end for want of memory, reading ends.
 */
#ifndef CLOUDMILL_FUZZ_READER_H
#define CLOUDMILL_FUZZ_READER_H

#include <stddef.h>

struct fuzz_reader;

/* Once, first. */
void fuzz_begin(void);

/* The reader of that name, that of its seeds' folder in tests/fuzz/seeds; NULL: there is none. */
const struct fuzz_reader *fuzz_reader_of(const char *name);

/* Lets it read the bytes. */
void fuzz_read(const struct fuzz_reader *reader, const void *bytes, size_t n);

#endif
