package lightning.scene.light;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.Optional;
import lightning.scene.asset.Gobo;
import lightning.scene.asset.IesProfile;
import lightning.scene.attribute.NumericKind;
import lightning.scene.value.BarnDoors;
import lightning.scene.value.SceneLimits;

/**
 * Directions in which a light shines, and how strongly. The light's type decides which values act; {@link LightAttribute} has their units.
 *
 * @param angle   half-angle of a spot's cone, degrees
 * @param dropoff exponent of a spot's falloff from its axis; of a rectangle or disc, one is added
 * @param beam    cone and spread of a rectangle or disc
 * @param doors   barn doors of a light with a position and a direction
 * @param feather width of the soft edge of its doors, degrees
 * @param gobo    image that it projects
 * @param profile measured distribution of a light with a position
 */
@RecordBuilder
public record Cone(double angle, double dropoff, Beam beam, BarnDoors doors, double feather, Optional<Gobo> gobo,
        Optional<IesProfile> profile)
        implements ConeBuilder.With {
    static final NumericKind<Double> ANGLES = NumericKind.degrees(0, SceneLimits.MAX_ANGLE, 1);
    static final NumericKind<Double> DROPOFFS = NumericKind.number(0, SceneLimits.MAX_DROPOFF, 0.1);
    static final NumericKind<Double> FEATHERS = NumericKind.degrees(0, SceneLimits.MAX_FEATHER, 1);

    /** Initial values of a light. */
    public static final Cone DEFAULT = new Cone(30, 0, Beam.OPEN, BarnDoors.OPEN, 0, Optional.empty(), Optional.empty());

    /** @throws IllegalArgumentException if a value is out of range; the message says which */
    public Cone {
        ANGLES.check("angle", angle);
        DROPOFFS.check("dropoff", dropoff);
        FEATHERS.check("feather", feather);
    }
}
