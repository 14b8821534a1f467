package lightning.render.trace.solid;

/** Which end of a way lies on the surface of the solid that it may cut. Such a surface does not come between at that end. */
public enum SurfaceContact {
    /** None: the solid is met wherever the ray first crosses its surface. */
    NONE,
    /** Where it begins, at the eye: the solid is met on its far side, if the ray goes through it, and not where it begins. */
    START,
    /** Where it ends, at distance 1, at a light: the solid is met where the ray enters it, if it then goes through it to the light. */
    END
}
