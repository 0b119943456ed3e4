/* post_writer - see post_writer.h. */
#include "post_writer.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "math/elementary.h"
#include "base/num.h"

void nc_writer_begin(struct nc_writer *w, struct out *out, struct nc_format_options style, int step,
                     long most)
{
    if (style.count_all)
        step = 1;
    *w = (struct nc_writer){.out = out,
                            .style = style,
                            .step = step,
                            .most = most,
                            .number = style.count_all ? -1 : 0,
                            .wanted = -1};
    nc_writer_divert(w, out);
}

void nc_writer_divert(struct nc_writer *w, struct out *out)
{
    w->out = out;
    w->line = out ? out_room(out, NC_LINE_MAX) : w->own;
}

static void append_text(struct nc_writer *w, const char *s, size_t n)
{
    if (w->n + n > NC_BLOCK_MAX)
        return;
    memcpy(w->line + w->n, s, n);
    w->n += n;
}

/* Of struct nc_format_options, what numbers are written by. */
struct number_style {
    bool point, sign;
};

static inline struct number_style style_of(const struct nc_writer *w)
{
    return (struct number_style){w->style.point, w->style.sign};
}

static inline char *put_address(char *to, const char *address)
{
    while (*address)
        *to++ = *address++;
    return to;
}

/* A whole number with zeros in front up to a width; returns its length. */
static inline size_t put_count(char *to, long number, size_t width)
{
    size_t n = num_put_short(to, number, false, 0, false);
    if (n >= width)
        return n;
    memmove(to + width - n, to, n);
    memset(to, '0', width - n);
    return width;
}

/* The first word of a block, after its number, or one without room. */
static char *begin_block(struct nc_writer *w)
{
    if (w->n > NC_BLOCK_MAX)
        w->n = NC_BLOCK_MAX;
    if (w->n) {
        w->line[w->n++] = ' ';
        return w->line + w->n;
    }
    if (w->skip && !w->style.count_all)
        w->line[w->n++] = '/';
    if (w->step) {
        w->number += w->step;
        if (w->number > w->most)
            w->number = w->step;
        w->n = (size_t)(put_address(w->line + w->n, w->style.number) - w->line);
        w->n += put_count(w->line + w->n, w->number, (size_t)w->style.number_width);
        w->line[w->n++] = ' ';
        if (w->skip && w->style.count_all)
            w->line[w->n++] = '/';
    }
    return w->line + w->n;
}

/* Where the address of the next word goes: after a blank, or after the block's number.  There is
 * room for an address and a number, however long the block is. */
static inline char *begin_word(struct nc_writer *w)
{
    if (w->n == 0 || w->n > NC_BLOCK_MAX)
        return begin_block(w);
    w->line[w->n++] = ' ';
    return w->line + w->n;
}

void nc_code(struct nc_writer *w, const char *word)
{
    begin_word(w);
    append_text(w, word, strlen(word));
}

/* A word with a number that num_scaled has made whole; returns its end. */
static inline char *put_number(char *to, struct number_style style, const char *address,
                               int64_t integer, bool negative, int digits)
{
    char first = *address;
    to = put_address(to, address);
    if (style.sign && first && first != 'F' && !(negative && integer)) /* feeds have no sign */
        *to++ = '+';
    return to + num_put_short(to, integer, negative, digits, style.point);
}

/* The same of any number. */
static char *put_large(char *to, struct number_style style, const char *address, double value,
                       int digits)
{
    to = put_address(to, address);
    return to + num_write_short(to, value, digits, style.point);
}

void nc_number(struct nc_writer *w, const char *address, double value, int digits)
{
    int64_t integer;
    char *to = begin_word(w);
    to = num_scaled(value, digits, &integer)
             ? put_number(to, style_of(w), address, integer, value < 0, digits)
             : put_large(to, style_of(w), address, value, digits);
    w->n = (size_t)(to - w->line);
}

void nc_count(struct nc_writer *w, const char *address, double whole)
{
    char *to = put_address(begin_word(w), address);
    w->n = (size_t)(to + num_write(to, whole, 0) - w->line);
}

bool nc_motion(struct nc_writer *w, const char *code)
{
    if (w->motion && (w->motion == code || strcmp(w->motion, code) == 0))
        return false;
    w->motion = code;
    nc_code(w, code);
    return true;
}

/* A modal word of a number that is too large for num_units. */
static void modal_large(struct nc_writer *w, const struct nc_word *word)
{
    if (w->known[word->slot] && w->value[word->slot] == word->value)
        return;
    nc_remember(w, word->slot, word->value);
    nc_number(w, word->address, word->value, word->digits);
}

/* Where the block ends is known to this loop alone: characters that are stored might else be it. */
void nc_modal_words(struct nc_writer *w, const struct nc_word word[], size_t n)
{
    const struct number_style style = style_of(w);
    char *const line = w->line, *to = line + w->n;
    for (size_t i = 0; i < n; i++) {
        const struct nc_word *x = &word[i];
        double whole, said = x->value;
        if (w->known[x->slot] && w->value[x->slot] == said) /* most are rounded already */
            continue;
        if (!num_units(x->value, x->digits, &whole)) {
            w->n = (size_t)(to - line);
            modal_large(w, x);
            to = line + w->n;
            continue;
        }
        said = whole / num_ten[x->digits];
        if (w->known[x->slot] && w->value[x->slot] == said)
            continue;
        nc_remember(w, x->slot, said);
        if (to == line || to > line + NC_BLOCK_MAX) {
            w->n = (size_t)(to - line);
            to = begin_block(w);
        } else {
            *to++ = ' ';
        }
        to = put_number(to, style, x->address, (int64_t)fabs(whole), whole < 0, x->digits);
    }
    w->n = (size_t)(to - line);
}

bool nc_modal(struct nc_writer *w, enum nc_slot slot, const char *address, double value, int digits)
{
    const struct nc_word word = {slot, digits, address, value};
    size_t before = w->n;
    nc_modal_words(w, &word, 1);
    return w->n != before;
}

void nc_forget(struct nc_writer *w, enum nc_slot from, enum nc_slot to)
{
    for (enum nc_slot i = from; i <= to; i++)
        w->known[i] = false;
}

void nc_remember(struct nc_writer *w, enum nc_slot slot, double value)
{
    w->value[slot] = value;
    w->known[slot] = true;
}

void nc_end(struct nc_writer *w)
{
    if (!w->n)
        return;
    w->line[w->n++] = '\n';
    w->blocks++;
    w->bytes += w->n;
    if (w->number == w->wanted && !*w->met)
        memcpy(w->met, w->line, w->n);
    if (w->out) {
        out_take(w->out, w->n);
        w->line = out_room(w->out, NC_LINE_MAX);
    }
    w->n = 0;
}

void nc_continue(struct nc_writer *w, const char *text)
{
    append_text(w, "\n", 1);
    append_text(w, text, strlen(text));
    w->blocks++;
}

void nc_drop(struct nc_writer *w)
{
    if (w->n && w->step)
        w->number -= w->step;
    w->n = 0;
}

void nc_block(struct nc_writer *w, const char *word)
{
    nc_code(w, word);
    nc_end(w);
}

void nc_line(struct nc_writer *w, const char *text)
{
    append_text(w, text, strlen(text));
    nc_end(w);
}

void nc_comment(struct nc_writer *w, const char *format, ...)
{
    char text[200];
    size_t room = w->style.comment_width - strlen(w->style.open) - strlen(w->style.close);
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    for (size_t i = 0; text[i]; i++) {
        unsigned char c = (unsigned char)text[i];
        if (c < ' ' || c > '~')
            text[i] = ' ';
        else if (w->style.capitals)
            text[i] = (char)(strchr("()%", c) ? '-' : toupper(c));
        if (i == room) {
            text[i] = '\0';
            break;
        }
    }
    for (size_t n = strlen(text); n > 0 && text[n - 1] == ' '; n--)
        text[n - 1] = '\0';
    if (w->style.count_all)
        begin_word(w);
    append_text(w, w->style.open, strlen(w->style.open));
    append_text(w, text, strlen(text));
    append_text(w, w->style.close, strlen(w->style.close));
    nc_end(w);
}
