/*
 * keys - `key = value` text into the fields of a struct, by a table of the keys.
 */
#ifndef CLOUDMILL_KEYS_H
#define CLOUDMILL_KEYS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"

enum key_kind {
    KEY_NUMBER, /* double */
    KEY_COUNT,  /* int */
    KEY_YES,    /* bool: yes or no */
    KEY_TEXT,   /* char[size] */
    KEY_VECTOR, /* struct vec3: three numbers, blanks between */
    KEY_CHOICE  /* int: index of the word among `words`, "one|two|three" */
};

enum { KEY_NAME = 20 };

struct key {
    char name[KEY_NAME];
    enum key_kind kind;
    void *value;
    double min, max; /* NUMBER, COUNT: both 0: no bounds */
    size_t size;     /* TEXT: room with the '\0' */
    const char *words;
    size_t line; /* where it was last set, 0: not in this file */
};

struct keys {
    size_t n, cap;
    struct key *item;
    const char *of; /* whose keys they are, for messages; NULL: a machine's */
};

/* Adds a key to the table; the caller fills in bounds, size and words. */
struct key *keys_add(struct keys *keys, const char *name, enum key_kind kind, void *value);

/*
 * Sets one key from `key = value` (changed in place).  name and line are the place for messages;
 * line 0, of a setting on the command line, may set a key again.
 */
int keys_set(struct keys *keys, char *text, const char *name, size_t line, struct error *error);

/* The key of that name, NULL: none. */
struct key *keys_find(const struct keys *keys, const char *name);

/* The text has a # before a digit or [, as the parameters of controls do: it would start a comment
 * that may not have been meant as one. */
bool keys_hash_meant(const char *text);
#define KEYS_HASH_MEANT                                                                         \
    "found # before a digit or [, expected {hash} where a block is to have that sign, a blank " \
    "after it where a comment starts"

/* The text without blanks around and without a `#` comment, ended in place. */
char *keys_trim(char *text);

#endif
