package lightning.effects;

/** The parts of the picture that a scene may or may not call for. */
public enum Effect {
    SHADOWS("shadows"),
    SPECULAR("specular highlights"),
    TEXTURES("textures"),
    REFLECTION("reflection"),
    ATTENUATION("attenuation"),
    SPOT_CONE("cones of light"),
    DROPOFF("dropoff"),
    DIRECTIONAL_LIGHTS("directional lights"),
    POINT_LIGHTS("point lights"),
    SPOT_LIGHTS("spot lights"),
    SPHERES("spheres"),
    CONES("cones"),
    CYLINDERS("cylinders"),
    PLANES("planes");

    private final String title;

    Effect(String title) {
        this.title = title;
    }

    /** For people, lower case, in the plural where there is one. */
    public String title() {
        return title;
    }
}
