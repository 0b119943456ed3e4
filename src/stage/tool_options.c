/* tool_options - see tool_options.h. */
#include "stage/tool_options.h"

#include "gouge/holder_text.h"

int tool_options_files(struct tool_options *options, double *radius, struct error *error)
{
    double said;

    for (size_t i = 0; i < options->files.n; i++)
        if (tool_file_read(&options->file, options->files.item[i], error) != 0)
            return -1;
    said = options->file.radius;
    if (*radius > 0 && said > 0 && fabs(*radius - said) > 1e-9)
        return error_set(error, "found -r %g with --tool-file of a ball of %g, expected one radius",
                         *radius, said);
    *radius = *radius > 0 ? *radius : said;
    return 0;
}

/* No tool is longer or wider than a machine; one that were would be near to every point of a scan
 * with all of its length. */
static int check_size(const struct tool_body *body, double radius, struct error *error)
{
    double most = fmax(1000, 100 * radius), length = 0, size = body->flute;

    for (int i = 0; i < body->above.n; i++) {
        const struct holder_part *part = &body->above.part[i];
        length += part->length;
        size = fmax(fmax(size, length), fmax(part->low, part->high));
    }
    if (size <= most)
        return 0;
    return error_set(error,
                     "found a tool that reaches %g mm from the ball's centre (--flute, "
                     "--holder), expected at most %g mm",
                     size, most);
}

int tool_options_read(const struct tool_options *options, double radius, struct tool_body *body,
                      struct error *error)
{
    struct error why;

    if (tool_file_body(&options->file, radius, body, error) != 0)
        return -1;
    if (options->ball_only && (options->flute_given || options->holder))
        return error_set(error, "found --ball-only with --%s, expected one of them",
                         options->holder ? "holder" : "flute");
    if (options->flute_given)
        body->flute = options->flute;
    if (options->holder && holder_text_read(options->holder, &body->above, &why) != 0)
        return error_set(error, "option --holder: %s", why.text);
    bool nothing = options->flute_given && body->flute == 0 && body->above.n == 0;
    if (options->ball_only || nothing)
        *body = (struct tool_body){.ball_only = true};
    return check_size(body, radius, error);
}

void tool_options_say(const struct tool_body *body, double radius)
{
    char text[HOLDER_TEXT];

    holder_text_write(&body->above, text);
    if (body->ball_only)
        say("tool: ball R %g only, the rest of the tool is not looked at", radius);
    else if (body->above.n > 0)
        note("tool: ball R %g, flute %g, holder %s", radius, body->flute, text);
    else
        note("tool: ball R %g, flute %g, no holder given", radius, body->flute);
}
