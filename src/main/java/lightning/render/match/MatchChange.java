package lightning.render.match;

import lightning.base.text.Messages;

/** What a match may change of a light besides its intensity. */
public enum MatchChange {
    COLORS(Messages.key("Colors")),
    /** Color temperatures of lights; of no effect on lights that change their colors. */
    TEMPERATURES(Messages.key("Temperatures")),
    /** Rotation of the environment about the vertical axis. */
    ROTATION(Messages.key("Environment Rotation")),
    POSITIONS(Messages.key("Positions")),
    DIRECTIONS(Messages.key("Directions")),
    /** Cone angles of spots, and of rectangles and discs that have a cone. */
    CONES(Messages.key("Cones"));

    private final String title;

    MatchChange(String title) {
        this.title = title;
    }

    /** Returns the name that a user sees, translated. */
    public String title() {
        return Messages.tr(title);
    }

    /** Returns whether it is found step by step, each with a render of the scene at a small size. */
    boolean isSearched() {
        return this != COLORS;
    }
}
