/* control_text - see control_text.h. */
#include "machine/control_text.h"

#include <string.h>

#include "machine/control.h"
#include "machine/template.h"

static const char *const names[CONTROL_SECTIONS] = {
    [SECTION_START] = "start",     [SECTION_TOOL] = "tool",     [SECTION_APPROACH] = "approach",
    [SECTION_RETRACT] = "retract", [SECTION_CHANGE] = "change", [SECTION_END] = "end"};

const char *control_section_name(enum control_section section)
{
    return names[section];
}

enum control_section control_section_find(const char *line)
{
    size_t n = strlen(line);
    int i = 0;
    while (i < CONTROL_SECTIONS &&
           (n != strlen(names[i]) + 2 || strncmp(line + 1, names[i], n - 2) != 0))
        i++;
    return (enum control_section)i;
}

int control_section_add(struct control_text *text, enum control_section section, const char *line,
                        struct error *error)
{
    char *to = text->section[section];
    size_t had = strlen(to), n = strlen(line);
    if (template_check(line, TEMPLATE_IN_SECTION, error) != 0)
        return -1;
    if (had + n + 2 > CONTROL_SECTION_SIZE)
        return error_set(error, "found more than %d characters in [%s], expected fewer",
                         CONTROL_SECTION_SIZE, names[section]);
    memcpy(to + had, line, n);
    memcpy(to + had + n, "\n", 2);
    return 0;
}

bool control_text_has(const struct control_text *text, const char *field)
{
    for (int i = 0; i < CONTROL_SECTIONS; i++)
        if (strstr(text->section[i], field))
            return true;
    return false;
}

#define ROW(name, title, tcp_of_machine, dc) extern const char control_text_##name[];
CONTROL_TABLE(ROW)
#undef ROW

#define ROW(name, title, tcp_of_machine, dc) control_text_##name,
static const char *const built_in[] = {CONTROL_TABLE(ROW)};
#undef ROW

const char *control_text_built_in(const char *name)
{
    enum control_id id = control_find(name);
    return id == CONTROLS ? NULL : built_in[id];
}
