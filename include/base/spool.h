/*
 * spool - a file without a name for what does not have to be in memory: in the folder TMPDIR, or
 * in /var/tmp or /tmp.  It is gone when it is closed, and when the process ends in any way.
 */
#ifndef CLOUDMILL_SPOOL_H
#define CLOUDMILL_SPOOL_H

#include <stdio.h>

/* To be written and read; close it with fclose().  NULL with errno: in none of these folders. */
FILE *spool_open(void);

#endif
