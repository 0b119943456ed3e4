/* svg - see svg.h. */
#include "svg.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/num.h"

enum { COLUMNS = 100 }; /* lines of a path break about here */

/* & < > " by name; control characters, which XML has none of, and bytes that are no UTF-8 as ?. */
static void write_escaped(struct svg *svg, const char *text)
{
    for (const unsigned char *p = (const unsigned char *)text; *p;) {
        size_t n = *p < 0x80 ? 1 : *p >= 0xF0 && *p < 0xF5 ? 4 : *p >= 0xE0 ? 3 : 2;
        bool good = *p < 0x80 ? *p >= ' ' && *p != 0x7F : *p >= 0xC2 && *p < 0xF5;
        for (size_t i = 1; i < n && good; i++)
            good = (p[i] & 0xC0) == 0x80;
        if (good && n == 3) /* too long, surrogates, and the two that are no characters */
            good = !(p[0] == 0xE0 && p[1] < 0xA0) && !(p[0] == 0xED && p[1] >= 0xA0) &&
                   !(p[0] == 0xEF && p[1] == 0xBF && p[2] >= 0xBE);
        if (good && n == 4)
            good = !(p[0] == 0xF0 && p[1] < 0x90) && !(p[0] == 0xF4 && p[1] >= 0x90);
        const char *name = *p == '&'   ? "&amp;"
                           : *p == '<' ? "&lt;"
                           : *p == '>' ? "&gt;"
                           : *p == '"' ? "&quot;"
                                       : NULL;
        if (!good)
            out_text(svg->out, "?");
        else if (name)
            out_text(svg->out, name);
        else
            out_bytes(svg->out, p, n);
        p += good ? n : 1;
    }
}

void svg_begin(struct svg *svg, struct out *out, double width, double height, const char *title,
               const char *description)
{
    *svg = (struct svg){.out = out};
    out_printf(out,
               "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" "
               "viewBox=\"0 0 %.0f %.0f\" role=\"img\"\n"
               " font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\" fill=\"#222\">\n<title>",
               width, height, width, height);
    write_escaped(svg, title);
    out_text(out, "</title>\n<desc>");
    write_escaped(svg, description);
    out_text(out, "</desc>\n<path fill=\"#fff\" d=\"M0 0");
    out_printf(out, "H%.0fV%.0fH0z\"/>\n", width, height);
}

void svg_end(struct svg *svg)
{
    out_text(svg->out, "</svg>\n");
}

void svg_group(struct svg *svg, const char *attributes)
{
    out_printf(svg->out, "<g %s>\n", attributes);
}

void svg_group_end(struct svg *svg)
{
    out_text(svg->out, "</g>\n");
}

void svg_path(struct svg *svg, const char *attributes)
{
    out_printf(svg->out, "<path transform=\"scale(.1)\" %s d=\"", attributes);
    svg->x = svg->y = svg->from_x = svg->from_y = 0;
    svg->last = ' ';
    svg->column = 0;
}

/* A command and its two numbers; a command that goes on is left out, as SVG has it. */
static void write_command(struct svg *svg, char command, long x, long y)
{
    char text[60];
    int n = 0;
    if (svg->last != command)
        text[n++] = command;
    n += snprintf(text + n, sizeof text - (size_t)n,
                  svg->last == command && x >= 0 ? " %ld" : "%ld", x);
    n += snprintf(text + n, sizeof text - (size_t)n, y >= 0 ? " %ld" : "%ld", y);
    if (svg->column > COLUMNS) {
        out_text(svg->out, "\n");
        svg->column = 0;
    }
    out_bytes(svg->out, text, (size_t)n);
    svg->column += (size_t)n;
    svg->last = command;
}

void svg_move(struct svg *svg, double x, double y)
{
    long to_x = lround(10 * x), to_y = lround(10 * y);
    write_command(svg, svg->last == ' ' ? 'M' : 'm', to_x - svg->x, to_y - svg->y);
    svg->last = '\0'; /* a further pair after it would be a line */
    svg->x = svg->from_x = to_x;
    svg->y = svg->from_y = to_y;
}

void svg_line(struct svg *svg, double x, double y)
{
    long to_x = lround(10 * x), to_y = lround(10 * y);
    if (to_x == svg->x && to_y == svg->y)
        return;
    write_command(svg, 'l', to_x - svg->x, to_y - svg->y);
    svg->x = to_x;
    svg->y = to_y;
}

void svg_dot(struct svg *svg, double x, double y)
{
    svg_move(svg, x, y);
    out_text(svg->out, "h0");
    svg->column += 2;
}

void svg_close(struct svg *svg)
{
    out_text(svg->out, "z"); /* and the pen is back where the subpath began */
    svg->last = '\0';
    svg->x = svg->from_x;
    svg->y = svg->from_y;
}

void svg_path_end(struct svg *svg)
{
    out_text(svg->out, "\"/>\n");
}

void svg_text(struct svg *svg, double x, double y, const char *anchor, double size, bool bold,
              const char *text)
{
    out_printf(svg->out, "<text x=\"%.1f\" y=\"%.1f\" font-size=\"%.4g\"", x, y, size);
    if (strcmp(anchor, "start") != 0)
        out_printf(svg->out, " text-anchor=\"%s\"", anchor);
    out_text(svg->out, bold ? " font-weight=\"bold\">" : ">");
    write_escaped(svg, text);
    out_text(svg->out, "</text>\n");
}

double svg_text_width(double size, bool bold, const char *text)
{
    double letters = 0;
    for (const char *p = text; *p; p++)
        letters += (*p & 0xC0) != 0x80;
    return letters * size * (bold ? 0.66 : 0.6);
}

void svg_count(char text[SVG_COUNT], size_t number)
{
    char digits[24];
    int n = snprintf(digits, sizeof digits, "%zu", number), at = 0;
    for (int i = 0; i < n; i++) {
        if (i > 0 && (n - i) % 3 == 0)
            text[at++] = ',';
        text[at++] = digits[i];
    }
    text[at] = '\0';
}
