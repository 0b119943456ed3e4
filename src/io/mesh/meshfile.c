/* meshfile - see meshfile.h. */
#include "io/mesh/meshfile.h"

#include <string.h>

#include "off.h"
#include "io/mesh/ply.h"
#include "ply_origin.h"
#include "io/mesh/stl.h"

enum { HEAD = 4096 }; /* bytes that tell what a file is */

static bool head_begins(const char *head, size_t n, const char *word)
{
    return n >= strlen(word) && memcmp(head, word, strlen(word)) == 0;
}

static bool is_text(const char *head, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        if ((unsigned char)head[i] < ' ' && !memchr("\t\n\v\f\r", head[i], 5))
            return false;
    }
    return true;
}

static int read_from(struct reader *r, struct mesh *mesh, struct error *error)
{
    const char *head;
    long got = reader_peek(r, &head, HEAD, error);
    if (got < 0)
        return -1;
    size_t n = (size_t)got;
    bool text = is_text(head, n);

    *mesh = (struct mesh){.origin = ply_origin_none()};
    if (head_begins(head, n, "ply"))
        return ply_read_mesh(r, mesh, error);
    if (head_begins(head, n, "OFF") || head_begins(head, n, "COFF") || head_begins(head, n, "NOFF"))
        return off_read(r, mesh, error);
    if (n > 0 && (!text || stl_is_binary(r, head, n)))
        return stl_read_binary(r, mesh, error);
    if (head_begins(head, n, "solid"))
        return stl_read_text(r, mesh, error);
    return ply_read_mesh(r, mesh, error);
}

int mesh_read(const char *file, struct mesh *mesh, struct error *error)
{
    struct reader r;
    if (reader_open(&r, file, error) < 0)
        return -1;
    int status = read_from(&r, mesh, error);
    reader_close(&r);
    if (status < 0)
        mesh_free(mesh);
    return status;
}
