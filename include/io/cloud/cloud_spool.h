/*
 * cloud_spool - the points of a cloud in a file without a name, to be looked at again: reading
 * them there takes a fifth of what reading their text again takes, and no memory.
 *
 * In: points in blocks.  Out: the same points, bit by bit, in the same order.  A record of points
 * has its coordinates as whole numbers of a power of ten, 4 bytes each, for scans are written so;
 * 8 bytes each where that would not be exact.
 */
#ifndef CLOUDMILL_CLOUD_SPOOL_H
#define CLOUDMILL_CLOUD_SPOOL_H

#include <stdbool.h>
#include <stddef.h>

#include "math/vec.h"

struct cloud_spool;

/* NULL: there is no folder for such a file (base/spool.h). */
struct cloud_spool *cloud_spool_new(void);

/* All that are added come before the end, and looks after it.  Where they cannot be written the
 * file is given up, and holds no points from then on. */
void cloud_spool_add(struct cloud_spool *spool, const struct vec3 *point, size_t n);
void cloud_spool_end(struct cloud_spool *spool);

/* Does it hold all that were added?  NULL holds none. */
bool cloud_spool_holds(const struct cloud_spool *spool);

/* All of them to `take`, block by block, as often as asked.  false: the file cannot be read. */
bool cloud_spool_look(struct cloud_spool *spool,
                      void (*take)(void *context, const struct vec3 *point, size_t n),
                      void *context);

/* NULL is no matter. */
void cloud_spool_free(struct cloud_spool *spool);

#endif
