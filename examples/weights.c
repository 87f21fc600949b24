/* Constants of a small program that subdivides triangle meshes. */
#define VALENCES 6

/* Loop's weight of each neighbour of a vertex, for the valences 3 to 8. */
static const float neighbour_weight[VALENCES] = {
    0.1875f,
    0.121094f,
    0.084093f,
    0.0625f,   /* regular */
    0.049025f,
    0.040086f,
};

/* The new point of an edge, from its ends and the two opposite vertices. */
static const double edge_weight[] = { 3.0 / 8.0, 3.0 / 8.0, 1.0 / 8.0, 1.0 / 8.0 };
