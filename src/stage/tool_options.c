/* tool_options - see tool_options.h. */
#include "stage/tool_options.h"

#include "gouge/holder_text.h"

int tool_options_read(const struct tool_options *options, double radius, struct tool_body *body,
                      struct error *error)
{
    struct error why;

    *body = tool_body_usual(radius);
    if (options->ball_only && (options->flute_given || options->holder))
        return error_set(error, "found --ball-only with --%s, expected one of them",
                         options->holder ? "holder" : "flute");
    if (options->flute_given)
        body->flute = options->flute;
    if (options->holder && holder_text_read(options->holder, &body->above, &why) != 0)
        return error_set(error, "option --holder: %s", why.text);
    if (options->ball_only)
        *body = (struct tool_body){.ball_only = true};
    return 0;
}

void tool_options_say(const struct tool_body *body, double radius)
{
    char text[HOLDER_TEXT];

    holder_text_write(&body->above, text);
    if (body->ball_only)
        say("tool: ball R %g only, the rest of the tool is not looked at", radius);
    else if (body->above.n > 0)
        say("tool: ball R %g, flute %g, holder %s", radius, body->flute, text);
    else
        say("tool: ball R %g, flute %g, no holder given", radius, body->flute);
}
