/*
 * surface_contacts - where planes cut a mesh, put on the NURBS surfaces that it was made from.
 */
#ifndef CLOUDMILL_SURFACE_CONTACTS_H
#define CLOUDMILL_SURFACE_CONTACTS_H

#include "nurbs/project.h"
#include "toolpath/slice.h"

struct surface_contacts {
    const struct projection *on;
    struct vec3 plane; /* unit normal of the planes */
    double reach;      /* of a point to its surface, mm */
    double radius;     /* of the ball, mm */
    double off;        /* how far a smooth curve of the centres may be off between contacts, mm */
    int threads;       /* as of parallel_for */
};

/*
 * Moves the contacts of the chains onto the surfaces (project_contact), and puts others between
 * two that are on them while the curve of the centres (run_tangents) is farther off half way than
 * it may be: where a plane grazes a surface, the edges of a coarse mesh are far apart on it.
 * Returns how many have no surface within reach; they stay where they are.
 */
size_t surface_contacts_put(const struct surface_contacts *rule, struct slice_chains *chains);

#endif
