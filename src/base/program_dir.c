/* program_dir - see program_dir.h. */
#include "program_dir.h"

#include <string.h>
#include <unistd.h>

void program_dir(char *folder, size_t size)
{
    ssize_t n = readlink("/proc/self/exe", folder, size - 1); /* Linux; elsewhere it is not there */
    folder[n > 0 ? n : 0] = '\0';
    char *slash = strrchr(folder, '/');
    if (slash)
        *slash = '\0';
}
