package lightning.render.shading;

/**
 * One of the films that add up to a picture.
 *
 * @param kind   what it shows
 * @param index  number of its light or environment in the scene; 0 for others
 * @param weight factor with which it is added
 * @param inside weight that it contains: 1, or in weighted {@link FilmParts} its own, which then is not added
 * @param from   first of its lights among all lights that are rendered
 * @param to     after its last light
 */
public record FilmPart(Kind kind, int index, LightWeight weight, LightWeight inside, int from, int to) {
    /** Kind of the light that a film shows. */
    public enum Kind {
        /** Light of a light, with its bulbs and its face. */
        LIGHT,
        /** Light of an environment: of its small bright parts, and of the others as far as it is gathered. */
        ENVIRONMENT_LIGHT,
        /** Image of an environment. */
        ENVIRONMENT_IMAGE,
        /** Ambient light. */
        AMBIENCE,
        /** Light that no weight changes: glow without a bulb, the color of the background, and ambient light of fog. */
        REST
    }

    /** Returns whether it adds nothing. */
    public boolean isDark() {
        return weight.isZero();
    }
}
