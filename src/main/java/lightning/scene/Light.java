package lightning.scene;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;

/**
 * A light with all attributes, whatever its type; the type decides which of them act (paper §4.5). {@link LightAttribute}
 * tells their ranges and units.
 *
 * @param name        unique among all shapes, groups and lights
 * @param color       linear
 * @param direction   where it shines to, any length
 * @param angle       half the opening of a spot's cone
 * @param dropoff     the exponent of a spot's fall from its axis
 * @param area        how large it is
 * @param on          whether it shines
 * @param solo        whether it shines alone: where any light is solo, the others are dark
 * @param lightGroup       the name of the bank that it belongs to; empty where it belongs to none
 * @param illuminates which shapes it shines on
 * @param shadowedBy  which shapes throw shadows in its light
 */
@RecordBuilder
public record Light(String name, LightType type, Rgb color, double intensity, Vec3 position, Vec3 direction,
        Attenuation attenuation, double angle, double dropoff, BarnDoors doors, double feather, Optional<Gobo> gobo,
        Optional<IesProfile> profile, AreaShape area, boolean on,
        boolean solo, String lightGroup, ShapeLinks illuminates, ShapeLinks shadowedBy) implements LightBuilder.With {

    public Light {
        SceneLimits.checkName(name);
        LightAttribute.COLOR.check(color);
        LightAttribute.INTENSITY.check(intensity);
        LightAttribute.POSITION.check(position);
        LightAttribute.DIRECTION.check(direction);
        LightAttribute.ANGLE.check(angle);
        LightAttribute.DROPOFF.check(dropoff);
        LightAttribute.FEATHER.check(feather);
        LightAttribute.RADIUS.check(area.radius());
        LightAttribute.SPREAD.check(area.spread());
        LightAttribute.WIDTH.check(area.width());
        LightAttribute.HEIGHT.check(area.height());
        LightAttribute.UP.check(area.up());
        LightAttribute.SAMPLES.check(area.samples());
        LightAttribute.LIGHT_GROUP.check(lightGroup);
        LightAttribute.ILLUMINATES.check(illuminates);
        LightAttribute.SHADOWED_BY.check(shadowedBy);
    }

    /** A light of which nothing else was said. */
    public static Light of(String name, LightType type) {
        return new Light(name, type, LightAttribute.COLOR.initial(), LightAttribute.INTENSITY.initial(),
                LightAttribute.POSITION.initial(), LightAttribute.DIRECTION.initial(), LightAttribute.ATTENUATION.initial(),
                LightAttribute.ANGLE.initial(), LightAttribute.DROPOFF.initial(), LightAttribute.DOORS.initial(),
                LightAttribute.FEATHER.initial(), LightAttribute.GOBO.initial(), LightAttribute.PROFILE.initial(), AreaShape.DEFAULT,
                LightAttribute.ON.initial(),
                LightAttribute.SOLO.initial(), LightAttribute.LIGHT_GROUP.initial(), LightAttribute.ILLUMINATES.initial(),
                LightAttribute.SHADOWED_BY.initial());
    }

    /** Color times intensity, with which all that the light adds is multiplied while it shines. */
    public Rgb weight() {
        return color.times(intensity);
    }

    /** Whether it is larger than a point, so that its shadows are soft. */
    public boolean isArea() {
        return switch (type) {
            case DIRECTIONAL -> area.spread() > 0;
            case POINT, SPOT, DISC -> area.radius() > 0;
            case RECT -> area.width() > 0 || area.height() > 0;
        };
    }

    /** Whether it shines on some shapes only, or only some throw shadows in its light. */
    public boolean isLinked() {
        return !illuminates.isAll() || !shadowedBy.isAll();
    }

    /** This light with other links of both kinds. */
    Light mapLinks(UnaryOperator<ShapeLinks> links) {
        ShapeLinks illuminated = links.apply(illuminates);
        ShapeLinks shadowing = links.apply(shadowedBy);
        return illuminated == illuminates && shadowing == shadowedBy ? this : withIlluminates(illuminated).withShadowedBy(shadowing);
    }
}
