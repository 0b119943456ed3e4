/* template - see template.h. */
#include "machine/template.h"

#include <string.h>

static const char *const words[TEMPLATE_NONE] = {[TEMPLATE_TOOL] = "{tool}",
                                                 [TEMPLATE_OFFSET] = "{offset}",
                                                 [TEMPLATE_RPM] = "{rpm}",
                                                 [TEMPLATE_TOLERANCE] = "{tolerance}",
                                                 [TEMPLATE_ORIENTATION] = "{orientation}",
                                                 [TEMPLATE_LEVEL] = "{level}",
                                                 [TEMPLATE_A] = "{a}",
                                                 [TEMPLATE_B] = "{b}",
                                                 [TEMPLATE_I] = "{i}",
                                                 [TEMPLATE_J] = "{j}",
                                                 [TEMPLATE_K] = "{k}"};

enum template_word template_word(const char *text, size_t *length)
{
    if (*text != '{')
        return TEMPLATE_NONE;
    for (int i = 0; i < TEMPLATE_NONE; i++) {
        *length = strlen(words[i]);
        if (strncmp(text, words[i], *length) == 0)
            return (enum template_word)i;
    }
    return TEMPLATE_NONE;
}

int template_check(const char *text, struct error *error)
{
    size_t length;
    for (const char *s = strchr(text, '{'); s; s = strchr(s + 1, '{'))
        if (template_word(s, &length) == TEMPLATE_NONE)
            return error_set(
                error,
                "found `%.20s` in the template `%.40s`, expected {tool}, {offset}, {rpm}, "
                "{tolerance}, {orientation}, {level}, {a}, {b}, {i}, {j} or {k}",
                s, text);
    return 0;
}
