package lightning.scene;

/** What of the lighting equation a light's attribute changes, from the cheapest change to the dearest. */
public enum LightTerm {
    /** Color times intensity, with which all that a light adds is multiplied. */
    WEIGHT,
    /** How it fades with distance and with the direction in which it shines. */
    FALLOFF,
    /** How wide its cone is: a larger value lets points in, a smaller one puts points out. */
    CONE_ANGLE,
    /** Which points are in its cone, whatever the opening. */
    CONE_AXIS,
    /** Which shapes it shines on. */
    ILLUMINATION_LINKS,
    /** Which shapes throw shadows in its light. */
    SHADOW_LINKS,
    /** Where it shines from: which points face it and which see it. */
    SOURCE
}
