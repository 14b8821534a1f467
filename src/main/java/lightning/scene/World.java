package lightning.scene;

import java.util.List;
import lightning.math.Rgb;

/**
 * What surrounds the shapes.
 *
 * @param ambience   the factor on every material's ambient colour, ≥ 0
 * @param background the linear colour where a ray hits nothing, ≥ 0
 */
public record World(double ambience, Rgb background) {
    public static final Attribute<World, Double> AMBIENCE = new Attribute<>("ambience", "ambience",
            Quantity.number(0, Limits.MAX_AMBIENCE, 0.1), 1.0, "", World::ambience, World::withAmbience);
    public static final Attribute<World, Rgb> BACKGROUND = new Attribute<>("background", "background",
            Quantity.color(Limits.MAX_EMISSION), Rgb.BLACK, "linear red, green, blue", World::background, World::withBackground);

    /** All of them, in the order in which a file writes them. */
    public static final List<Attribute<World, ?>> ATTRIBUTES = List.of(AMBIENCE, BACKGROUND);

    public static final World DEFAULT = new World(AMBIENCE.initial(), BACKGROUND.initial());

    public World {
        AMBIENCE.check(ambience);
        BACKGROUND.check(background);
    }

    public World withAmbience(double newAmbience) {
        return new World(newAmbience, background);
    }

    public World withBackground(Rgb newBackground) {
        return new World(ambience, newBackground);
    }
}
