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
    boolean canChange(int state) {
        return switch (this) {
            case NONE -> false;
            case ANGLE_REMOVE -> state == LightRows.LIT || state == LightRows.SHADOWED;
            case ANGLE_ADD -> state == LightRows.OUTSIDE_CONE;
            case LINKS, TURN -> state != LightRows.FACING_AWAY;
        };
    }

    /**
     * Puts the rows that may change into a set.
     *
     * @param states see {@link LightRows}
     * @return how many they are
     */
    int findAffectedRows(byte[] states, int rows, int[] candidates) {
        if (this == NONE) {
            return 0;
        }
        int stateMask = 0;
        for (int state = 0; state <= LightRows.STATE_MASK; state++) {
            stateMask |= canChange(state) ? 1 << state : 0;
        }
        RowBits.selectStates(states, rows, stateMask, candidates);
        return RowBits.count(candidates, rows);
    }
}
