/* control - see control.h. */
#include "machine/control.h"

#include <string.h>

#define ROW(name, title, tcp_of_machine, dc) {#name, title, tcp_of_machine, dc},
static const struct control table[] = {CONTROL_TABLE(ROW)};
#undef ROW

#define ROW(name, title, tcp_of_machine, dc) "|" #name
static const char names[] = CONTROL_TABLE(ROW);
#undef ROW

const struct control *control_row(enum control_id id)
{
    return &table[id];
}

enum control_id control_find(const char *name)
{
    int id = 0;
    while (id < CONTROLS && strcmp(table[id].name, name) != 0)
        id++;
    return (enum control_id)id;
}

const char *control_names(void)
{
    return names + 1;
}
