/*
 * step - a STEP file (ISO 10303-21, clear text) as instances and their attributes; what the
 * entities mean is in step_geometry.h and step_model.h.
 *
 * The whole text is kept; an instance is found by its number and its attributes are read when they
 * are asked for, so that nothing is stored on the word of a count.
 */
#ifndef CLOUDMILL_STEP_H
#define CLOUDMILL_STEP_H

#include <stdbool.h>

#include "base/error.h"
#include "base/reader.h"

struct step_instance {
    long id;
    size_t at;   /* of what follows its `=`, in the text */
    size_t line; /* of the file */
};

struct step {
    char *name;   /* of the file */
    size_t lines; /* up to its end */
    struct {
        size_t n, cap;
        char *item;
    } text;
    struct {
        size_t n, cap;
        struct step_instance *item; /* by id */
    } instance;
};

enum step_kind {
    STEP_UNSET, /* $ or * */
    STEP_NUMBER,
    STEP_REFERENCE, /* #id: its number */
    STEP_TEXT,      /* 'text' or "binary" */
    STEP_ENUM,      /* .NAME. */
    STEP_LIST,
    STEP_RECORD /* NAME(...) */
};

/* A value; those inside a list or a record follow it. */
struct step_value {
    enum step_kind kind;
    double number;
    const char *text; /* of a text, an enum's or a record's name */
    size_t length;
    size_t size; /* of values: itself and all inside it */
};

struct step_values {
    size_t n, cap;
    struct step_value
        *item; /* item[0] is a list of records: one, or several of a complex instance */
    const struct step_instance *instance;
};

/* Reads the whole of a STEP file from a reader that stands at its start. */
int step_read(struct reader *r, struct step *step, struct error *error);

/* The instance of this number, or NULL. */
const struct step_instance *step_find(const struct step *step, long id);

/* The attributes of an instance.  The caller frees them (array_free). */
int step_values(const struct step *step, const struct step_instance *instance,
                struct step_values *values, struct error *error);

/* The record of this name among those of an instance, or NULL. */
const struct step_value *step_record(const struct step_values *values, const char *name);

bool step_is(const struct step_value *value, const char *name);

/* The attribute of this number, from 0, of a list or a record; NULL when there is none. */
const struct step_value *step_item(const struct step_value *list, size_t index);

/* Attribute `index` of an entity of which the first one is the name: in a complex instance the name
 * stands in a record of its own. */
const struct step_value *step_own(const struct step_values *values, const struct step_value *record,
                                  size_t index);

/* The one after it in the same list, or NULL: for going through a list. */
const struct step_value *step_next(const struct step_value *list, const struct step_value *item);

void step_free(struct step *step);

#endif
