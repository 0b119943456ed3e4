/* keys - see keys.h. */
#include "machine/keys.h"

#include <stdio.h>
#include <string.h>

#include "base/array.h"
#include "base/num.h"
#include "math/vec.h"

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\f';
}

char *keys_trim(char *text)
{
    while (is_blank(*text))
        text++;
    size_t n = strcspn(text, "#");
    while (n && is_blank(text[n - 1]))
        n--;
    text[n] = '\0';
    return text;
}

bool keys_hash_meant(const char *text)
{
    const char *hash = strchr(text, '#');
    return hash && hash[1] && strchr("0123456789[", hash[1]);
}

struct key *keys_add(struct keys *keys, const char *name, enum key_kind kind, void *value)
{
    struct key *key = array_push(keys);
    *key = (struct key){.kind = kind, .value = value};
    snprintf(key->name, sizeof key->name, "%s", name);
    return key;
}

struct key *keys_find(const struct keys *keys, const char *name)
{
    for (size_t i = 0; i < keys->n; i++)
        if (strcmp(keys->item[i].name, name) == 0)
            return &keys->item[i];
    return NULL;
}

static int set_number(const struct key *key, const char *text, const char *name, size_t line,
                      struct error *error)
{
    double value;
    if (!num_whole(text, &value))
        return error_at(error, name, line, "%s: found `%.40s`, expected a number", key->name, text);
    if ((key->min != 0 || key->max != 0) && !(value >= key->min && value <= key->max))
        return error_at(error, name, line, "%s: found `%.40s`, expected %g to %g", key->name, text,
                        key->min, key->max);
    if (key->kind == KEY_COUNT) {
        if (value != (double)(int)value)
            return error_at(error, name, line, "%s: found `%.40s`, expected a whole number",
                            key->name, text);
        *(int *)key->value = (int)value;
    } else {
        *(double *)key->value = value;
    }
    return 0;
}

static int set_vector(const struct key *key, const char *text, const char *name, size_t line,
                      struct error *error)
{
    double v[3];
    const char *s = text;
    for (int i = 0; i < 3; i++) {
        while (is_blank(*s))
            s++;
        if (!num_read(&s, &v[i]) || !isfinite(v[i]) || (*s && !is_blank(*s)))
            return error_at(error, name, line, "%s: found `%.40s`, expected three numbers",
                            key->name, text);
    }
    if (*s)
        return error_at(error, name, line, "%s: found `%.40s`, expected three numbers", key->name,
                        text);
    *(struct vec3 *)key->value = vec(v[0], v[1], v[2]);
    return 0;
}

static int set_choice(const struct key *key, const char *text, const char *name, size_t line,
                      struct error *error)
{
    const char *words = key->kind == KEY_YES ? "no|yes" : key->words;
    int i = 0;
    for (const char *word = words;; i++) {
        size_t n = strcspn(word, "|");
        if (strlen(text) == n && strncmp(word, text, n) == 0)
            break;
        if (!word[n])
            return error_at(error, name, line, "%s: found `%.40s`, expected %s", key->name, text,
                            words);
        word += n + 1;
    }
    if (key->kind == KEY_YES)
        *(bool *)key->value = i == 1;
    else
        *(int *)key->value = i;
    return 0;
}

static int set_value(struct key *key, const char *text, const char *name, size_t line,
                     struct error *error)
{
    switch (key->kind) {
    case KEY_NUMBER:
    case KEY_COUNT:
        return set_number(key, text, name, line, error);
    case KEY_VECTOR:
        return set_vector(key, text, name, line, error);
    case KEY_YES:
    case KEY_CHOICE:
        return set_choice(key, text, name, line, error);
    case KEY_TEXT:
        break;
    }
    if (strlen(text) >= key->size)
        return error_at(error, name, line, "%s: found %zu characters, expected fewer than %zu",
                        key->name, strlen(text), key->size);
    memcpy(key->value, text, strlen(text) + 1);
    return 0;
}

int keys_set(struct keys *keys, char *text, const char *name, size_t line, struct error *error)
{
    size_t n = strcspn(text, "=");
    if (!text[n])
        return error_at(error, name, line, "found `%.40s`, expected key = value", text);
    text[n] = '\0';
    char *word = keys_trim(text), *value = keys_trim(text + n + 1);
    if (!*word)
        return error_at(error, name, line, "found no key before `=`, expected key = value");
    struct key *key = keys_find(keys, word);
    if (!key)
        return error_at(error, name, line, "found `%.40s`, expected a key of a %s", word,
                        keys->of ? keys->of : "machine");
    if (!*value)
        return error_at(error, name, line, "found no value of %s, expected one", word);
    if (line && key->line)
        return error_at(error, name, line, "found %s again, expected it once (line %zu)", word,
                        key->line);
    key->line = line;
    return set_value(key, value, name, line, error);
}
