/* view - see view.h. */
#include "view.h"

struct view view_from(enum view_name name)
{
    const double r2 = sqrt(0.5), r3 = sqrt(1.0 / 3), r6 = sqrt(1.0 / 6);
    switch (name) {
    case VIEW_ISO:
        return (struct view){vec(r2, r2, 0), vec(-r6, r6, 2 * r6), vec(r3, -r3, r3)};
    case VIEW_FRONT:
        return (struct view){vec(1, 0, 0), vec(0, 0, 1), vec(0, -1, 0)};
    case VIEW_SIDE:
        return (struct view){vec(0, 1, 0), vec(0, 0, 1), vec(1, 0, 0)};
    default:
        return (struct view){vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1)};
    }
}

struct vec3 view_point(const struct view *view, struct vec3 p)
{
    return vec(vec_dot(view->right, p), vec_dot(view->up, p), vec_dot(view->toward, p));
}
