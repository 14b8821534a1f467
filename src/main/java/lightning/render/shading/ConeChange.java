package lightning.render.shading;

/**
 * What an edit does to the set of rows inside a light's cone, of shapes that it shines on, while the light stays where it is; and
 * so, which rows must be looked at.
 */
public enum ConeChange {
    /** The same rows stay inside. */
    NONE,
    /** Rows may only leave: those inside are looked at (paper §4.3). */
    ANGLE_REMOVE,
    /** Rows may only enter: those outside are looked at (paper §4.3). */
    ANGLE_ADD,
    /** The light shines on other shapes, whatever the opening: all rows that face the light are looked at. */
    LINKS,
    /** The cone turned, came or went: all rows that face the light are looked at. */
    TURN;

    /** Whether a row in the given state, see {@link LightRows}, may change. */
    boolean looksAt(int state) {
        return switch (this) {
            case NONE -> false;
            case ANGLE_REMOVE -> state == LightRows.LIT || state == LightRows.SHADOWED;
            case ANGLE_ADD -> state == LightRows.OUTSIDE;
            case LINKS, TURN -> state != LightRows.AWAY;
        };
    }

    /**
     * Puts the rows that may change into a set.
     *
     * @param states see {@link LightRows}
     * @return how many they are
     */
    int looksAt(byte[] states, int rows, int[] looked) {
        if (this == NONE) {
            return 0;
        }
        int which = 0;
        for (int state = 0; state <= LightRows.STATE; state++) {
            which |= looksAt(state) ? 1 << state : 0;
        }
        RowBits.inStates(states, rows, which, looked);
        return RowBits.count(looked, rows);
    }
}
