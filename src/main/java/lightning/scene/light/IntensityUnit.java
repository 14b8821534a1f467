package lightning.scene.light;

/**
 * Unit of a light's intensity. A photometric unit makes a linear value of 1 in the picture a luminance of 1 nit. White paper that faces a
 * light of relative intensity 1 and falloff 1 has the value 1.
 */
public enum IntensityUnit {
    /** Value of white paper at falloff 1. */
    RELATIVE,
    /**
     * Luminous intensity along the axis, of a tube to its side, of an object as if its surface were flat; of a directional light, as
     * {@link #LUX}.
     */
    CANDELA,
    /** Luminous flux of the whole light; of a directional light, per square meter. */
    LUMEN,
    /** Illuminance of a surface that faces a directional light; of another light, at a distance of 1 meter. */
    LUX,
    /** Luminance of the light's surface: a light without size is dark. */
    NIT;

    /** Smallest solid angle of a spot's cone, steradians. */
    private static final double MIN_SOLID_ANGLE = 1e-9;

    /** Returns whether it is usual for a light of this type and size. */
    public boolean isUsualFor(Light light) {
        return switch (this) {
            case RELATIVE -> true;
            case CANDELA, LUMEN -> light.type().hasPosition();
            case LUX -> !light.type().hasPosition();
            case NIT -> light.isArea();
        };
    }

    /**
     * Returns the relative intensity of one unit.
     *
     * @param light  the light's type, cone and size are read
     * @param meters meters per scene unit
     */
    public double relative(Light light, double meters) {
        boolean positioned = light.type().hasPosition();
        return switch (this) {
            case RELATIVE -> 1;
            case CANDELA, LUX -> ofIlluminance(1, positioned, meters);
            case LUMEN -> ofIlluminance(positioned ? 1 / solidAngle(light) : 1, positioned, meters);
            case NIT -> luminousArea(light) / Math.PI;
        };
    }

    /** Returns the relative intensity for an illuminance in lux, 1 meter from the light or of a directional light. */
    private static double ofIlluminance(double lux, boolean positioned, double meters) {
        return positioned ? lux / (Math.PI * meters * meters) : lux / Math.PI;
    }

    /** Returns the flux of a light of 1 candela along its axis, with its cone and spread, without doors, gobo and profile. */
    private static double solidAngle(Light light) {
        return switch (light.type()) {
            case DIRECTIONAL -> 1;
            case POINT -> 4 * Math.PI;
            // The sine of the angle from its axis, over all directions.
            case TUBE -> Math.PI * Math.PI;
            case OBJECT -> Math.PI * light.area().surface().map(s -> s.emittingArea() / s.area()).orElse(1.0);
            case RECT, DISC -> Math.max(light.beam().flux(1 + light.dropoff()), MIN_SOLID_ANGLE);
            case SPOT -> {
                double n = light.dropoff() + 1;
                double edge = StrictMath.cos(Math.toRadians(light.dropoff() > 0 ? Math.min(light.angle(), 90) : light.angle()));
                yield Math.max(2 * Math.PI * (1 - (n == 1 ? edge : StrictMath.pow(Math.max(edge, 0), n))) / n, MIN_SOLID_ANGLE);
            }
        };
    }

    /** Returns the area that is seen along the axis, of a tube from its side, of an object its whole surface, in square scene units; of a directional light, its projected solid angle. */
    public static double luminousArea(Light light) {
        AreaShape area = light.area();
        return switch (light.type()) {
            case DIRECTIONAL -> Math.PI * square(StrictMath.sin(Math.toRadians(area.spread())));
            case RECT -> area.width() * area.height();
            case TUBE -> 2 * area.radius() * area.height();
            case POINT, SPOT, DISC -> Math.PI * square(area.radius());
            case OBJECT -> area.surface().map(ObjectSurface::area).orElse(0.0);
        };
    }

    private static double square(double v) {
        return v * v;
    }
}
