/*
 * step_assembly - which representations of a STEP file are one, and which are placed in another
 * (ISO 10303-43 relations, ISO 10303-44 product structure, as AP203, AP214 and AP242 use them).
 */
#ifndef CLOUDMILL_STEP_ASSEMBLY_H
#define CLOUDMILL_STEP_ASSEMBLY_H

#include "math/transform.h"
#include "step.h"

/* A representation that is placed in another one. */
struct step_component {
    long relation; /* the instance that says so */
    long parent, child;
    long child_axes, parent_axes; /* axis placements that come to lie on each other */
    struct transform to;          /* from the child's lengths to the parent's, without units */
    struct transform at;          /* the place in the parent */
};

/* Representations that are one: by a relation without a transformation. */
struct step_alias {
    long id, same;
};

struct step_assembly {
    struct {
        size_t n, cap;
        struct step_component *item;
    } component;
    struct {
        size_t n, cap;
        struct step_alias *item; /* by id; each points towards the one that stands for all */
    } alias;
};

/*
 * Reads all relations.  Of a relation with a transformation the first representation is the
 * component; where the NEXT_ASSEMBLY_USAGE_OCCURRENCE that belongs to it names them the other way
 * round, as some systems write it, they are turned.  The caller frees it also after an error.
 */
int step_assembly_read(const struct step *step, struct step_assembly *assembly,
                       struct error *error);

/* Is it the same as another representation? */
bool step_assembly_is_alias(const struct step_assembly *assembly, long id);

/* The representation that stands for this one and all that are the same. */
long step_assembly_leader(const struct step_assembly *assembly, long id);

/* The transformation back, of a rotation and a shift. */
struct transform step_assembly_inverse(const struct transform *t);

/* Of a shape, not of a picture of one: MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION. */
bool step_is_representation(const struct step_value *record);

/* The number of the instance that a value refers to, or 0. */
long step_reference(const struct step_value *value);

void step_assembly_free(struct step_assembly *assembly);

#endif
