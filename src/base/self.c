/* self - see self.h. */
#include "base/self.h"

#include <string.h>
#include <unistd.h>

void self_folder(char *folder, size_t size)
{
    ssize_t n = readlink("/proc/self/exe", folder, size - 1); /* Linux; elsewhere it is not there */
    folder[n > 0 ? n : 0] = '\0';
    char *slash = strrchr(folder, '/');
    if (slash)
        *slash = '\0';
}
