/* path_tool - see path_tool.h. */
#include "path_tool.h"

#include <math.h>
#include <string.h>

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

static bool same_shape(const struct path_tool *a, const struct path_tool *b)
{
    if (a->cutter_n != b->cutter_n)
        return false;
    for (int i = 0; i < a->cutter_n; i++)
        if (a->cutter[i] != b->cutter[i])
            return false;
    return true;
}

/* The first tool is the head's, a later one the last item's. */
static void store(struct path_parse *p)
{
    struct path *path = p->path;
    if (path->tool.n) {
        path->tool.item[path->tool.n - 1] = p->tool;
        return;
    }
    path->head.tool = p->tool.number;
    path->head.offset = p->tool.offset;
    path->head.cutter_n = p->tool.cutter_n;
    memcpy(path->head.cutter, p->tool.cutter, sizeof path->head.cutter);
}

void path_tool_shape(struct path_parse *p, const double *cutter, int n)
{
    struct path_tool *tool = p->tool_used ? &p->next_tool : &p->tool;
    memset(tool->cutter, 0, sizeof tool->cutter);
    memcpy(tool->cutter, cutter, (size_t)n * sizeof *cutter);
    tool->cutter_n = n;
    if (!p->tool_used)
        store(p);
}

/* The next tool goes into the spindle. */
static void change(struct path_parse *p)
{
    p->tool = p->next_tool;
    p->next_tool = (struct path_tool){0};
    p->tool_used = p->guessed = false;
    path_add_tool(p->path, p->tool);
    p->path->item.item[p->path->item.n - 1].line = p->apt.line;
}

/* A number for a tool that has none: behind the greatest so far. */
static int free_number(const struct path *path)
{
    int most = path->head.tool;
    for (size_t i = 0; i < path->tool.n; i++)
        most = path->tool.item[i].number > most ? path->tool.item[i].number : most;
    return most + 1;
}

static void change_without_number(struct path_parse *p)
{
    struct path *path = p->path;
    if (!path->head.tool) {
        path->head.tool = 1;
        path->tools_numbered++;
    }
    p->next_tool.number = free_number(path);
    path->tools_numbered++;
    change(p);
    p->guessed = true;
}

/* The number behind OSETNO (or ADJUST, of NX) among the arguments, 0: there is none. */
static int offset_number(const struct apt *apt)
{
    for (size_t i = 0; i + 1 < apt->argument.n; i++) {
        double n = apt->argument.item[i + 1].number;
        bool named = apt_is(apt, i, "OSETNO") || apt_is(apt, i, "ADJUST");
        if (named && n >= 1 && n <= 99999999 && n == floor(n))
            return (int)n;
    }
    return 0;
}

static int take_number(struct path_parse *p, double n)
{
    int offset = offset_number(&p->apt);
    if (n < 0 || n > 99999999 || n != floor(n))
        return error_at(AT(p), "found tool number %g, expected a whole number", n);
    int number = (int)n;
    if (!p->tool_used) {
        if (p->guessed) /* the tool's name came before its number */
            p->path->tools_numbered--;
        p->guessed = false;
        p->tool.number = number;
        p->tool.offset = offset > 0 ? offset : p->tool.offset;
        store(p);
    } else if (number != p->tool.number) {
        p->next_tool.number = number;
        p->next_tool.offset = offset;
        change(p);
    } else {
        p->next_tool = (struct path_tool){0};
    }
    return 0;
}

void path_tool_named(struct path_parse *p, const char *name)
{
    bool other = p->tool_used && strncmp(p->tool_name, name, sizeof p->tool_name - 1) != 0;
    size_t n = strlen(name) < sizeof p->tool_name ? strlen(name) : sizeof p->tool_name - 1;
    memcpy(p->tool_name, name, n);
    p->tool_name[n] = '\0';
    if (other)
        change_without_number(p);
}

void path_tool_move(struct path_parse *p)
{
    if (p->tool_used && p->next_tool.cutter_n && !same_shape(&p->tool, &p->next_tool))
        change_without_number(p);
    p->next_tool = (struct path_tool){0};
    if (p->rapid && !p->tool.number && !p->path->tool.n)
        return; /* to where the first tool is taken */
    p->tool_used = true;
    p->guessed = false;
}

/* CUTTER/d, r, e, f, alpha, beta, h: as many as are there; the angles have no unit of length. */
int path_read_cutter(struct path_parse *p)
{
    size_t n = p->apt.argument.n < 7 ? p->apt.argument.n : 7;
    double v[7];
    if (path_numbers(p, 0, n, v, "diameter, corner radius, e, f, alpha, beta, height") < 0)
        return -1;
    for (size_t i = 0; i < n; i++)
        v[i] *= i == 4 || i == 5 ? 1 : p->unit;
    path_tool_shape(p, v, (int)n);
    return 0;
}

int path_read_tool(struct path_parse *p)
{
    double n;
    if (!p->apt.argument.n || !p->apt.argument.item[0].is_number)
        return path_keep_text(p);
    return path_numbers(p, 0, 1, &n, "tool number") < 0 ? -1 : take_number(p, n);
}

int path_read_load(struct path_parse *p)
{
    double n;
    if (!apt_is(&p->apt, 0, "TOOL") || p->apt.argument.n < 2 || !p->apt.argument.item[1].is_number)
        return path_keep_text(p);
    return path_numbers(p, 1, 1, &n, "tool number") < 0 ? -1 : take_number(p, n);
}
