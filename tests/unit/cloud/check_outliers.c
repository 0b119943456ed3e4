/* outliers: what was put into known clouds is found, and nothing else is. */
#include <check.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "noisy.h"
#include "panel.h"
#include "cloud/outliers.h"
#include "cloud/outliers_kept.h"

static struct vec3s scan;
static struct point_grid point_grid;
static unsigned char *out;

static double roof(double x, double y)
{
    return 12 - 0.5 * fabs(x + 0.2 * y);
}

static double terraces(double x, double y)
{
    return 4 * floor((x + 0.3 * y) / 12.5);
}

static void sort(void)
{
    struct error error;
    ck_assert_int_eq(point_grid_make(scan.item, scan.n, 0.48, 2, &point_grid, &error), 0);
    out = mem_alloc(scan.n, 1);
}

static void free_all(void)
{
    point_grid_free(&point_grid);
    array_free(&scan);
    free(out);
    out = NULL;
}

/* Of the points marked, those 0.4 mm and more off the surface. */
static size_t marked_off(double (*height)(double, double))
{
    size_t n = 0;
    for (size_t i = 0; i < point_grid.n; i++) {
        struct vec3 p = point_grid.point[i];
        n += out[i] && fabs(p.z - height(p.x, p.y)) > 0.4;
    }
    return n;
}

/* What happens n times in the mean happens no more often than this: four deviations of the law of
 * rare events, and one for its skew. */
static size_t by_chance(double n)
{
    return (size_t)(n + 4 * sqrt(n) + 1);
}

/* Below a surface a point is believed where it ends above it: where, seen from above, no point is
 * in three eighths of the turn about it within 2.5 spacings, in which there are m = 19.6 in the
 * mean.  Of random points so wide a gap is there at m e^(-3 m / 8) of the places, one of 80. */
static double rim_by_chance(double strays)
{
    const double m = PI * 2.5 * 2.5;
    return strays * m * exp(-3 * m / 8);
}

/* 100 points 0.5 to 20 mm above or below, on clean and noisy scans of every pattern. */
START_TEST(outliers)
{
    const double sigma = _i / 3 * 0.02;
    noisy_seed(4);
    noisy_scan(&scan, panel_height, 17000, (enum noisy_pattern)(_i % 3), sigma);
    for (size_t i = 0; i < 100; i++) {
        size_t at = i * scan.n / 100 + 31;
        scan.item[at].z += (i % 2 ? 1 : -1) * (0.5 + 19.5 * pow(noisy_uniform(), 3));
    }
    sort();
    size_t found = outliers_isolated(&point_grid, sigma, 2, out), right = marked_off(panel_height);
    /* of the 50 below the surface those are believed that are so near to the border that nothing is
     * in three eighths of the turn about them, or about half a spacing further out: 0.38 of 2.5
     * spacings and that half, of 0.48 mm, in 74 x 54; and those below a gap of random points */
    const double near = 2 * (0.38 * 2.5 + 0.5) * 0.48;
    double believed = 50 * (1 - (1 - near / 74) * (1 - near / 54));
    believed += _i % 3 == NOISY_RANDOM ? rim_by_chance(50) : 0;
    ck_assert_uint_ge(right, 100 - by_chance(believed));
    /* points that strays beside them make look wrong */
    ck_assert_uint_le(found - right, by_chance(0.3));
}
END_TEST

START_TEST(clumps_in_the_air)
{
    noisy_seed(4);
    noisy_scan(&scan, terraces, 17000, NOISY_RANDOM, 0.02);
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 6; k++)
            *array_push(&scan) = vec(-30 + 18 * i + 0.3 * noisy_uniform(), 10 + 0.2 * k, 30);
    sort();
    size_t found = outliers_isolated(&point_grid, 0.02, 2, out), right = 0;
    for (size_t i = 0; i < point_grid.n; i++)
        right += out[i] && point_grid.point[i].z > 25;
    ck_assert_uint_eq(right, 24);
    ck_assert_uint_le(found - right, by_chance(0.5)); /* of the points at the steps */
}
END_TEST

/* Edges and steps are no outliers. */
START_TEST(edges)
{
    noisy_seed(4);
    noisy_scan(&scan, _i % 2 ? roof : terraces, 17000, NOISY_LINES, _i / 2 * 0.02);
    sort();
    ck_assert_uint_le(outliers_isolated(&point_grid, _i / 2 * 0.02, 2, out), 2);
    ck_assert_uint_eq(outliers_under_roof(&point_grid, 2, out), 0);
}
END_TEST

START_TEST(sparse_walls)
{
    /* A step in a dense scan, its wall a tenth as dense; strays over all of it. */
    enum { FLOOR = 20000, WALL = 200, STRAYS = 30 };
    noisy_seed(5 + (unsigned)_i);
    for (int i = 0; i < FLOOR; i++) {
        double x = 60 * noisy_uniform() - 30, y = 40 * noisy_uniform();
        *array_push(&scan) = vec(x, y, (x < 0 ? 0 : 6) + 0.02 * noisy_normal());
    }
    for (int i = 0; i < WALL; i++)
        *array_push(&scan) = vec(0.02 * noisy_normal(), 40 * noisy_uniform(), 6 * noisy_uniform());
    for (int i = 0; i < STRAYS; i++)
        *array_push(&scan) = vec(i % 2 ? 60 * noisy_uniform() - 30 : 0.5 * noisy_normal(),
                                 40 * noisy_uniform(), 14 + 26 * noisy_uniform());
    sort();
    size_t found = outliers_isolated(&point_grid, 0.02, 2, out), right = 0, kept = 0;
    for (size_t i = 0; i < point_grid.n; i++) {
        right += out[i] && point_grid.point[i].z > 10;
        /* over the wall it may lie in the wall's plane, or on a cliff with two others */
        kept += !out[i] && point_grid.point[i].z > 10 && fabs(point_grid.point[i].x) > 2;
    }
    /* elsewhere with another in its cell of two spacings: so many pairs are there by chance */
    ck_assert_uint_le(kept, by_chance(0.5 * STRAYS * STRAYS * 0.96 * 0.96 / (60 * 40)));
    ck_assert_uint_ge(right, STRAYS - by_chance(1));
    ck_assert_uint_le(found - right, WALL / 8);
}
END_TEST

/* A plateau with an elliptic rim, its wall nearly upright. */
static double bluff(double x, double y)
{
    double beyond = 1 - hypot(x / 22, y / 30);
    return 8 * fmin(fmax(beyond / 0.02, 0), 1) + 0.03 * x + 0.002 * y * y;
}

/* Points of a wall seen from above are few and far apart on it: they are all believed, whatever the
 * scan is measured or said to be; strays above the rim and below the foot are not. */
START_TEST(walls_seen_from_above)
{
    enum { POINTS = 25000, STRAYS = 40 };
    size_t (*find)(const struct point_grid *, double, int, unsigned char *) =
        _i % 2 ? outliers_floating : outliers_isolated;
    size_t right = 0;

    noisy_seed(11 + (unsigned)_i / 2);
    for (int i = 0; i < POINTS; i++) {
        double x = 64 * noisy_uniform() - 32, y = 72 * noisy_uniform() - 36;
        *array_push(&scan) = vec(x, y, bluff(x, y));
    }
    for (int i = 0; i < STRAYS; i++) {
        double turn = 2 * PI * i / STRAYS, part = i % 4 < 2 ? 0.7 + 0.02 * i / STRAYS : 0.99;
        double x = 22 * part * cos(turn), y = 30 * part * sin(turn);
        *array_push(&scan) = vec(x, y, i % 2 ? 20 + 10 * noisy_uniform() : -6 - noisy_uniform());
    }
    sort();
    size_t found = find(&point_grid, 0, 2, out);
    ck_assert_uint_le(found, STRAYS + by_chance(0.05)); /* some 400 on the wall */
    for (size_t i = 0; i < point_grid.n; i++)
        right += out[i] && fabs(point_grid.point[i].z - 5.5) > 9;
    ck_assert_uint_ge(right, STRAYS - by_chance(rim_by_chance(STRAYS / 2)));
    ck_assert_uint_le(right, STRAYS);
}
END_TEST

/* A plate with a rim turned down at its outline, and of the wall below only a few points, each far
 * from all others: they are believed.  Strays as far below the middle, or above the rim, are
 * not. */
START_TEST(below_a_rim)
{
    enum { POINTS = 16000, WALL = 24, STRAYS = 24 };
    size_t right = 0, walls = 0;

    noisy_seed(31 + (unsigned)_i);
    for (int i = 0; i < POINTS; i++) {
        double turn = 2 * PI * noisy_uniform(), r = sqrt(noisy_uniform()), in = 25 * (1 - r);
        double z = in < 0.5 ? -0.5 + sqrt(fmax(0, 0.25 - (0.5 - in) * (0.5 - in))) : 0;
        *array_push(&scan) = vec(25 * r * cos(turn), 25 * r * sin(turn), z);
    }
    for (int i = 0; i < WALL; i++) {
        double turn = 2 * PI * (i + 0.6 * noisy_uniform()) / WALL;
        double r = i % 3 ? 25 : 24.9; /* undercut a little, too */
        *array_push(&scan) = vec(r * cos(turn), r * sin(turn), -5 - 5 * noisy_uniform());
    }
    for (int i = 0; i < STRAYS; i++) {
        double turn = 2 * PI * i / STRAYS, r = i % 2 ? 25 : 23 * sqrt(noisy_uniform());
        *array_push(&scan) = vec(r * cos(turn), r * sin(turn),
                                 i % 2 ? 4 + 5 * noisy_uniform() : -5 - 5 * noisy_uniform());
    }
    sort();
    size_t found = outliers_isolated(&point_grid, 0, 2, out);
    for (size_t i = 0; i < point_grid.n; i++) {
        struct vec3 p = point_grid.point[i];
        bool wall = p.z < -2 && hypot(p.x, p.y) > 24;
        walls += wall && out[i];
        right += out[i] && !wall && fabs(p.z) > 2;
    }
    /* Of a straight rim the middle of the m points above, within 2.5 of the grid's spacings, has to
     * be a quarter of that away and is 0.42 in the mean, 0.26 / sqrt(m) about it; m is 18: that is
     * 2.8 deviations */
    ck_assert_uint_le(walls, by_chance(0.0026 * WALL));
    ck_assert_uint_ge(right, STRAYS - by_chance(rim_by_chance(STRAYS / 2)));
    ck_assert_uint_le(found - right - walls, by_chance(0.05)); /* beside strays */
}
END_TEST

/* A blade that stands on a floor, 0.3 mm thick at its edge and 0.7 at its root, points on both of
 * its sides: they are all believed, at its edge and at its root, turned anyhow, dense and
 * sparse. */
START_TEST(thin_blade)
{
    const double sigma = _i % 2 * 0.005, step = _i / 2 % 2 ? 0.4 : 0.8, turn = 0.4 * _i;
    noisy_seed(11 + (unsigned)_i);
    for (double x = -12; x <= 12; x += step)
        for (double y = -12; y <= 12; y += step) {
            double u = x + 0.5 * step * noisy_uniform(), v = y + 0.5 * step * noisy_uniform();
            double z = 8 * noisy_uniform();
            double half = 0.15 + 0.2 * (1 - z / 8), side = noisy_uniform() < 0.5 ? -1 : 1;
            if (fabs(u) > 0.4)
                *array_push(&scan) = vec(u, v, sigma * noisy_normal());
            if (fabs(x) < 5) /* as many as on the floor */
                *array_push(&scan) = vec(side * (half + sigma * noisy_normal()), v, z);
        }
    for (size_t i = 0; i < scan.n; i++) {
        struct vec3 p = scan.item[i];
        scan.item[i] =
            vec(p.x * cos(turn) - p.y * sin(turn), p.x * sin(turn) + p.y * cos(turn), p.z);
    }
    sort();
    ck_assert_uint_le(outliers_isolated(&point_grid, sigma, 2, out), 1); /* at its border */
    ck_assert_uint_eq(outliers_floating(&point_grid, sigma, 2, out), 0);
}
END_TEST

/* Needles of three to six points on the panel are real, single points as high are not. */
START_TEST(needles)
{
    enum { NEEDLES = 12 };
    const double sigma = _i * 0.01, step = 0.45;
    noisy_seed(21);
    noisy_scan(&scan, panel_height, 17000, NOISY_RANDOM, sigma);
    for (int i = 0; i < NEEDLES; i++) {
        double x = -30 + 5 * i, z = panel_height(x, 3), w = panel_height(x, -11);
        for (int k = 1; k <= 3 + i % 4; k++)
            *array_push(&scan) = vec(x + 0.02 * k, 3, z + step * k);
        *array_push(&scan) = vec(x, -11, w + step * (3 + i % 4));
    }
    sort();
    size_t found = outliers_isolated(&point_grid, sigma, 2, out), right = 0;
    for (size_t i = 0; i < point_grid.n; i++)
        right += out[i] && fabs(point_grid.point[i].y + 11) < 1e-9;
    ck_assert_uint_eq(right, NEEDLES);
    ck_assert_uint_le(found - right, by_chance(1)); /* of the 54 of needles */
}
END_TEST

/* Marks of a row and of single points on a plane: the row is kept, whatever it is marked for. */
START_TEST(marks_in_a_row)
{
    noisy_seed(2);
    for (int i = 0; i < 40; i++)
        for (int k = 0; k < 40; k++)
            *array_push(&scan) = vec(0.5 * i, 0.5 * k, 0);
    for (int k = 0; k < 6; k++)
        *array_push(&scan) = vec(5.1 + 0.1 * (k % 2), 2 + k, 5);
    for (int k = 0; k < 3; k++)
        *array_push(&scan) = vec(15.1, 3 + 5 * k, 5 + k);
    sort();
    for (size_t i = 0; i < point_grid.n; i++)
        out[i] = point_grid.point[i].z > 1;
    outliers_keep(&point_grid, 0, out);
    for (size_t i = 0; i < point_grid.n; i++)
        ck_assert_int_eq(out[i], point_grid.point[i].z > 1 && point_grid.point[i].x > 10);
}
END_TEST

/* The tip of a needle, whose other points are below it at 0.45 and 0.9 mm, is kept; a point between
 * two that are as far, below and above it, is none. */
START_TEST(mark_on_a_needle)
{
    for (int i = 0; i < 40; i++)
        for (int k = 0; k < 40; k++)
            *array_push(&scan) = vec(0.5 * i, 0.5 * k, 0);
    for (int k = 1; k <= 3; k++)
        *array_push(&scan) = vec(5.1, 8, 0.45 * k);
    for (int k = 0; k < 4; k++)
        if (k != 2)
            *array_push(&scan) = vec(15.1, 8, 5 + 0.45 * k);
    sort();
    for (size_t i = 0; i < point_grid.n; i++)
        out[i] =
            fabs(point_grid.point[i].z - 1.35) < 1e-9 || fabs(point_grid.point[i].z - 5.45) < 1e-9;
    outliers_keep(&point_grid, 0, out);
    for (size_t i = 0; i < point_grid.n; i++)
        ck_assert_int_eq(out[i], fabs(point_grid.point[i].z - 5.45) < 1e-9);
}
END_TEST

/* Points a little over a surface are believed, for they may be real, as the highest of a blunt
 * ridge; as little below it they are outliers, and farther off. */
START_TEST(little_over_a_surface)
{
    enum { OVER, HIGH, BELOW, KINDS, EACH = 30 };
    const double off[KINDS] = {0.15, 0.6, -0.15}; /* mm; points are 0.48 mm apart */
    size_t found[KINDS] = {0};

    noisy_seed(31 + (unsigned)_i);
    noisy_scan(&scan, panel_height, 17000, (enum noisy_pattern)_i, 0);
    for (size_t i = 0; i < KINDS * EACH; i++)
        scan.item[i * scan.n / (KINDS * EACH) + 31].z += off[i % KINDS];
    sort();
    size_t all = outliers_isolated(&point_grid, 0, 2, out);
    for (size_t i = 0; i < point_grid.n; i++) {
        struct vec3 p = point_grid.point[i];
        for (size_t k = 0; k < KINDS; k++)
            if (out[i] && fabs(p.z - panel_height(p.x, p.y) - off[k]) < 0.01) {
                found[k]++;
                ck_assert_int_eq(out[i], k == BELOW ? OUTLIERS_BENEATH : OUTLIERS_OUT);
            }
    }
    ck_assert_uint_eq(found[OVER], 0);
    /* but where points are far apart; beside a border or a gap */
    ck_assert_uint_ge(found[HIGH], EACH - by_chance(0.3));
    ck_assert_uint_ge(found[BELOW], EACH - by_chance(0.12 * EACH));
    ck_assert_uint_eq(all, found[HIGH] + found[BELOW]);
}
END_TEST

/* A step of 3 mm whose flank leans out by 0.8 mm and was seen at one place only, 0.3 mm under its
 * rim: a tool that is not told of it would cut it.  Dust that floats beside the rim is none. */
START_TEST(beneath_a_rim)
{
    const struct vec3 seen = {0.6, 1.23, -0.3}, dust = {-4.2, -8.1, 2.5};
    size_t beneath = 0;

    noisy_seed(41 + (unsigned)_i);
    for (int i = 0; i < 9000; i++) {
        double x = 40 * noisy_uniform() - 20, y = 40 * noisy_uniform() - 20;
        if (x < 0 || x > 0.8)
            *array_push(&scan) = vec(x, y, x < 0 ? 0 : -3);
    }
    *array_push(&scan) = seen;
    *array_push(&scan) = dust;
    sort();
    outliers_isolated(&point_grid, 0, 2, out);
    for (size_t i = 0; i < point_grid.n; i++) {
        if (vec_distance(point_grid.point[i], dust) > 0)
            ck_assert_int_ne(out[i], OUTLIERS_OUT);
        else
            ck_assert_int_eq(out[i], OUTLIERS_OUT);
        beneath += out[i] == OUTLIERS_BENEATH;
    }
    ck_assert_uint_le(beneath, 1);
}
END_TEST

/* Spikes 3 mm high and 1.5 mm wide at their foot, 12 mm apart on a floor; or cones of 90 degrees
 * beside each other. */
static double spikes(double x, double y)
{
    return fmax(0, 3 - 4 * hypot(remainder(x, 12), remainder(y, 12)));
}

static double cones(double x, double y)
{
    return -hypot(remainder(x, 12), remainder(y, 12));
}

/* Their tops are real, though quadrics of what is about them are far below: of the points of 28
 * but a few are left out, where no other is near to them. */
START_TEST(tops)
{
    size_t over = 0;

    noisy_seed(100 + (unsigned)_i);
    noisy_scan(&scan, _i / 3 ? cones : spikes, 17000, (enum noisy_pattern)(_i % 3), 0);
    sort();
    outliers_isolated(&point_grid, 0, 2, out);
    for (size_t i = 0; i < point_grid.n; i++) {
        double x = point_grid.point[i].x, y = point_grid.point[i].y;
        over += out[i] && hypot(remainder(x, 12), remainder(y, 12)) < 0.75;
    }
    ck_assert_uint_le(over, by_chance(2));
}
END_TEST

static double dish(double x, double y)
{
    return 0.01 * x * x + 0.002 * x * y - 0.1 * y;
}

/* A part of a scan that was seen at a few places only, more than OUTLIERS_FAR spacings from the
 * next eight: they are believed where they lie on one surface, but not points in the air. */
START_TEST(few_of_a_surface)
{
    enum { ACROSS = 7, ALL = ACROSS * ACROSS };
    const double apart = 4.5, air = _i % 2 * 6;
    size_t found = 0;

    noisy_seed(71 + (unsigned)_i);
    noisy_scan(&scan, dish, 17000, NOISY_RANDOM, _i / 2 * 0.01);
    for (int k = 0; k < ALL; k++) {
        double x = 50 + apart * (k % ACROSS), y = apart * (k / ACROSS - ACROSS / 2);
        *array_push(&scan) = vec(x, y, dish(x, y) + air * (2 * noisy_uniform() - 1));
    }
    sort();
    outliers_isolated(&point_grid, _i / 2 * 0.01, 2, out);
    for (size_t i = 0; i < point_grid.n; i++)
        found += out[i] && point_grid.point[i].x > 49;
    if (_i % 2)
        ck_assert_uint_ge(found, ALL - by_chance(1));
    else
        ck_assert_uint_eq(found, 0);
}
END_TEST

/* Two marks beside each other are of a thin plate that stands on the surface where they are less
 * than two and a half spacings over it; farther over it they are not, nor is a single one, but for
 * one in ten that lies on a plane which others make by chance, and the one beside it. */
START_TEST(marks_of_a_plate)
{
    enum { EACH = 12 };
    const double over[] = {0.9, 1.5, 0.9}, row = 12; /* mm, between one kind and the next */
    size_t lost = 0, missed = 0;

    noisy_seed(51 + (unsigned)_i);
    noisy_scan(&scan, panel_height, 17000, NOISY_RANDOM, 0.01);
    for (int m = 0; m < 3 * EACH; m++)
        for (int k = 0; k < (m / EACH < 2 ? 2 : 1); k++) {
            double x = 5 * (m % EACH) - 28 + 0.4 * k, y = row * (m / EACH) - row;
            *array_push(&scan) = vec(x, y, panel_height(x, y) + over[m / EACH]);
        }
    sort();
    for (size_t i = 0; i < point_grid.n; i++) {
        struct vec3 p = point_grid.point[i];
        out[i] = p.z - panel_height(p.x, p.y) > 0.8;
    }
    outliers_keep(&point_grid, 0.01, out);
    for (size_t i = 0; i < point_grid.n; i++) {
        struct vec3 p = point_grid.point[i];
        bool mark = p.z - panel_height(p.x, p.y) > 0.8, plate = p.y < -row / 2;
        lost += mark && plate && out[i];
        missed += mark && !plate && !out[i];
    }
    ck_assert_uint_eq(lost, 0);
    ck_assert_uint_le(missed, 2 * by_chance(0.2 * EACH) + by_chance(0.1 * EACH));
}
END_TEST

/* A rib 0.5 mm thick that lines 1 mm apart, with points 0.4 mm apart, cross: each saw its top once
 * or twice.  Points as high that stand alone are none of it. */
START_TEST(rib_across_lines)
{
    const double high[] = {0.8, 2}, top = high[_i / 2], sigma = _i % 2 * 0.01;
    size_t ribs = 0, strays = 0, kept = 0, found = 0;

    noisy_seed(8);
    for (int line = 0; line < 40; line++) {
        double shift = 0.4 * noisy_uniform();
        for (int k = 0; k < 100; k++) {
            double x = 0.4 * k + shift, y = line;
            bool rib = line < 20 && fabs(x - 15) < 0.25;
            bool stray = line % 9 == 4 && k == 80;
            double z = (rib || stray ? top : 0) + sigma * (2 * noisy_uniform() - 1);
            *array_push(&scan) = vec(x, y, z);
        }
    }
    sort();
    outliers_isolated(&point_grid, sigma, 2, out);
    for (size_t i = 0; i < point_grid.n; i++) {
        struct vec3 p = point_grid.point[i];
        bool rib = p.z > top / 2 && p.x<20, stray = p.z> top / 2 && p.x > 20;
        ribs += rib;
        strays += stray;
        kept += rib && !out[i];
        found += stray && out[i];
    }
    ck_assert_uint_ge(ribs, 20);
    /* At its ends, and where a line saw it at one side and the next at the other, it is no row: a
     * twentieth of the points is lost (21 seeds), two and two, here 4.5 deviations more; without
     * rows half of them would be. */
    ck_assert_uint_ge(3 * kept, 2 * ribs);
    ck_assert_uint_eq(found, strays);
}
END_TEST

/* A rib 0.4 mm thick and 1 mm high that is straight or goes round, amid points anywhere, as far
 * apart as it is thick: its points are kept, lone ones of any height are not. */
START_TEST(rib_of_points_anywhere)
{
    enum { POINTS = 1736, STRAYS = 12 };
    size_t lost = 0, missed = 0;

    noisy_seed(40 + (unsigned)_i);
    for (int k = 0; k < POINTS; k++) {
        double x = 20 * noisy_uniform() - 10, y = 20 * noisy_uniform() - 10;
        double away = _i % 2 ? x - 6 : hypot(x - 4, y) - 4;
        *array_push(&scan) = vec(x, y, x > -1 && fabs(away) < 0.2 ? 1 : 0);
    }
    for (int k = 0; k < STRAYS; k++)
        *array_push(&scan) = vec(-9 + 2.5 * (k % 3), -9 + 6 * (k / 3), 0.6 + 0.3 * (k * 5 % 12));
    sort();
    outliers_isolated(&point_grid, 0, 2, out);
    for (size_t i = 0; i < point_grid.n; i++) {
        struct vec3 p = point_grid.point[i];
        lost += out[i] && p.x > -1;
        missed += !out[i] && p.x < -1 && p.z > 0.5;
    }
    ck_assert_uint_le(lost, 1); /* where the next is more than six spacings away */
    ck_assert_uint_eq(missed, 0);
}
END_TEST

START_TEST(points_twice)
{
    noisy_seed(4);
    noisy_scan(&scan, panel_height, 3000, NOISY_RANDOM, 0.02);
    size_t n = scan.n;
    for (size_t i = 0; i < n; i += 3)
        for (size_t k = 0; k < 1 + i % 2; k++) {
            struct vec3 p = scan.item[i];
            *array_push(&scan) = p;
        }
    size_t more = scan.n - n;
    sort();
    ck_assert_uint_eq(outliers_twice(&point_grid, out), more);
    point_grid_remove(&point_grid, out);
    memset(out, 0, n);
    ck_assert_uint_eq(point_grid.n, n);
    ck_assert_uint_eq(outliers_twice(&point_grid, out), 0);
}
END_TEST

/* A roof 6 mm above the middle; the ground goes on below it. */
START_TEST(under_a_roof)
{
    noisy_seed(4);
    noisy_scan(&scan, panel_height, 17000, NOISY_RANDOM, 0.02);
    size_t under = 0;
    for (double x = -15; x <= 15; x += 0.4)
        for (double y = -10; y <= 10; y += 0.4)
            for (double z = 25.8; z < 26.05; z += 0.1) /* several in one place */
                *array_push(&scan) = vec(x, y, z);
    sort();
    size_t found = outliers_under_roof(&point_grid, 2, out);
    for (size_t i = 0; i < point_grid.n; i++) {
        struct vec3 p = point_grid.point[i];
        bool inside = fabs(p.x) < 13 && fabs(p.y) < 8 && p.z < 20;
        under += inside;
        ck_assert(!inside || out[i]);
        ck_assert(!out[i] || (fabs(p.x) < 15 && fabs(p.y) < 10 && p.z < 20));
    }
    ck_assert_uint_ge(found, under);
    ck_assert_uint_gt(under, 1000);
}
END_TEST

/* A pocket 6 mm deep: nothing in it is under anything, to its corners. */
START_TEST(a_pocket)
{
    noisy_seed(4);
    for (int i = 0; i < 17000; i++) {
        double x = 74 * noisy_uniform() - 37, y = 54 * noisy_uniform() - 27;
        *array_push(&scan) = vec(x, y, fabs(x) < 12 && fabs(y) < 9 ? 0 : 6);
        if (i < 1000)
            *array_push(&scan) =
                vec(12 + 0.02 * noisy_normal(), 18 * noisy_uniform() - 9, 6 * noisy_uniform());
    }
    sort();
    ck_assert_uint_eq(outliers_under_roof(&point_grid, 2, out), 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("outliers");
    TCase *tests = tcase_create("outliers");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, NULL, free_all);
    tcase_add_loop_test(tests, outliers, 0, 6);
    tcase_add_test(tests, clumps_in_the_air);
    tcase_add_loop_test(tests, sparse_walls, 0, 4);
    tcase_add_loop_test(tests, walls_seen_from_above, 0, 6);
    tcase_add_loop_test(tests, below_a_rim, 0, 3);
    tcase_add_loop_test(tests, edges, 0, 4);
    tcase_add_loop_test(tests, thin_blade, 0, 8);
    tcase_add_loop_test(tests, needles, 0, 2);
    tcase_add_test(tests, marks_in_a_row);
    tcase_add_test(tests, mark_on_a_needle);
    tcase_add_loop_test(tests, little_over_a_surface, 0, 3);
    tcase_add_loop_test(tests, beneath_a_rim, 0, 8);
    tcase_add_loop_test(tests, tops, 0, 6);
    tcase_add_loop_test(tests, few_of_a_surface, 0, 4);
    tcase_add_loop_test(tests, marks_of_a_plate, 0, 4);
    tcase_add_loop_test(tests, rib_across_lines, 0, 4);
    tcase_add_loop_test(tests, rib_of_points_anywhere, 0, 8);
    tcase_add_test(tests, points_twice);
    tcase_add_test(tests, under_a_roof);
    tcase_add_test(tests, a_pocket);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
