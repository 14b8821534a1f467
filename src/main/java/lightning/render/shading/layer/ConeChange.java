package lightning.render.shading.layer;

/** Effect of an edit on the set of rows inside a light's cone while the light does not move. It determines which rows must be tested. */
public enum ConeChange {
    /** No change. */
    NONE,
    /** Rows may only leave: rows inside are tested (paper §4.3). */
    ANGLE_REMOVE,
    /** Rows may only enter: rows outside are tested (paper §4.3). */
    ANGLE_ADD,
    /** The light's links changed: all rows that face the light are tested. */
    LINKS,
    /** The cone turned, appeared or disappeared: all rows that face the light are tested. */
    TURN;

    /** Returns whether a row in the given state may change; see {@link LightRows}. */
    boolean canChange(int state) {
        return switch (this) {
            case NONE -> false;
            case ANGLE_REMOVE -> state == LightRows.LIT || state == LightRows.SHADOWED;
            case ANGLE_ADD -> state == LightRows.OUTSIDE_CONE;
            case LINKS, TURN -> state != LightRows.FACING_AWAY;
        };
    }

    /**
     * Collects the rows that may change.
     *
     * @param states see {@link LightRows}
     * @return the number of these rows
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
