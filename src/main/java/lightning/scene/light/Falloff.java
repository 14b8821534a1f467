package lightning.scene.light;

import lightning.scene.value.Attenuation;

/** Law by which a light with a position loses strength with distance. */
public enum Falloff {
    /** The light's {@link Attenuation} (paper §2.2). */
    CUSTOM,
    /** 1/d² at distance d in scene units, limited only where a part of the light of one sample could not be brighter. */
    INVERSE_SQUARE;

    /** Largest falloff: 1/d² at a distance of 10⁻⁶ scene units. */
    static final double MAX = 1e12;

    /**
     * Returns the largest falloff of a light. Each of the n samples of an area A is a patch of A/n. It would fill the view of a surface that
     * it touches, and give at most nπ/A of the light of one scene unit away. The ball of a point light is seen as a disc.
     */
    double max(LightType type, AreaShape area) {
        int samples = area.hardShadows() ? 1 : area.samples();
        double limit = switch (type) {
            case DIRECTIONAL -> 1;
            case RECT -> samples * Math.PI / (area.width() * area.height());
            case TUBE -> samples * Math.PI / (2 * area.radius() * area.height());
            case POINT, SPOT, DISC -> samples / (area.radius() * area.radius());
            case OBJECT -> area.samples() * Math.PI / area.surface().map(ObjectSurface::area).orElse(0.0);
        };
        return this == CUSTOM ? 1 : Math.min(limit, MAX);
    }
}
