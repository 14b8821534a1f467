package lightning.scene.light;

/** Term of the lighting equation that a light's attribute changes, from the cheapest change to the most expensive. */
public enum LightTerm {
    /** The light's own surface in the picture, which is no part of its contributions. */
    FACE,
    /** Color times intensity and gains, the factors of all contributions. */
    WEIGHT,
    /** Falloff with distance and direction. */
    FALLOFF,
    /** Cone angle: a larger one adds points, a smaller one removes points. */
    CONE_ANGLE,
    /** Cone axis: changes which points are in the cone. */
    CONE_AXIS,
    /** Shapes that it illuminates. */
    ILLUMINATION_LINKS,
    /** Shapes that cast shadows in its light. */
    SHADOW_LINKS,
    /** Position or direction: changes which points face the light and see it. */
    SOURCE
}
