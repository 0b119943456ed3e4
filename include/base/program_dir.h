/*
 * program_dir - where the running program lies, so that what was installed or built beside it is
 * found.
 */
#ifndef CLOUDMILL_PROGRAM_DIR_H
#define CLOUDMILL_PROGRAM_DIR_H

#include <stddef.h>

/* The folder of the running program, without a slash at its end; "" where the system does not say.
 */
void program_dir(char *folder, size_t size);

#endif
