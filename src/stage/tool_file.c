/* tool_file - see tool_file.h. */
#include "stage/tool_file.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/library_file.h"
#include "base/reader.h"
#include "gouge/holder_text.h"
#include "machine/keys.h"

static const struct library tools = {"tool", "tools", "CLOUDMILL_TOOLS"};

static void add_length(struct keys *keys, const char *name, double *value)
{
    struct key *key = keys_add(keys, name, KEY_NUMBER, value);
    key->min = 0.001;
    key->max = 1e4;
}

static struct keys tool_keys(struct tool_file *tool)
{
    struct keys keys = {.of = "tool"};
    add_length(&keys, "radius", &tool->radius);
    add_length(&keys, "flute", &tool->flute);
    add_length(&keys, "shank", &tool->shank);
    add_length(&keys, "length", &tool->length);
    add_length(&keys, "stickout", &tool->stickout);
    keys_add(&keys, "name", KEY_TEXT, tool->name)->size = sizeof tool->name;
    keys_add(&keys, "holder", KEY_TEXT, tool->holder)->size = sizeof tool->holder;
    return keys;
}

int tool_file_read(struct tool_file *tool, const char *name, struct error *error)
{
    char file[LIBRARY_FILE], *line;
    struct reader r;
    size_t n, said = 0;
    int got, result = 0;
    if (library_file_find(&tools, name, NULL, file, error) != 0 ||
        reader_open(&r, file, error) != 0)
        return -1;
    struct keys keys = tool_keys(tool);
    while (result == 0 && (got = reader_line(&r, &line, &n, error)) != 0) {
        char *text = got > 0 ? keys_trim(line) : NULL;
        said += text && *text;
        result = got < 0 ? -1 : *text ? keys_set(&keys, text, r.name, r.line, error) : 0;
    }
    if (result == 0 && said == 0)
        result = error_at(error, r.name, 0, "found no key, expected lines key = value");
    array_free(&keys);
    reader_close(&r);
    return result;
}

static void add_part(struct holder *holder, double radius, double length)
{
    if (length > 0)
        holder->part[holder->n++] = (struct holder_part){radius, radius, length};
}

int tool_file_body(const struct tool_file *tool, double radius, struct tool_body *body,
                   struct error *error)
{
    struct holder holder = {0}, *above = &body->above;
    struct error why;
    double end = *tool->holder ? tool->stickout : tool->length;

    *body = tool_body_usual(radius);
    if (tool->shank > 0 && !(end > 0))
        return error_set(error,
                         "tool: found a shank of %g that ends nowhere, expected a length, or a "
                         "holder and its stickout",
                         tool->shank);
    if (tool->flute > 0)
        body->flute = fmax(tool->flute - radius, 0);
    if (*tool->holder && !(tool->stickout > radius))
        return error_set(error,
                         "tool: found a holder and a stickout of %g, expected one above the "
                         "radius %g: from the tip to the holder's nose",
                         tool->stickout, radius);
    if (*tool->holder && holder_text_read(tool->holder, &holder, &why) != 0)
        return error_set(error, "tool: holder: %s", why.text);
    if (holder.n > HOLDER_PARTS - 2)
        return error_set(error, "tool: found a holder of %d cones, expected fewer", holder.n);
    add_part(above, radius, fmin(tool->flute, end) - radius);
    if (tool->shank > 0 || holder.n > 0)
        add_part(above, tool->shank > 0 ? tool->shank : radius,
                 end - fmax(fmin(tool->flute, end), radius));
    for (int i = 0; i < holder.n; i++)
        above->part[above->n++] = holder.part[i];
    return 0;
}
