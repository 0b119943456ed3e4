/* control - see control.h. */
#include "machine/control.h"

#include <string.h>

bool control_known(const char *name)
{
    size_t length = strlen(name);
    for (const char *s = CONTROL_NAMES; length; s++) {
        size_t own = strcspn(s, "|");
        if (own == length && strncmp(s, name, length) == 0)
            return true;
        s += own;
        if (!*s)
            break;
    }
    return false;
}
