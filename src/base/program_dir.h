/*
 * program_dir - the folder of the running program, to find the files installed or built with it.
 */
#ifndef CLOUDMILL_PROGRAM_DIR_H
#define CLOUDMILL_PROGRAM_DIR_H

#include <stddef.h>

/* The folder of the running program, without a slash at its end; "" if unknown. */
void program_dir(char *folder, size_t size);

#endif
