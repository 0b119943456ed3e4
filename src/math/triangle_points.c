/* triangle_points - see triangle_points.h. */
#include "math/triangle_points.h"

#include "math/elementary.h"

/* By the spacing: rows of points on a triangle, and the points of a row, are so far apart, at
 * most. */
static const double CLOSE = 0.7;

enum { MOST_ROWS = 10000, MOST_OF_ROW = 1000000 };

int triangle_longest_side(const struct vec3 corner[3])
{
    int longest = 0;

    for (int k = 1; k < 3; k++)
        if (vec_distance(corner[k], corner[(k + 1) % 3]) >
            vec_distance(corner[longest], corner[(longest + 1) % 3]))
            longest = k;
    return longest;
}

void triangle_points(const struct vec3 corner[3], double spacing, struct vec3s *points)
{
    int first = triangle_longest_side(corner);
    struct vec3 a = corner[first], b = corner[(first + 1) % 3], c = corner[(first + 2) % 3];
    double longest = vec_distance(a, b);
    double height = longest > 0 ? vec_length(vec_cross(vec_sub(b, a), vec_sub(c, a))) / longest : 0;
    int rows = (int)fmin(fmax(ceil(height / (CLOSE * spacing)), 1), MOST_ROWS);

    for (int r = 0; r <= rows; r++) { /* the last row half a row before the corner */
        double t = (r < rows ? r : rows - 0.5) / rows;
        struct vec3 p = vec_mix(a, c, t), q = vec_mix(b, c, t);
        int n = (int)fmin(fmax(ceil(vec_distance(p, q) / (CLOSE * spacing)), 1), MOST_OF_ROW);
        for (int i = r == 0; i <= n - (r == 0); i++)
            *array_push(points) = vec_mix(p, q, (double)i / n);
    }
}

double triangle_longest(const struct vec3 corner[3])
{
    int first = triangle_longest_side(corner);

    return vec_distance(corner[first], corner[(first + 1) % 3]);
}
