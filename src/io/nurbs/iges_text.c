/* iges_text - see iges_text.h. */
#include "iges_text.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/num.h"

enum { WORD_MAX = 80 };

/* Parameters end in column 64; some writers run on into column 65, in front of the pointer back to
 * the directory, which is right-justified in 66 to 72 but may begin with a nought in 65. */
static size_t width_of(const struct iges_cursor *c)
{
    if (c->entity == 0 || c->record->text[c->width] == ' ')
        return c->width;
    char pointer[9] = {0};
    memcpy(pointer, c->record->text + c->width, 8);
    return atoi(pointer) != c->entity && atoi(pointer + 1) == c->entity ? c->width + 1 : c->width;
}

size_t iges_line(const struct iges_cursor *c)
{
    return c->records > 0 ? c->record->line : c->record[-1].line;
}

char iges_peek(struct iges_cursor *c)
{
    while (c->records > 0 && c->column >= width_of(c)) {
        c->record++;
        c->records--;
        c->column = 0;
    }
    return c->records > 0 ? c->record->text[c->column] : '\0';
}

char iges_take(struct iges_cursor *c)
{
    char ch = iges_peek(c);
    if (ch != '\0')
        c->column++;
    return ch;
}

static int take_text(struct iges_cursor *c, long length, char *text, size_t size,
                     struct error *error)
{
    for (long i = 0; i < length; i++) {
        char ch = iges_take(c);
        if (ch == '\0')
            return error_at(error, c->name, iges_line(c),
                            "a text of %ld characters that the file does not hold, expected them",
                            length);
        if ((size_t)i + 1 < size)
            text[i] = ch;
    }
    text[(size_t)length < size ? (size_t)length : size - 1] = '\0';
    return 0;
}

static int word_value(struct iges_cursor *c, const char *word, struct iges_value *value,
                      struct error *error)
{
    const char *end = word;
    value->kind = IGES_NUMBER;
    if (!num_read(&end, &value->number) || *end != '\0')
        return error_at(error, c->name, value->line, "'%.40s', expected a number", word);
    if (!isfinite(value->number))
        return error_at(error, c->name, value->line, "'%.40s', expected a finite number", word);
    return 0;
}

int iges_next(struct iges_cursor *c, struct iges_value *value, char *text, size_t size,
              struct error *error)
{
    char word[WORD_MAX + 1];
    size_t n = 0;
    *value = (struct iges_value){.kind = IGES_DEFAULT};
    text[0] = '\0';
    for (;;) {
        char ch = iges_take(c);
        if (n == 0 && value->kind == IGES_DEFAULT)
            value->line = iges_line(c);
        if (ch == '\0')
            return error_at(error, c->name, iges_line(c),
                            "parameters that end without '%c', expected it: the file is cut short",
                            c->semicolon);
        word[n] = '\0';
        if (ch == c->comma || ch == c->semicolon) {
            if (n > 0 && value->kind != IGES_TEXT && word_value(c, word, value, error) < 0)
                return -1;
            return ch == c->comma ? 1 : 2;
        }
        if (ch == ' ' || value->kind == IGES_TEXT)
            continue;
        if (ch == 'H' && n > 0 && strspn(word, "0123456789") == n && n < 7) {
            value->kind = IGES_TEXT;
            if (take_text(c, atol(word), text, size, error) < 0)
                return -1;
            continue;
        }
        if (n == WORD_MAX || iscntrl((unsigned char)ch))
            return error_at(error, c->name, value->line,
                            "a parameter of more than %d characters, or with control characters, "
                            "expected a number",
                            WORD_MAX);
        word[n++] = ch;
    }
}
