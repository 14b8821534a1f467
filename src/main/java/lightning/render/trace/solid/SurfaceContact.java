package lightning.render.trace.solid;

/** End of a ray that lies on the surface of the solid to intersect. At that end the surface does not block the ray. */
public enum SurfaceContact {
    /** Neither end: the hit is the first crossing of the surface. */
    NONE,
    /** Start, at the eye: the hit is on the far side if the ray passes through the solid, never at the start. */
    START,
    /** End, at distance 1, at a light: the hit is the entry into the solid if the ray then passes through it to the light. */
    END
}
