/*
 * out - checked output to standard output, or to a file that is complete or absent.
 *
 * A file is written under a temporary name beside its place and renamed by out_close.  A process
 * that ends before that (die, a signal) leaves an older file unchanged and no temporary file. What
 * has been read stays: a result with its name is an error.  Anything but a regular file (a FIFO,
 * /dev/null) is written directly.  A failure to write ends the process with exit status 1.  One
 * output at a time, beside those in memory.
 */
#ifndef CLOUDMILL_OUT_H
#define CLOUDMILL_OUT_H

#include <stdbool.h>
#include <stddef.h>

struct out;

/* From now on a second output to a file that has one ends the process too, and one to a file that
 * was read: for tools, each of whose results is a file of its own. */
void out_once_each(void);

/* The file that is open here is read: no result may take its place.  From any thread. */
void out_keep(int fd);

/* But this one's may: it is changed in place. */
void out_may_replace(const char *file);

/* There is nothing of this name, or a regular file. */
bool out_may_be_file(const char *file);

/* Both are the same name, or there and the same file. */
bool out_same_file(const char *file, const char *other);

/* NULL or "-": standard output. */
struct out *out_open(const char *file);

void out_text(struct out *o, const char *s);
void out_bytes(struct out *o, const void *p, size_t n);
void out_printf(struct out *o, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Room for n bytes, at most 4096, to be filled without a copy; out_take then writes the first n of
 * them.  No other output comes between. */
char *out_room(struct out *o, size_t n);
void out_take(struct out *o, size_t n);

/* x with `digits` decimals as num_write writes it. */
void out_num(struct out *o, double x, int digits);
/* x with the fewest digits that read back as the same number. */
void out_exact(struct out *o, double x);
void out_int(struct out *o, long long i);

/* Output that is kept in memory, for a part of what out_join then writes elsewhere in its order: it
 * may be filled by another thread.  out_close frees it. */
struct out *out_memory(void);

/* Writes what the other has in memory, which is then empty. */
void out_join(struct out *o, struct out *memory);

/* Writes what is left, checks it and gives the file its name. */
void out_close(struct out *o);

/* Removes an unfinished file; for die and the signal handler. */
void out_abandon(void);

#endif
